//! Events that change the motion: impacts, constraints that are switched, parameters and states that are set; against closed
//! forms and equations by hand.

mod accumulating;
mod at_times;
mod bouncing;
mod pulled;
mod resting;

use sim::{Compiled, Mechanism, Method, Run, Settings, Stabilisation, What, mechanism};
use std::f64::consts::PI;
use tests::any_model::{self, AnyModel, interpreted};
use tests::run_with;

const G: f64 = 9.81;

/// The place of a parameter.
fn parameter<M: Compiled>(name: &str) -> usize {
    M::DESCRIPTION.parameters.iter().position(|parameter| parameter.name == name).unwrap()
}

fn times(run: &Run<AnyModel>, name: &str) -> Vec<f64> {
    run.events.iter().filter(|event| event.name == name).map(|event| event.state.time).collect()
}

fn all_settings(end: f64) -> Vec<Settings> {
    let adaptive = |method| Settings::adaptive(method, end, 1e-10);
    let mut settings = vec![adaptive(Method::Dop853), adaptive(Method::Dopri5), adaptive(Method::Radau5)];
    settings.push(Settings::equal_steps(Method::Rk4, end, 100));
    for stabilisation in [Stabilisation::MassProjection, Stabilisation::Partitioning] {
        settings.push(Settings { stabilisation, ..settings[0] });
    }
    settings
}

mechanism! {
    /// A wheel that turns at 1 rad/s, so that angles are times.
    Counter;
    coordinates { phi [rad]; }
    parameters { J [kg*m^2] = 1; k = 1; n = 0; late [rad] = 1e-9; }
    bodies { wheel: inertia J, angle phi; }
    initial { dot(phi) = 1; }
    events {
        tripled: phi = 0.3 + late rising { set k = 3*k; }
        doubled: phi = 0.3 rising { set k = 2*k + 1; }
        never: phi = 0.31 falling { set k = 1000; }
        counted: sin(20*phi) = 0 rising { set n = n + 1; stop after 2; }
        ever: phi = 0.7 { stop after 5; }
    }
}

/// In one step, as in many: events happen in the order of their times, and those of one time in that of declaration.
#[test]
fn events_in_one_step_happen_in_order() {
    let [k, n] = ["k", "n"].map(parameter::<Counter>);
    for steps in [1, 7, 100] {
        for (late, expected) in [(1e-9, 9.0), (0.0, 7.0), (1e-5, 9.0)] {
            let settings = Settings::equal_steps(Method::Dop853, 1.0, steps);
            let run = any_model::run_with(Counter { late, ..Counter::default() }, &settings).unwrap();
            let last = run.trajectory.phases.last().unwrap().mechanism.parameters();
            assert_eq!([last[k], last[n]], [expected, 2.0], "{steps} steps, {late}");
            let end = run.trajectory.samples.last().unwrap().state.time;
            assert!((end - 0.1 * PI).abs() < 1e-11, "{end}");
            assert_eq!(times(&run, "ever").len(), 0);
            assert_eq!(run.mechanism.parameters()[k], 1.0, "the run keeps its start");
        }
    }
}

mechanism! {
    /// A block on a table that swings up and down, and leaves it where nothing presses it down any more.
    pub(crate) Shaken;
    coordinates { y [m]; }
    parameters { m [kg] = 0.7; a [m] = 0.05; w [1/s] = 20; g [m/s^2] = 9.81; }
    let table = a*sin(w*t);
    bodies { block: mass m at [0, y]; }
    loads { gravity [0, -g]; }
    constraints { contact: y = table initially active; }
    events {
        lift: reaction(contact) = 0 rising { release contact; }
        landing: y = table falling { activate contact; }
    }
    outputs { press [N] = -reaction(contact); }
}

