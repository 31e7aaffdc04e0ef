//! Bounces that become ever smaller: the run ends where their times accumulate, and nothing goes through what it bounces on.

use sim::{Settings, State, What};
use tests::any_model::interpreted;
use tests::{Random, run_with};

/// A mass that is pushed onto a slider with a prescribed course, whose stop is 5 mm before it; all lengths and the force times a
/// scale.
fn pushed_onto_a_slider(random: &mut Random, scale: f64) -> String {
    let mut between = |least: f64, most: f64| random.between(least, most);
    let (rod, restitution, force) = (between(30.0, 45.0), between(0.1, 0.9), between(10.0, 40.0));
    let start = 10.0 + rod + 5.0 + between(2.0, 15.0);
    let length = |millimetres: f64| format!("{:e} [m]", 1e-3 * scale * millimetres);
    format!(
        "/// A mass on a slider.
        Pushed;
        coordinates {{ x [m]; u [m]; }}
        parameters {{ w [rad/s] = 100; m [g] = 50; }}
        let r = {}; let l = {}; let s = r*cos(w*t) + sqrt(l^2 - r^2*sin(w*t)^2);
        bodies {{ slider: mass m at [x, 0]; pushed: mass 2*m at [u, 0]; }}
        constraints {{ drive: x = s; touch: u - x = {} initially released; }}
        loads {{ force [-{:e} [N], 0] at [u, 0]; }}
        initial {{ guess x = {}; u = {}; dot(u) = 0; }}
        events {{ hit: u - x = {} falling {{ impact touch restitution {restitution}; }} }}",
        length(10.0),
        length(rod),
        length(5.0),
        scale * force,
        length(rod),
        length(start),
        length(5.0),
    )
}

/// Where a bounce is lost, its mass goes through the slider as if there were none.
#[test]
fn small_bounces_are_not_lost() {
    let (mut random, mut accumulating) = (Random(7), 0);
    for scale in [1e-3, 1.0, 1e3] {
        for _ in 0..25 {
            let declaration = pushed_onto_a_slider(&mut random, scale);
            let run = run_with(interpreted(&declaration).unwrap(), &Settings::new(0.12)).unwrap();
            for sample in &run.trajectory.samples {
                let gap = sample.state.positions[1] - sample.state.positions[0] - 5e-3 * scale;
                // Times of events are known to 1e-12 s, at speeds of 1 m/s, and rows to the tolerance of 1e-10.
                assert!(gap > -1e-9 * scale, "{gap:e} m at t = {} s\n{declaration}", sample.state.time);
            }
            match run.trajectory.failure.map(|failure| failure.what) {
                Some(What::Accumulating { event: "hit", .. }) => accumulating += 1,
                Some(what) => panic!("{what}\n{declaration}"),
                None => {}
            }
        }
    }
    assert!(accumulating > 50, "{accumulating} of 75");
}

/// A ball dropped from any height h ends where its bounces accumulate: after sqrt(2 h/g) (1 + e)/(1 - e), by the geometric series of
/// their durations.
#[test]
fn small_drops_do_not_go_through_the_floor() {
    for action in ["impact floor restitution k", "set dot(y) = -k*dot(y)"] {
        for height in [1.0, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
            for e in [0.3, 0.5, 0.9] {
                let run = run_with(
                    interpreted(&format!(
                        "pub Ball; coordinates {{ y [m]; }} parameters {{ k = {e}; }} bodies {{ ball: mass 1 [kg] at [0 [m], y]; }}
                        loads {{ gravity [0, -9.81 [m/s^2]]; }} constraints {{ floor: y = 0 initially released; }}
                        initial {{ y = {height}; }} events {{ bounce: y = 0 falling {{ {action}; }} }}"
                    ))
                    .unwrap(),
                    &Settings::new(20.0),
                )
                .unwrap();
                let failure = run.trajectory.failure.unwrap();
                assert!(matches!(failure.what, What::Accumulating { event: "bounce", .. }), "{}", failure.what);
                let end = f64::sqrt(2.0 * height / 9.81) * (1.0 + e) / (1.0 - e);
                // Bounces end below the tolerance of constraints, some 4e-12 m, and take 2e-6 s there; those to come are a
                // geometric series of 1/(1 - e) times the last.
                assert!((failure.time - end).abs() < 4e-6 / (1.0 - e), "{height} m, {e}: {} {end}", failure.time);
            }
        }
    }
}

