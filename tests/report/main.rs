//! Reports as a reader meets them: in a browser, from a file.

#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used)]

mod browser;
mod watch;

use browser::Browser;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Where pictures are kept: `LINKWRIGHT_SCREENSHOTS`, or beside the build.
fn pictures() -> PathBuf {
    let place = std::env::var_os("LINKWRIGHT_SCREENSHOTS").map(PathBuf::from);
    let place = place.unwrap_or_else(|| scratch("screenshots"));
    fs::create_dir_all(&place).unwrap();
    place
}

fn scratch(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

fn sim(words: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_sim")).args(words).output().unwrap();
    assert!(output.status.success(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The shipped mechanisms, and how long each is run.
fn models() -> Vec<(String, &'static str)> {
    let list: Value = serde_json::from_str(&sim(&["list", "--json"])).unwrap();
    let names = list.as_array().unwrap().iter().map(|model| model["name"].as_str().unwrap().to_owned());
    // What Andrews' mechanism does later is of no interest.
    names.map(|name| if name == "andrews" { (name, "30ms") } else { (name, "2s") }).collect()
}

/// A run of a model, with report, figures and what `info` says. Tests run side by side, each in a folder of its own.
fn made(test: &str, model: &str, t_end: &str) -> PathBuf {
    let directory = scratch("reports").join(test).join(model);
    let _ = fs::remove_dir_all(&directory);
    sim(&["run", model, "--t-end", t_end, "--out", directory.to_str().unwrap(), "--quiet"]);
    assert!(sim(&["info", model]).contains("Operations of each kernel"));
    assert!(directory.join("mechanism.png").exists());
    directory.join("report.html")
}

/// Colours on the canvas, and a number that changes with any of its pixels.
const PIXELS: &str = "(() => {
    const canvas = document.getElementById('drawing');
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext('2d', { willReadFrequently: true });
    context.drawImage(canvas, 0, 0);
    const pixels = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
    const counts = new Map();
    let sum = 0;
    for (const pixel of pixels) {
        counts.set(pixel, (counts.get(pixel) || 0) + 1);
        sum = (31 * sum + pixel) % 4294967291;
    }
    const most = Math.max(...counts.values());
    return [pixels.length - most, sum];
})()";

/// Moves the scrubber as a reader does.
const SCRUB: &str = "(() => {
    const scrubber = document.getElementById('scrubber');
    scrubber.value = 370;
    scrubber.dispatchEvent(new Event('input'));
})()";

/// Where the cursor of the first plot is, and the values beside all curves.
const CURSOR: &str = "[document.querySelector('.now').style.transform,
    [...document.querySelectorAll('.legend .value')].map((value) => value.textContent).join()]";

/// What is wider than the room it has.
const WIDER: &str = "[...document.querySelectorAll('.card, .scroll, .equations .row, pre')]
    .filter((part) => part.scrollWidth > part.clientWidth + 1).map((part) => part.className || part.tagName).join()";

#[test]
#[ignore = "needs Chromium; .ci/run installs it and runs this"]
fn every_other_report_moves_in_a_browser() {
    reports_move(0);
}

#[test]
#[ignore = "needs Chromium; .ci/run installs it and runs this"]
fn the_reports_between_move_in_a_browser() {
    reports_move(1);
}

