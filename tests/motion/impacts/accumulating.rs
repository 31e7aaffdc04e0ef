//! Bounces that become ever smaller: the run ends where their times accumulate, and nothing goes through what it bounces on.

use sim::{Settings, What};
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