/// What lies on a floor, or comes to rest there, and has no rebound does not go through it: forces would take it at once.
#[test]
fn what_rests_on_what_it_strikes_does_not_go_through() {
    let ball = "coordinates { y [m]; } parameters { e1 = 0.5; t0 [s] = 0; }
        bodies { b: mass 1 [kg] at [0, y]; } loads { gravity [0, -10 [m/s^2]]; }";
    let floor =
        "constraints { f: y = 0 initially released; } events { hit: y = 0 falling { impact f restitution e1; } }";
    let leaning = "coordinates { p [rad]; } parameters { e1 = 0.5; a [rad] = 0.5; }
        bodies { b: mass 1 [kg] at 1 [m]*[sin(p), -cos(p)]; } loads { gravity [0, -10 [m/s^2]]; } initial { p = a; }
        constraints { f: p = a initially released; } events { hit: p = a falling { impact f restitution e1; } }";
    let pressed = "coordinates { x [m]; y [m]; } parameters { e1 = 0.5; d [m] = 0.1; }
        bodies { a: mass 1 [kg] at [x, 0]; b: mass 1 [kg] at [y, 0]; } loads { force 5 [N] on x; }
        constraints { f: y - x = d initially released; } initial { x = 0; y = d; }
        events { hit: y - x = d falling { impact f restitution e1; } }";
    let cases = [
        ("lies", format!("{ball} initial {{ y = 0; }} {floor}")),
        (
            "is let go",
            format!(
                "{ball} initial {{ y = 0; }} {}",
                floor
                    .replace("initially released", "initially active")
                    .replace("events {", "events { rel: t = 0.1 [s] rising { release f; }")
            ),
        ),
        ("is lifted", format!("{ball} initial {{ y = 0; }} {}", floor.replace("y = 0", "y = 4 [m/s^2]*t^2/2"))),
        ("leans", leaning.to_owned()),
        ("is pressed", pressed.to_owned()),
    ];
    for (what, text) in cases {
        for restitution in [0.0, 0.5, 1.0] {
            let text = format!("pub Rests; {}", text.replace("e1 = 0.5", &format!("e1 = {restitution}")));
            let run = run_with(interpreted(&text).unwrap(), &Settings::new(1.0)).unwrap();
            let failure = run.trajectory.failure.map(|failure| failure.what);
            assert!(matches!(failure, Some(What::Accumulating { .. })), "{what} {restitution}: {failure:?}");
        }
    }
}

/// A blow on something else, where a condition comes from rest, is given once.
#[test]
fn a_blow_elsewhere_is_given_once() {
    let text = "pub Once; coordinates { x [m]; y [m]; } bodies { b: mass 1 [kg] at [x, y]; }
        loads { gravity [0, -10 [m/s^2]]; } constraints { wall: x = 0 initially released; }
        initial { x = 0; dot(x) = 1; y = 0; } events { falls: y = 0 falling { impact wall restitution 0.5; } }";
    let run = run_with(interpreted(text).unwrap(), &Settings::new(1.0)).unwrap();
    assert_eq!((run.trajectory.failure, run.events.len()), (None, 1));
    let State { positions, .. } = &run.trajectory.samples.last().unwrap().state;
    assert!((positions[0] + 0.5).abs() < 1e-9 && (positions[1] + 5.0).abs() < 1e-9, "{positions:?}");
}

/// A train stops for a moment, and goes on as it is pulled.
#[test]
fn what_is_set_to_rest_goes_on() {
    let text = "pub Train; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; } loads { force 2 [N] on x; }
        initial { x = 0; } events { station: x = 1 [m] rising { set dot(x) = 0; } }";
    let run = run_with(interpreted(text).unwrap(), &Settings::new(2.0)).unwrap();
    assert_eq!((run.trajectory.failure, run.events.len()), (None, 1));
    let State { positions, .. } = &run.trajectory.samples.last().unwrap().state;
    assert!((positions[0] - 2.0).abs() < 1e-9, "{positions:?}");
}
