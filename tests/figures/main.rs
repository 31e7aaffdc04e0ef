//! Figures, written to files.

#![allow(clippy::unwrap_used)]

use std::f64::consts::{PI, TAU};
use std::fs;
use std::path::{Path, PathBuf};

use sim::show::{Curve, Length, Plot, Pose, Positions, Shapes, ShowError, Size, figures, mechanism, path, plot};
use sim::{Compiled, Settings, Table, declared_start, run};
use sim_kernel::Shape;

fn directory(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

fn svg(directory: &Path, name: &str) -> String {
    fs::read_to_string(directory.join(format!("{name}.svg"))).unwrap()
}

fn png(directory: &Path, name: &str) -> Vec<u8> {
    fs::read(directory.join(format!("{name}.png"))).unwrap()
}

/// Draws a mechanism that moves in time, in metres.
fn drawn(title: &str, shapes: Shapes, poses: &[Pose], directory: &Path, name: &str) -> Result<(), ShowError> {
    let positions = Positions { title, shapes, unit: Length::METRE, heading: "t [s]", poses, motion: &[] };
    mechanism(&positions, Size::default(), directory, name)
}

fn times(until: f64) -> Vec<f64> {
    (0..=8192).map(|step| until * f64::from(step) / 8192.0).collect()
}

fn curve<'a>(label: &'a str, x: &[f64], value: impl Fn(f64) -> f64) -> Curve<'a> {
    Curve { label, values: x.iter().map(|x| value(*x)).collect() }
}

fn one<'a>(x: &'a [f64], label: &'a str, value: impl Fn(f64) -> f64) -> Plot<'a> {
    Plot { title: "", x_label: "time [s]", y_label: label, x, curves: vec![curve(label, x, value)] }
}

fn sines(x: &[f64]) -> Plot<'_> {
    let curves = vec![
        curve("crank_speed", x, |t| 5.0 + 3.0 * (TAU * t).sin()),
        curve("rocker_speed", x, |t| 4.0 * (TAU * 1.5 * t + 1.0).sin()),
        curve("bar_speed", x, |t| -1.5 * (TAU * 0.5 * t).cos()),
    ];
    Plot { title: "Angular speeds", x_label: "time [s]", y_label: "angular speed [rad/s]", x, curves }
}

const QUICK_RETURN: Shapes = plane(&[
    Shape::Ground(2),
    Shape::Line(2),
    Shape::Line(2),
    Shape::Line(2),
    Shape::Slider,
    Shape::Slider,
    Shape::Points(3),
]);

const fn plane(shapes: &[Shape]) -> Shapes<'_> {
    Shapes { dimension: 2, shapes }
}

fn quick_return(crank: f64) -> Vec<f64> {
    let pin = (0.2 * crank.cos(), 0.3 + 0.2 * crank.sin());
    let rocker = pin.1.atan2(pin.0);
    let end = (0.7 * rocker.cos(), 0.7 * rocker.sin());
    let bar = PI - ((0.9 - end.1) / 0.6).asin();
    let slider = (end.0 + 0.6 * bar.cos(), 0.9);
    let middle = |a: (f64, f64), b: (f64, f64)| [(a.0 + b.0) / 2.0, (a.1 + b.1) / 2.0];
    let mut numbers = vec![0.0, 0.0, 0.0, 0.3];
    numbers.extend([0.0, 0.3, pin.0, pin.1]);
    numbers.extend([0.0, 0.0, end.0, end.1]);
    numbers.extend([end.0, end.1, slider.0, slider.1]);
    numbers.extend([pin.0, pin.1, rocker, slider.0, slider.1, 0.0]);
    numbers.extend(middle((0.0, 0.0), end));
    numbers.extend(middle(end, slider));
    numbers.extend([slider.0, slider.1]);
    numbers
}