/// m (y'' + g) = 0 where sin(w t) = g/(a w^2); then free flight, to where the table meets it again.
#[test]
fn a_block_leaves_its_table_where_the_reaction_vanishes() {
    let (a, w) = (0.05f64, 20.0);
    let lift = (G / (a * w * w)).asin() / w;
    let (height, speed) = (a * (w * lift).sin(), a * w * (w * lift).cos());
    let apart = |t: f64| height + speed * (t - lift) - G / 2.0 * (t - lift).powi(2) - a * (w * t).sin();
    let (mut above, mut below) = (lift + 0.05, lift + 0.3);
    assert!(apart(above) > 0.0 && apart(below) < 0.0);
    for _ in 0..80 {
        let middle = (above + below) / 2.0;
        *(if apart(middle) > 0.0 { &mut above } else { &mut below }) = middle;
    }
    for settings in all_settings(0.29) {
        let run = any_model::run_with(Shaken::default(), &settings).unwrap();
        assert_eq!(run.trajectory.failure, None, "{}", settings.method.name());
        // RK4 in steps of 3 ms is exact on the table, which is held by its constraint, and in free flight.
        assert!((times(&run, "lift")[0] - lift).abs() < 1e-9, "{:?} {lift}", times(&run, "lift"));
        assert!((times(&run, "landing")[0] - above).abs() < 1e-9, "{:?} {above}", times(&run, "landing"));
        let landing = run.events.iter().find(|event| event.name == "landing").unwrap();
        let hits = speed - G * (above - lift) - a * w * (w * above).cos();
        let change = landing.change.clone().unwrap();
        assert!((change.impulses[0] - 0.7 * hits).abs() < 1e-8, "{}", change.impulses[0]);
        // In flight the multiplier is nothing at all.
        let flying =
            run.trajectory.samples.iter().filter(|s| s.state.time > lift + 1e-6 && s.state.time < above - 1e-6);
        assert!(flying.map(|sample| sample.multipliers[0]).all(|lambda| lambda == 0.0));
        assert!(run.energy_balance < 1e-6, "{:e}", run.energy_balance);
    }
}

mechanism! {
    /// A stone on a string.
    pub(crate) Stone;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 0.4; l [m] = 0.8; g [m/s^2] = 9.81; }
    let P = [x, y];
    bodies { stone: mass m at P; }
    loads { gravity [0, -g]; }
    constraints { string: norm(P) = l initially active; }
    initial { x = 0; y = -0.8; dot(x) = 5.2; }
    events {
        slack: reaction(string) = 0 falling { release string; }
        taut: norm(P) = l rising { activate string; }
    }
}

/// Slack where sin(angle) = (v^2 - 2 g l)/(3 g l); the parabola then meets the circle again; there the speed along the string
/// is lost.
#[test]
fn a_string_goes_slack_and_taut() {
    let (l, v) = (0.8, 5.2f64);
    let sine = (v * v - 2.0 * G * l) / (3.0 * G * l);
    let (x, y) = (l * (1.0 - sine * sine).sqrt(), l * sine);
    let speed = (G * l * sine).sqrt();
    let (vx, vy) = (-speed * sine, speed * (1.0 - sine * sine).sqrt());
    let at = |s: f64| [x + vx * s, y + vy * s - G / 2.0 * s * s];
    let out = |s: f64| at(s)[0].hypot(at(s)[1]) - l;
    let (mut inside, mut outside) = (0.1, 1.0);
    assert!(out(inside) < 0.0 && out(outside) > 0.0);
    for _ in 0..80 {
        let middle = (inside + outside) / 2.0;
        *(if out(middle) < 0.0 { &mut inside } else { &mut outside }) = middle;
    }
    let run = any_model::run_with(
        Stone::default(),
        &Settings { rows: sim::Rows::Steps, ..Settings::adaptive(Method::Dop853, 1.2, 1e-12) },
    )
    .unwrap();
    assert_eq!(run.trajectory.failure, None);
    let (slack, taut) = (&run.events[0], &run.events[1]);
    assert_eq!((slack.name, taut.name), ("slack", "taut"));
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    near(slack.state.positions[0], x);
    near(slack.state.positions[1], y);
    near(taut.state.time - slack.state.time, inside);
    let [px, py] = at(inside);
    near(taut.state.positions[0], px);
    let along = (px * vx + py * (vy - G * inside)) / l;
    let change = taut.change.clone().unwrap();
    near(change.energy_taken, 0.5 * 0.4 * along * along);
    // C = norm(P) - l grows outwards, and the stone pulls outwards.
    near(change.impulses[0], 0.4 * along);
    assert!(run.energy_balance < 1e-9);
}