/// Looks at every second report from one on, or at every sixth in a debug build: two browsers do it side by side.
fn reports_move(first: usize) {
    let mut browser = Browser::start(&scratch(&format!("chromium-{first}")));
    let step = if cfg!(debug_assertions) { 6 } else { 2 };
    for (model, t_end) in models().into_iter().skip(first).step_by(step) {
        let report = made("every", &model, t_end);
        let bytes = fs::metadata(&report).unwrap().len();
        assert!(bytes < 2_000_000, "{model}: {bytes} bytes");
        browser.window(1400, 1000, 1.0, false);
        browser.open(&report, "#t=0");
        let ready = browser.evaluate("document.documentElement.dataset.ready");

        // Some outputs never change, but then a coordinate does.
        browser.evaluate(
            "document.querySelectorAll('.plot details').forEach((details) => (details.open = true)), scrollTo(0, 0)",
        );
        browser.settle();
        let (drawn, first) = (browser.evaluate(PIXELS), browser.evaluate(CURSOR));
        assert!(drawn[0].as_u64().unwrap() > 500, "{model}: the canvas is empty, {drawn}");
        browser.evaluate(SCRUB);
        browser.settle();
        let (later, second) = (browser.evaluate(PIXELS), browser.evaluate(CURSOR));
        assert_ne!(drawn[1], later[1], "{model}: scrubbing does not move the drawing");
        assert_ne!(first[0], second[0], "{model}: scrubbing does not move the cursor");
        assert_ne!(first[1], second[1], "{model}: scrubbing changes no value beside a curve");
        let time = browser.evaluate("report.player.time / (document.getElementById('scrubber').value / 1000)");
        assert!(time.as_f64().unwrap() > 0.0);

        browser.open(&report, "#t=0.37");
        browser.screenshot(&pictures().join(format!("{model}.png")));
        let drawing = "frameCost";
        let cost = browser.evaluate(&format!("report.{drawing}(101, false)"));
        println!("{model:<20} {:>7.3} MB  loaded in {ready} ms, a frame takes {cost} ms (median)", bytes as f64 / 1e6);
        browser.window(390, 844, 2.0, true);
        browser.open(&report, "#t=0");
        assert!(browser.evaluate("report.isDark()").as_bool().unwrap());
        let wide = browser.evaluate("document.documentElement.scrollWidth");
        assert!(wide.as_u64().unwrap() <= 390, "{model}: {wide} pixels wide on a phone");
        browser.screenshot(&pictures().join(format!("{model}-phone-dark.png")));

        assert!(browser.complaints.is_empty(), "{model}: {:?}", browser.complaints);
        let outside: Vec<&String> = browser.requests.iter().filter(|url| !url.starts_with("file:")).collect();
        assert!(outside.is_empty(), "{model}: {outside:?}");
    }
}

/// The report of a sweep: what is driven is on the clock, under the slider and along the plots, also where it falls.
#[test]
#[ignore = "needs Chromium; .ci/run installs it and runs this"]
fn a_sweep_shows_what_is_driven() {
    let mut browser = Browser::start(&scratch("chromium-sweep"));
    let sweeps: [(&str, &[&str], [f64; 3], &str); 3] = [
        ("quick-return", &["--drive", "alpha", "--from", "0", "--to", "360deg"], [0.0, 1.0, 6.0], "alpha = 1.000 rad"),
        ("slider-crank", &["--drive", "x", "--from", "0.5", "--to", "0.4"], [0.5, 0.42, 0.4], "x = 0.4200 m"),
        ("four-bar", &["--from", "1", "--to", "-1", "--speed", "0"], [1.0, -0.5, -1.0], "theta2 = \u{2212}0.500 rad"),
    ];
    for (model, words, [from, place, last], clock) in sweeps {
        let directory = scratch("reports").join("sweep").join(model);
        let _ = fs::remove_dir_all(&directory);
        sim(&[&["kinematics", model, "--out", directory.to_str().unwrap(), "--quiet"], words].concat());
        let report = directory.join("report.html");
        browser.window(1400, 1000, 1.0, false);
        browser.open(&report, &format!("#t={place}"));
        assert_eq!(browser.evaluate("document.getElementById('clock').textContent"), clock);
        let driven = browser.evaluate(
            "report.plots[0].chart.axes[0].values(report.plots[0].chart, report.plots[0].chart.axes[0].splits(report.plots[0].chart, 0, report.plots[0].chart.scales.x.min, report.plots[0].chart.scales.x.max))",
        );
        let ticks: Vec<f64> = driven
            .as_array()
            .unwrap()
            .iter()
            .map(|text| text.as_str().unwrap().replace('\u{2212}', "-").parse().unwrap())
            .collect();
        assert!((ticks[0] - from).abs() < 1e-9 && (ticks[ticks.len() - 1] - last).abs() < 1e-9, "{model}: {ticks:?}");
        browser.screenshot(&pictures().join(format!("sweep-{model}.png")));
        let (cursor, drawn) = (browser.evaluate(CURSOR), browser.evaluate(PIXELS));
        browser.key("Home");
        browser.settle();
        assert_ne!(cursor[0], browser.evaluate(CURSOR)[0], "{model}: the cursor does not move");
        assert_ne!(drawn[1], browser.evaluate(PIXELS)[1], "{model}: the drawing does not move");
        assert!(browser.complaints.is_empty(), "{model}: {:?}", browser.complaints);
    }
}