#[test]
fn curves_make_small_repeatable_files() {
    let directory = directory("curves");
    let x = times(2.0);
    plot(&sines(&x), &directory, "sines").unwrap();
    let (first, pixels) = (svg(&directory, "sines"), png(&directory, "sines"));
    assert!(first.len() < 200_000, "{} bytes", first.len());
    assert!(first.contains("font-family=\"Roboto, sans-serif\"") && first.contains("angular speed [rad/s]"));
    assert!(first.contains("width=\"960\" height=\"540\" viewBox=\"0 0 960 540\""));
    assert_eq!(&pixels[16..24], [1920_u32.to_be_bytes(), 1080_u32.to_be_bytes()].concat());
    plot(&sines(&x), &directory, "sines").unwrap();
    assert_eq!((svg(&directory, "sines"), png(&directory, "sines")), (first, pixels));

    plot(&one(&x, "power [W]", |t| 2.5e4 * (9.0 * t).sin() / (1.0 + t)), &directory, "power").unwrap();
    assert!(svg(&directory, "power").contains("20\u{2009}000"));
    plot(&one(&x, "acceleration [m/s^2]", |t| 3.3e7 * (t * t * 9.0).sin()), &directory, "large").unwrap();
    let large = svg(&directory, "large");
    assert!(large.contains("×10⁶") && large.contains("[m/s²]"));
}

#[test]
fn the_worst_curves_stay_bounded() {
    let directory = directory("worst");
    let x = times(2.0);
    let noise = |t: f64| (t * 1e6).sin() * (t * 1.3e5).cos();
    plot(&one(&x, "noise [N]", noise), &directory, "noise").unwrap();
    assert!(svg(&directory, "noise").len() < 200_000);

    let mut many = sines(&x);
    let labels: Vec<String> =
        (0..18).map(|index| format!("a_rather_long_name_of_an_output_{index} [kg*m^2/s]")).collect();
    many.curves =
        labels.iter().zip(0..).map(|(label, k)| curve(label, &x, |t| (t * 3.0 + f64::from(k)).sin() * 1e-6)).collect();
    plot(&many, &directory, "many").unwrap();
    assert!(svg(&directory, "many").len() < 900_000);
}

#[test]
fn degenerate_curves_are_shown() {
    let directory = directory("degenerate");
    let x = times(2.0);
    plot(&one(&x, "constant [J]", |_| 12.5), &directory, "constant").unwrap();
    plot(&one(&x, "nearly constant [J]", |t| 12.345_678 + 1e-9 * (9.0 * t).sin()), &directory, "nearly").unwrap();
    plot(&one(&x, "zero [J]", |_| 0.0), &directory, "zero").unwrap();
    let gaps = |t: f64| match () {
        () if (0.5..0.7).contains(&t) => f64::NAN,
        () if t > 1.8 => f64::INFINITY,
        () => (9.0 * t).sin(),
    };
    plot(&one(&x, "gaps [N]", gaps), &directory, "gaps").unwrap();
    let gaps = svg(&directory, "gaps");
    assert!(!gaps.contains("NaN") && !gaps.contains("inf"));
    plot(&one(&[0.0], "one value [N]", |_| 3.0), &directory, "lone").unwrap();
    plot(&one(&[0.0, 1.0], "huge [N]", |t| (t - 0.5) * 1.9e300), &directory, "huge").unwrap();
}

#[test]
fn nothing_to_show_is_an_error() {
    let directory = directory("nothing");
    let x = times(1.0);
    let none = Plot { curves: Vec::new(), ..sines(&x) };
    assert!(matches!(plot(&none, &directory, "none"), Err(ShowError::Empty { .. })));
    assert!(matches!(plot(&one(&[], "f", |t| t), &directory, "empty"), Err(ShowError::Empty { .. })));
    assert!(matches!(plot(&one(&x, "f", |_| f64::NAN), &directory, "nan"), Err(ShowError::Empty { .. })));
    let mut short = sines(&x);
    short.curves[1].values.pop();
    let error = plot(&short, &directory, "short").unwrap_err();
    assert_eq!(error.to_string(), "figure `short`: curve `rocker_speed` has 8192 values for 8193 abscissae");
    let empty = |shapes: Shapes, poses: &[Pose]| drawn("", shapes, poses, &directory, "empty");
    assert!(matches!(empty(QUICK_RETURN, &[]), Err(ShowError::Empty { .. })));
    assert!(matches!(empty(plane(&[]), &[Pose { numbers: &[], at: 0.0 }]), Err(ShowError::Empty { .. })));
    let nan = Pose { numbers: &[f64::NAN; 3], at: 0.0 };
    assert!(matches!(empty(plane(&[Shape::Slider]), &[nan]), Err(ShowError::Empty { .. })));
    let error = empty(plane(&[Shape::Slider]), &[Pose { numbers: &[0.0; 4], at: 1.5 }]).unwrap_err();
    assert_eq!(error.to_string(), "figure `empty`: the pose at 1.5 has 4 numbers, its shapes take 3");
    assert!(!directory.exists());
}

