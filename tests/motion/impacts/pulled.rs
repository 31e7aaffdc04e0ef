//! Contacts that a blow closes and that would have to pull from then on.

use super::all_settings;
use sim::{Run, Table, mechanism};
use tests::any_model::{AnyModel, run_with};

mechanism! {
    /// Two masses that fly against walls on either side, away from which they are pulled.
    Pulled;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 2; a [m/s^2] = 3; d [m] = 1; v [m/s] = 4; }
    bodies { left: mass m at [x, 0]; right: mass m at [y, d]; }
    loads { force [m*a, 0] at [x, 0]; force [-2*m*a, 0] at [y, d]; }
    constraints { lower: x = 0 initially released; upper: y = 0 initially released; }
    initial { x = d; y = -d; dot(x) = -v; dot(y) = v; }
    events {
        lower_hit: x = 0 falling { activate lower; }
        lower_leave: reaction(lower) = 0 rising { release lower; }
        upper_hit: y = 0 rising { activate upper; }
        upper_leave: reaction(upper) = 0 falling { release upper; }
    }
}

/// x = d - v t + a t^2/2 until it is 0, and from rest again a (t - t_hit)^2/2; y likewise with 2 a.
#[test]
fn what_is_pulled_away_from_a_wall_leaves_it_at_once() {
    for size in [1e-3, 1.0, 100.0] {
        let mechanism = Pulled { a: 3.0 * size, d: size, v: 4.0 * size, ..Pulled::default() };
        for settings in all_settings(1.0) {
            let run = run_with(mechanism, &settings).unwrap();
            assert_eq!(run.trajectory.failure, None);
            let last = run.trajectory.samples.last().unwrap();
            for (i, (a, sign)) in [(3.0, 1.0), (6.0, -1.0)].into_iter().enumerate() {
                let hit = (4.0 - f64::sqrt(16.0 - 2.0 * a)) / a;
                let expected = sign * a / 2.0 * (1.0 - hit) * (1.0 - hit);
                let found = last.state.positions[i] / size;
                assert!((found - expected).abs() < 1e-10, "{size} m: {found} {expected}");
                assert_eq!(last.multipliers[i], 0.0);
            }
            let names: Vec<&str> = run.events.iter().map(|event| event.name).collect();
            assert_eq!(names, ["lower_hit", "lower_leave", "upper_hit", "upper_leave"]);
        }
    }
}

mechanism! {
    /// A bar that lands on two supports, and is pulled away from then on.
    Bar;
    coordinates { y [m]; phi [rad]; }
    parameters { m [kg] = 1; J [kg*m^2] = 1/3; l [m] = 1; F [N] = 0; T [N*m] = 0; pull [N] = 5; turn [N*m] = 3; }
    let left = y - l*sin(phi);
    let right = y + l*sin(phi);
    bodies { bar: mass m at [0, y], inertia J, angle phi; }
    loads { force [0, F] at [0, y]; torque T on bar; }
    constraints { l_held: left = 0 initially released; r_held: right = 0 initially released; }
    initial { y = l/10; dot(y) = -l/1 [s]; }
    events {
        l_lands: left = 0 falling { activate l_held; }
        r_lands: right = 0 falling { activate r_held; set F = pull; set T = turn; }
        l_leaves: reaction(l_held) = 0 rising { release l_held; }
        r_leaves: reaction(r_held) = 0 rising { release r_held; }
    }
    outputs { l_end [m] = left; r_end [m] = right; l_push [N] = -reaction(l_held); turning [rad/s^2] = ddot(phi); }
}

/// Both supports would have to pull, by 1 N and by 4 N. Without them the left end would go down at 4 m/s^2. The left one alone
/// pushes: (J + m l^2) phi'' = T + F l about that end, and m l phi'' = F + 1 N. So in any size, and under a thousandth of the load.
#[test]
fn of_two_supports_that_would_pull_the_one_that_pushes_stays() {
    for (l, load) in [(1e-3, 1.0), (1.0, 1.0), (100.0, 1.0), (1e-3, 1e-3), (1.0, 1e-3), (100.0, 1e-3)] {
        let bar = Bar { l, J: l * l / 3.0, pull: 5.0 * l * load, turn: 3.0 * l * l * load, ..Bar::default() };
        all_settings(0.2).iter().for_each(|settings| check(&run_with(bar, settings).unwrap(), l, load));
    }
}

fn check(run: &Run<AnyModel>, l: f64, load: f64) {
    assert_eq!(run.trajectory.failure, None);
    let names: Vec<&str> = run.events.iter().map(|event| event.name).collect();
    assert_eq!(names, ["l_lands", "r_lands", "l_leaves", "r_leaves", "l_lands"], "{l} m, {load}");
    let table = Table::of(&run.mechanism, &run.trajectory);
    let column = |name: &str| &table.column(name).unwrap().values;
    let landed = table.times().iter().rposition(|time| *time == run.events[4].state.time).unwrap();
    assert!((column("turning")[landed] / load - 6.0).abs() < 1e-9);
    assert!((column("l_push")[landed] / (l * load) - 1.0).abs() < 1e-9);
    assert!(column("l_end").iter().all(|height| *height > -1e-12 * l));
    assert!(*column("r_end").last().unwrap() > 0.05 * l * load);
}