#[test]
#[ignore = "needs Chromium; .ci/run installs it and runs this"]
fn what_a_reader_does_has_its_effect() {
    let report = made("plane", "quick-return", "2s");
    let mut browser = Browser::start(&scratch("chromium-controls"));
    browser.window(1400, 1000, 1.0, false);
    browser.open(&report, "#t=0.25");
    let time = |browser: &mut Browser| browser.evaluate("report.player.shown()").as_f64().unwrap();
    assert_eq!(time(&mut browser), 0.25);

    // Play, and pause.
    let play = browser.place("#play", 0.5);
    browser.drag(play, play);
    std::thread::sleep(std::time::Duration::from_millis(300));
    browser.key(" ");
    assert!(!browser.evaluate("report.player.playing").as_bool().unwrap());
    let paused = time(&mut browser);
    assert!(paused > 0.25);
    // One sample on: rows are 2/1024 s apart.
    browser.key("ArrowRight");
    let step = time(&mut browser) - paused;
    assert!(step > 0.0 && step <= 2.0 / 1024.0 + 1e-12, "{step}");
    browser.key("Home");
    assert_eq!(time(&mut browser), 0.0);

    // A click in a plot goes to its time; dragging zooms all plots.
    let middle = browser.place(".u-over", 0.5);
    browser.drag(middle, middle);
    assert!((time(&mut browser) - 1.0).abs() < 0.01);
    let (from, to) = (browser.place(".u-over", 0.25), browser.place(".u-over", 0.75));
    browser.drag(from, to);
    let ranges = browser
        .evaluate("report.plots.filter((p) => p.chart).map((p) => [p.chart.scales.x.min, p.chart.scales.x.max])");
    for range in ranges.as_array().unwrap() {
        let (low, high) = (range[0].as_f64().unwrap(), range[1].as_f64().unwrap());
        assert!((low - 0.5).abs() < 0.02 && (high - 1.5).abs() < 0.02, "{ranges}");
    }
    browser.screenshot(&pictures().join("zoomed.png"));
    browser.key("0");
    assert_eq!(browser.evaluate("report.plots[0].chart.scales.x.max"), 2.0);

    // Two fingers three times as far apart show a third of the time, about its middle.
    let at = |browser: &mut Browser, share: f64| browser.place(".u-over", share);
    let from = [at(&mut browser, 0.4), at(&mut browser, 0.6)];
    let to = [at(&mut browser, 0.2), at(&mut browser, 0.8)];
    browser.pinch(from, to);
    let range = browser.evaluate("[report.plots[0].chart.scales.x.min, report.plots[0].chart.scales.x.max]");
    let (low, high) = (range[0].as_f64().unwrap(), range[1].as_f64().unwrap());
    assert!((low - 2.0 / 3.0).abs() < 0.03 && (high - 4.0 / 3.0).abs() < 0.03, "{range}");
    browser.key("0");

    // Hidden parts, traces and forces change the drawing, one by one.
    let mut before = browser.evaluate(PIXELS);
    for menu in ["parts", "traces", "forces"] {
        browser.evaluate(&format!("document.querySelector('#{menu} input').click()"));
        browser.settle();
        let after = browser.evaluate(PIXELS);
        assert_ne!(before[1], after[1], "{menu}");
        before = after;
    }
    browser.evaluate("document.querySelectorAll('#forces input[type=checkbox], #traces input').forEach((box) => box.checked || box.click())");
    browser.settle();
    browser.screenshot(&pictures().join("forces-and-traces.png"));
    browser.key("d");
    assert!(browser.evaluate("report.isDark()").as_bool().unwrap());
    browser.screenshot(&pictures().join("dark.png"));

    // The phase portrait, the tables, the equations, and paper.
    browser.evaluate("document.querySelectorAll('.plot details').forEach((details) => (details.open = true))");
    browser.place("#phase", 0.5);
    browser.settle();
    browser.screenshot(&pictures().join("phase.png"));
    assert!(browser.evaluate("document.querySelectorAll('.equations math').length").as_u64().unwrap() >= 7);
    browser.evaluate("document.querySelector('.tables').scrollIntoView()");
    browser.screenshot(&pictures().join("tables.png"));
    browser.evaluate("document.querySelector('.equations').scrollIntoView()");
    browser.screenshot(&pictures().join("equations.png"));
    let pdf = browser.printed();
    assert!(pdf > 20_000, "{pdf}");
    // A4 between its margins.
    browser.window(688, 1000, 1.0, false);
    browser.call("Emulation.setEmulatedMedia", serde_json::json!({ "media": "print" }));
    browser.evaluate("dispatchEvent(new Event('beforeprint'))");
    browser.settle();
    assert_eq!(browser.evaluate(WIDER), "", "paper does not scroll");
    assert!(browser.complaints.is_empty(), "{:?}", browser.complaints);
}