#[test]
fn a_file_in_the_way_is_an_error() {
    let directory = directory("in_the_way");
    fs::create_dir_all(&directory).unwrap();
    let file = directory.join("file");
    fs::write(&file, "").unwrap();
    let x = times(1.0);
    let error = plot(&sines(&x), &file.join("below"), "sines").unwrap_err();
    assert!(error.to_string().contains("in_the_way/file/below"), "{error}");
    fs::create_dir_all(directory.join("taken.png")).unwrap();
    let error = plot(&sines(&x), &directory, "taken").unwrap_err();
    assert!(error.to_string().contains("taken.png"), "{error}");
}

#[test]
fn a_mechanism_moves() {
    let directory = directory("mechanism");
    let numbers: Vec<_> = (0..6).map(|sixth| quick_return(0.4 + TAU * f64::from(sixth) / 6.0)).collect();
    let pose = |(numbers, sixth)| Pose { numbers, at: 0.109_89 * f64::from(sixth) };
    let poses: Vec<Pose> = numbers.iter().map(Vec::as_slice).zip(0..).map(pose).collect();
    drawn("Quick-return mechanism", QUICK_RETURN, &poses, &directory, "quick-return").unwrap();
    let first = svg(&directory, "quick-return");
    assert!(first.contains("0.33") && first.contains("x [m]") && first.contains("t [s]"));
    drawn("Quick-return mechanism", QUICK_RETURN, &poses, &directory, "quick-return").unwrap();
    assert_eq!(svg(&directory, "quick-return"), first);
}

#[test]
fn odd_drawings_are_drawn() {
    let directory = directory("odd");
    let flat: Vec<[f64; 11]> = (0..30)
        .map(|step| 0.001 * f64::from(step))
        .map(|x| [0.0, 0.0, x, 0.0, 0.1, 0.0, x, 0.0, 0.0, 0.1, 0.0])
        .collect();
    let poses: Vec<Pose> = flat.iter().zip(0..).map(|(numbers, step)| Pose { numbers, at: f64::from(step) }).collect();
    let shapes = [Shape::Line(3), Shape::Slider, Shape::Ground(1)];
    drawn("A row of masses", plane(&shapes), &poses, &directory, "flat").unwrap();
    let point = Pose { numbers: &[1.0, 2.0], at: 0.0 };
    drawn("", plane(&[Shape::Points(1)]), &[point], &directory, "point").unwrap();
    let wheel = [0.0, 1.0, 1.0, 0.0, 1.0, f64::NAN, 1.0, 0.7, 1.7, 0.0, 1.0];
    let wheel = Pose { numbers: &wheel, at: 0.0 };
    drawn("Wheel", plane(&[Shape::Circle, Shape::Line(3), Shape::Points(1)]), &[wheel], &directory, "wheel").unwrap();
}