mechanism! {
    /// Two rods, the second of which hits a stop on the first.
    Knee;
    coordinates { a [rad]; b [rad]; }
    parameters { m [kg] = 1.2; n [kg] = 0.7; l [m] = 0.5; k [m] = 0.4; I [kg*m^2] = 0.03; g [m/s^2] = 9.81; bounce = 0.3; }
    let A = l*[sin(a), -cos(a)];
    let B = A + k*[sin(b), -cos(b)];
    bodies { thigh: mass m at A/2, inertia I, angle a; shank: mass n at B; }
    loads { gravity [0, -g]; }
    constraints { stop: b = a initially released; }
    initial { a = 0.6; b = 0.1; dot(a) = -1; dot(b) = 1.5; }
    events { knock: b - a = 0 rising { impact stop restitution bounce; } }
}

/// v+ - v- = -M^-1 C_q' L and L = (1 + e) u/(C_q M^-1 C_q'), with M of two point masses and a rod written by hand.
#[test]
fn a_knee_at_its_stop_obeys_the_impulsive_equations() {
    let run = any_model::run_with(Knee::default(), &Settings::new(0.4)).unwrap();
    let knock = &run.events[0];
    let change = knock.change.clone().unwrap();
    let [a, b] = [0, 1].map(|i| knock.state.positions[i]);
    let (m, n, l, k, inertia, e) = (1.2, 0.7, 0.5, 0.4, 0.03, 0.3);
    let mass =
        [[m * l * l / 4.0 + inertia + n * l * l, n * l * k * (a - b).cos()], [n * l * k * (a - b).cos(), n * k * k]];
    let determinant = mass[0][0] * mass[1][1] - mass[0][1] * mass[1][0];
    // M^-1 C_q' for C_q = [-1, 1].
    let along = [(-mass[1][1] - mass[0][1]) / determinant, (mass[0][0] + mass[1][0]) / determinant];
    let [va, vb] = [0, 1].map(|i| knock.state.speeds[i]);
    let impulse = (1.0 + e) * (vb - va) / (along[1] - along[0]);
    let near = |found: f64, expected: f64| {
        assert!((found - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{found} {expected}")
    };
    near(change.impulses[0], impulse);
    near(change.state.speeds[0], va - along[0] * impulse);
    near(change.state.speeds[1], vb - along[1] * impulse);
    near(change.state.speeds[1] - change.state.speeds[0], -e * (vb - va));
    let rates = (vb - va) + (change.state.speeds[1] - change.state.speeds[0]);
    near(change.energy_taken, 0.5 * impulse * rates);
    assert!(run.energy_balance < 1e-9);
}

mechanism! {
    /// Two rods in line that swing against a wall, which gravity pulls them away from.
    Beside;
    coordinates { a [rad]; b [rad]; }
    parameters { l [m] = 0.6; m [kg] = 0.06; g [m/s^2] = 9.81; w [rad/s] = 6; }
    let P = l*[cos(a), sin(a)];
    let T = P + l*[cos(b), sin(b)];
    bodies { upper: mass m at P/2, inertia m*l^2/12, angle a; lower: mass m at (P + T)/2, inertia m*l^2/12, angle b; }
    loads { gravity [g, 0]; }
    constraints { wall: T.x = 0 initially released; }
    initial { a = pi/2; b = pi/2; dot(a) = w; dot(b) = w; }
    events { hit: T.x = 0 falling { impact wall restitution 0; } }
}

/// The impact leaves the gap's rate at zero but for rounding, and the rods turning: what they turn in a part of the time asked
/// for must not be taken for a rate. The elbow swings on through the line of the wall; when the tip comes back, it presses
/// against the wall, and one impact follows another.
#[test]
fn rods_leave_a_wall_however_long_the_run_is() {
    let run =
        |end: f64| any_model::run_with(Beside::default(), &Settings::adaptive(Method::Dop853, end, 1e-10)).unwrap();
    let short = run(1e-3);
    assert!(short.trajectory.failure.is_none() && times(&short, "hit") == [0.0]);
    let ends: Vec<f64> = [0.2, 2.0, 20.0].map(|end| run(end).trajectory.failure.unwrap().time).to_vec();
    // What is at once grows with the time asked for.
    assert!(ends.iter().all(|time| *time > 0.01 && (time - ends[0]).abs() < 1e-7), "{ends:?}");
}

mechanism! {
    /// A wheel of spokes without a rim that rolls down a slope: a foot is pinned, the next one lands, and takes its place.
    Rimless;
    coordinates { x [m]; y [m]; phi [rad]; }
    parameters { m [kg] = 3; J [kg*m^2] = 0.2; l [m] = 0.7; alpha [rad] = 0.3; slope [rad] = 0.08; s [m] = 0; g [m/s^2] = 9.81; }
    let H = [x, y];
    let foot = H - l*[sin(phi), cos(phi)];
    let next = H - l*[sin(phi - 2*alpha), cos(phi - 2*alpha)];
    bodies { wheel: mass m at H, inertia J, angle phi; }
    loads { gravity g*[sin(slope), -cos(slope)]; }
    constraints {
        stance: foot = [s, 0] initially active;
        landed: next = [s + 2*l*sin(alpha), 0] initially released;
    }
    initial { phi = -0.3; guess x = -0.2; guess y = 0.65; dot(phi) = 1.4; }
    events {
        step: next.y = 0 falling {
            release stance; activate landed;
            set s = s + 2*l*sin(alpha); set phi = phi - 2*alpha;
            release landed; activate stance;
        }
    }
}

/// Angular momentum about the new foot: w+ = eta w-, eta = (J + m l^2 cos(2 alpha))/(J + m l^2); on the limit cycle a step
/// gains what its impact loses (McGeer, Passive Dynamic Walking, 1990).
#[test]
fn a_rimless_wheel_walks_its_limit_cycle() {
    let (m, j, l, alpha, slope) = (3.0, 0.2, 0.7, 0.3f64, 0.08f64);
    let inertia = j + m * l * l;
    let eta = (j + m * l * l * (2.0 * alpha).cos()) / inertia;
    let gain = 4.0 * m * G * l * alpha.sin() * slope.sin() / inertia;
    for settings in
        [Settings::new(12.0), Settings { stabilisation: Stabilisation::Partitioning, ..Settings::new(12.0) }]
    {
        let run = any_model::run_with(Rimless::default(), &settings).unwrap();
        assert_eq!(run.trajectory.failure, None);
        let mut before = 1.4f64;
        let mut last = 0.0;
        assert!(run.events.len() > 15, "{}", run.events.len());
        for event in &run.events {
            let change = event.change.clone().unwrap();
            let arrives = (before * before + gain).sqrt();
            let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-8, "{found} {expected}");
            near(event.state.speeds[2], arrives);
            near(change.state.speeds[2], eta * arrives);
            near(change.state.positions[2], -alpha);
            (before, last) = (change.state.speeds[2], event.state.speeds[2]);
        }
        let cycle = (gain / (1.0 - eta * eta)).sqrt();
        assert!((last - cycle).abs() < 1e-4 * cycle, "{last} {cycle}");
        assert!(run.energy_balance < 1e-8, "{:e}", run.energy_balance);
        assert!(run.position_residual < 1e-11 && run.velocity_residual < 1e-11);
    }
}

mechanism! {
    /// Two identical masses on springs, which change names halfway.
    Swapped;
    coordinates { p [m]; q [m]; }
    parameters { m [kg] = 1; k [N/m] = 4; }
    bodies { one: mass m at [p, 0]; other: mass m at [q, 1 [m]]; }
    loads { force [-k*p, 0] at [p, 0]; force [-k*q, 0] at [q, 1 [m]]; }
    initial { p = 1; q = -0.5; dot(q) = 0.3; }
    events { halfway: t = 0.5 [s] rising { swap p, q; } }
}

#[test]
fn coordinates_change_names_with_their_speeds() {
    let run = any_model::run_with(Swapped::default(), &Settings::new(1.0)).unwrap();
    let last = run.trajectory.samples.last().unwrap().state.clone();
    let p = (2f64).cos();
    let q = -0.5 * (2f64).cos() + 0.15 * (2f64).sin();
    // 1e-10 a step.
    assert!((last.positions[0] - q).abs() < 1e-8 && (last.positions[1] - p).abs() < 1e-8, "{:?}", last.positions);
    assert!(run.energy_taken.abs() < 1e-15);
}

mechanism! {
    /// A bead that is caught where it is not.
    Caught;
    coordinates { x [m]; }
    parameters { m [kg] = 1; }
    bodies { bead: mass m at [x, 0]; }
    constraints { hook: x = 1 [m] initially released; }
    initial { dot(x) = 1; }
    events { early: x = 0.9 [m] rising { activate hook; } }
}

#[test]
fn a_constraint_that_is_open_cannot_become_active() {
    let run = any_model::run_with(Caught::default(), &Settings::new(2.0)).unwrap();
    let failure = run.trajectory.failure.unwrap();
    assert!(matches!(failure.what, What::EventOpens { event: "early", constraint: "hook", .. }), "{failure}");
    assert!((failure.time - 0.9).abs() < 1e-11);
    assert!(run.trajectory.samples.last().unwrap().state.time > 0.89);
}

/// A bead that falls from a height in metres, in the time in which one falls from 1 m, and is caught at a fraction of that height.
fn caught_at(fraction: f64, height: f64) -> Result<Run<AnyModel>, String> {
    let (at, gravity) = (fraction * height, 9.81 * height);
    let bead = interpreted(&format!(
        "/// A bead above a floor.
        Bead;
        coordinates {{ y [m]; }}
        parameters {{ m [kg] = 1; }}
        bodies {{ bead: mass m at [0, y]; }}
        loads {{ gravity [0, -{gravity:e} [m/s^2]]; }}
        constraints {{ floor: y = 0 initially released; }}
        initial {{ y = {height:e} [m]; }}
        events {{ lands: y = {at:e} [m] falling {{ activate floor; }} }}"
    ))?;
    run_with(bead, &Settings::new(1.0)).map_err(|failure| failure.to_string())
}

/// At the floor nothing says how large this mechanism is: no coordinate and no parameter has a length, but its start had one.
#[test]
fn a_floor_catches_at_every_size() {
    for height in [1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9] {
        let run = caught_at(0.0, height).unwrap();
        assert!(run.trajectory.failure.is_none(), "{height} m: {:?}", run.trajectory.failure);
        let (landed, last) = (&run.events[0].state, &run.trajectory.samples.last().unwrap().state);
        // 1e-10 a step, and the level of rounding on the floor.
        assert!((landed.time - (2.0 / 9.81f64).sqrt()).abs() < 1e-9, "{height} m: {}", landed.time);
        assert!(last.positions[0].abs() <= 1e-12 * height, "{height} m: {:e}", last.positions[0]);
        // A floor that is a hundred thousandth of the height away is not met.
        let failure = caught_at(1e-5, height).unwrap().trajectory.failure.unwrap();
        assert!(matches!(failure.what, What::EventOpens { event: "lands", .. }), "{height} m: {failure}");
    }
}