#[test]
#[ignore = "needs Chromium; .ci/run installs it and runs this"]
fn declared_traces_are_shown_until_they_are_switched_off() {
    let report = made("traced", "four-bar", "1s");
    let mut browser = Browser::start(&scratch("chromium-traces"));
    browser.window(1400, 1000, 1.0, false);
    browser.open(&report, "#t=0.1");
    assert_eq!(browser.evaluate("[...report.drawing.traced].join()"), "G3");
    let traced = browser.evaluate(PIXELS);
    browser.evaluate("document.querySelector('#traces input:checked').click()");
    browser.settle();
    assert_eq!(browser.evaluate("report.drawing.traced.size"), 0);
    assert_ne!(browser.evaluate(PIXELS)[1], traced[1], "no path was drawn");
    assert!(browser.complaints.is_empty(), "{:?}", browser.complaints);
}

#[test]
#[ignore = "needs Chromium; .ci/run installs it and runs this"]
fn what_stands_in_space_is_turned_by_the_mouse_and_comes_nearer_by_the_wheel() {
    let report = made("space", "top", "2s");
    let mut browser = Browser::start(&scratch("chromium-space"));
    browser.window(1400, 1000, 1.0, false);
    browser.open(&report, "#t=0.5");
    let first = browser.evaluate(PIXELS);
    let (from, to) = (browser.place("#drawing", 0.4), browser.place("#drawing", 0.7));
    let azimuth = browser.evaluate("report.drawing.view.azimuth").as_f64().unwrap();
    browser.drag(from, (to.0, to.1 + 60.0));
    let turned = browser.evaluate(PIXELS);
    assert_ne!(first[1], turned[1], "dragging does not turn it");
    // What was in front goes with the mouse: to the right, as the eye goes to the left.
    assert!(browser.evaluate("report.drawing.view.azimuth").as_f64().unwrap() < azimuth - 0.5);
    assert_eq!(browser.evaluate("report.drawing.traced.size"), 0, "dragging is no click");
    browser.screenshot(&pictures().join("turned.png"));
    let wheel = serde_json::json!({ "type": "mouseWheel", "x": from.0, "y": from.1, "deltaX": 0, "deltaY": -200 });
    browser.call("Input.dispatchMouseEvent", wheel);
    browser.settle();
    assert!(browser.evaluate("report.drawing.view.zoom").as_f64().unwrap() > 1.2);
    browser.key("v");
    assert_eq!(browser.evaluate(PIXELS)[1], first[1], "the first view comes back");
    browser.key(".");
    assert_ne!(browser.evaluate(PIXELS)[1], first[1], "keys turn it");
    assert!(browser.complaints.is_empty(), "{:?}", browser.complaints);
}