#[test]
fn what_stands_in_space_has_a_scale_and_its_axes() {
    let directory = directory("space");
    let shapes = [Shape::Ground(1), Shape::Line(2), Shape::Circle, Shape::Slider, Shape::Spring, Shape::Damper];
    let pose = |angle: f64| {
        let tip = [0.4 * angle.cos(), 0.4 * angle.sin(), 0.3];
        let mut numbers = vec![0.0; 3];
        numbers.extend([0.0, 0.0, 0.0].iter().chain(&tip));
        numbers.extend(tip.iter().chain(&[0.1]).chain(&tip));
        numbers.extend([0.0, 0.0, 0.5, 0.0, 0.0, 1.0]);
        numbers.extend([0.0, 0.0, 0.5].iter().chain(&tip));
        numbers.extend([0.3, 0.3, 0.0].iter().chain(&tip));
        numbers
    };
    let numbers: Vec<Vec<f64>> = (0..3).map(|turn| pose(f64::from(turn))).collect();
    let poses: Vec<Pose> = numbers.iter().zip(0..).map(|(numbers, t)| Pose { numbers, at: f64::from(t) }).collect();
    let space = Shapes { dimension: 3, shapes: &shapes };
    drawn("A wheel on an arm", space, &poses, &directory, "space").unwrap();
    let drawn = svg(&directory, "space");
    assert!(drawn.contains(">0.1 m<") && [">x<", ">y<", ">z<"].iter().all(|axis| drawn.contains(axis)));
    assert!(!drawn.contains("x [m]"));
}

/// Width and height of the lines that are so wide, on the sheet.
fn extent(svg: &str, stroke: &str) -> (f64, f64) {
    let lines = svg.lines().filter(|line| line.contains(&format!("stroke-width=\"{stroke}\"")));
    let places = lines.filter_map(|line| line.split('"').nth(1)).flat_map(|points| points.split(' '));
    let points: Vec<(f64, f64)> = places
        .map(|place| place.split_once(',').unwrap())
        .map(|(x, y)| (x.parse().unwrap(), y.parse().unwrap()))
        .collect();
    range(&points)
}

/// Width and height of points.
fn range(points: &[(f64, f64)]) -> (f64, f64) {
    let extent = |part: fn(&(f64, f64)) -> f64| {
        let (low, high) = points
            .iter()
            .map(part)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        high - low
    };
    (extent(|point| point.0), extent(|point| point.1))
}

/// The middle of the coupler, by intersecting circles.
fn coupler_point(machine: &models::FourBar, crank: f64) -> (f64, f64) {
    let &models::FourBar { a, b, c, d, .. } = machine;
    let pin = (a * crank.cos(), a * crank.sin());
    let (x, y) = (d - pin.0, -pin.1);
    let apart = x.hypot(y);
    let along = (b * b - c * c + apart * apart) / (2.0 * apart);
    let across = (b * b - along * along).sqrt();
    let end = (pin.0 + (along * x - across * y) / apart, pin.1 + (along * y + across * x) / apart);
    ((pin.0 + end.0) / 2.0, (pin.1 + end.1) / 2.0)
}

#[test]
fn the_path_of_a_coupler_point_is_drawn() {
    let directory = directory("traced");
    let machine = models::FourBar::defaults();
    let found = run(machine, &declared_start(&machine), &Settings::new(2.0)).unwrap();
    let table = Table::of(&found.mechanism, &found.trajectory);
    let figures = figures(&found, &table, &directory, Size::default().into());
    assert!(figures.failures.is_empty(), "{:?}", figures.failures);
    let drawn = svg(&directory, "mechanism");
    assert!(drawn.contains(">four-bar in 6 positions<") && drawn.contains(">x [m]<"), "{drawn}");
    let path: Vec<(f64, f64)> = (0..720).map(|half| coupler_point(&machine, f64::from(half) * PI / 360.0)).collect();
    let (expected, traced) = (range(&path), extent(&drawn, "1.5"));
    assert!((traced.0 / traced.1 - expected.0 / expected.1).abs() < 0.01, "{traced:?} {expected:?}");
}

#[test]
fn a_path_is_drawn_to_one_scale() {
    let directory = directory("path");
    let turns: Vec<f64> = (0..=360).map(|turn| f64::from(turn) * PI / 180.0).collect();
    let x: Vec<f64> = turns.iter().map(|turn| turn.cos()).collect();
    let curves = vec![curve("y [mm]", &turns, |turn| 1000.0 * turn.sin())];
    let circle = Plot { title: "", x_label: "x [m]", y_label: "y [mm]", x: &x, curves };
    path(&circle, 1e-3, Size::default(), &directory, "circle").unwrap();
    let (width, height) = extent(&svg(&directory, "circle"), "2");
    assert!((width - height).abs() < 1.0 && height > 300.0, "{width} {height}");
}
