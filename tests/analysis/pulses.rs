//! What happens in a small part of a sweep: pulses, and the last of the way to a dead point.

use crate::sweeps::sweep;
use models::FourBar;
use sim::{Driven, Start, Sweep, declared_start, kinematics, mechanism};
use std::f64::consts::{PI, TAU};
use tests::any_model::interpreted;

mechanism! {
    /// A rotor with a steep pulse beside a wave that is small.
    Pulse;
    coordinates { th [rad]; }
    parameters { phase = 2.8; steep = 10; }
    bodies { rotor: inertia 0.1 [kg*m^2], angle th; }
    initial { th = 0; dot(th) = 60 [rpm]; }
    outputs { o = sin(th) + 1000*max(0, 1 - steep*abs(sin(th/2 + phase))); }
}

/// Corners lie anywhere between the nodes of a polynomial, beyond the last one too.
#[test]
fn no_pulse_hides_a_wave() {
    for k in 0..120 {
        let (phase, steep) = (PI * f64::from(k) / 120.0 + 0.01, [10.0, 40.0][k as usize % 2]);
        let rotor = Pulse { phase, steep };
        let found =
            kinematics(rotor, &declared_start(&rotor), &sweep::<Pulse>("th", [0.0, TAU], TAU, 7)).unwrap().extremes;
        let range = found.outputs[0].unwrap();
        let wave = |th: f64| th.sin() + 1000.0 * (1.0 - steep * (th / 2.0 + phase).sin().abs()).max(0.0);
        let all = (0..=20_000).map(|i| wave(TAU * f64::from(i) / 20_000.0));
        let [least, greatest] = all.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], o| [a.min(o), b.max(o)]);
        // The extremes between these places are beyond them, by at most half a step up the pulse.
        let step = 1000.0 * steep * TAU / 40_000.0 / 2.0;
        assert!(range.least.value <= least + 1e-9 && range.least.value > least - 2e-4, "{phase}: {range:?}, {least}");
        let beyond = range.greatest.value - greatest;
        assert!((-1e-9..step + 1e-9).contains(&beyond), "{phase}: {range:?}, {greatest}");
    }
}

mechanism! {
    /// A rotor with a load that lasts 0.4 degrees of a turn.
    Spike;
    coordinates { th [rad]; }
    tables { f [N*m] over [deg] = linear, periodic { 0, 0; 123.3, 0; 123.5, 5; 123.7, 0; 360, 0; } }
    bodies { rotor: inertia 0.1 [kg*m^2], angle th; }
    loads { torque -f(th) on rotor; }
    initial { th = 0; dot(th) = 60 [rpm]; }
}

/// What is recorded is no greater than the greatest value.
#[test]
fn what_a_row_shows_is_found() {
    let rotor = Spike::default();
    let found = kinematics(rotor, &declared_start(&rotor), &sweep::<Spike>("th", [0.0, TAU], TAU, 720)).unwrap();
    let greatest = found.extremes.forces[0].unwrap().greatest;
    assert!((greatest.value - 5.0).abs() < 1e-9 && (greatest.at.to_degrees() - 123.5).abs() < 1e-9, "{greatest:?}");
}

/// Cranks that cannot turn fully stop where coupler and rocker are in line, cos theta2 = (a^2 + d^2 - (b +- c)^2) / (2 a d), wherever
/// the steps end; the rocker's angle has a greatest and a least value up to there, whether the mechanism rests or moves.
#[test]
fn every_dead_point_is_found() {
    let mut count = 0;
    for k in 0..240 {
        let part = |i: u32| (f64::from(k) * [0.618, 0.414, 0.732, 0.236][i as usize]).fract();
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| 0.1 + 0.1 * part(i));
        let cosine = |sum: f64| (a * a + d * d - sum * sum) / (2.0 * a * d);
        let ends = [cosine(b + c), cosine(b - c)];
        // From the middle of the range of theta2, where it has one on this side of the ground link.
        let [outer, inner] = [ends[0].max(-1.0).acos(), ends[1].min(1.0).acos()];
        if ends[0] <= -0.999 || outer - inner < 0.3 {
            continue;
        }
        let theta = (outer + inner) / 2.0;
        let linkage = FourBar { a, b, c, d, ..FourBar::default() };
        let (x, y) = (d - a * theta.cos(), -a * theta.sin());
        let (distance, direction) = (x.hypot(y), y.atan2(x));
        let corner = ((b * b + distance * distance - c * c) / (2.0 * b * distance)).acos();
        let coupler = direction + corner;
        let rocker = (a * theta.sin() + b * coupler.sin()).atan2(a * theta.cos() + b * coupler.cos() - d);
        let start = Start { positions: [theta, coupler, rocker], ..declared_start(&linkage) };
        for speed in [0.0, 1.0] {
            let sweep = sweep::<FourBar>("theta2", [theta, theta + 4.0], speed, 50);
            let found = kinematics(linkage, &start, &sweep).unwrap();
            let limit = found.limit.unwrap_or_else(|| panic!("{k}: {:?}", found.trajectory.failure));
            assert!((limit.value - outer).abs() < 1e-9, "{k}: {} for {outer}", limit.value);
            assert!(found.extremes.transmission.unwrap().least.value < 1e-6, "{k}");
            count += 1;
        }
    }
    assert!(count > 200, "{count}");
}

mechanism! {
    /// A rotor with quantities that have poles, with an angle that wraps, and with narrow peaks.
    Poles;
    coordinates { th [rad]; }
    parameters { shift [rad] = 0; }
    bodies { rotor: inertia 0.1 [kg*m^2], angle th; }
    initial { th = 0; dot(th) = 60 [rpm]; }
    let x = th + shift;
    outputs { tangent = tan(x); square = 1/sin(x/2)^2; wrapped [rad] = atan2(sin(x), cos(x)); peaks = 1/(sin(x)^2 + 1e-6); }
}

/// What has a pole has no greatest value, wherever the pole lies between the nodes; what is only narrow has.
#[test]
fn poles_have_no_bound() {
    for k in 0..60 {
        let rotor = Poles { shift: 0.01 + PI * f64::from(k) / 30.0 };
        let found =
            kinematics(rotor, &declared_start(&rotor), &sweep::<Poles>("th", [0.0, TAU], TAU, 7)).unwrap().extremes;
        let [tangent, square, wrapped, peaks] = found.outputs[..] else { panic!("{found:?}") };
        assert!(tangent.is_none() && square.is_none(), "{k}: {tangent:?} {square:?}");
        let (wrapped, peaks) = (wrapped.unwrap(), peaks.unwrap());
        // The last place before the jump that comparison tells from it.
        assert!(
            (wrapped.least.value + PI).abs() < 1e-8 && (wrapped.greatest.value - PI).abs() < 1e-8,
            "{k}: {wrapped:?}"
        );
        assert_eq!(found.time_ratios[2], None);
        assert!((peaks.greatest.value / 1e6 - 1.0).abs() < 1e-9 && peaks.least.value < 1.0, "{k}: {peaks:?}");
    }
}

/// A load within a degree of a turn, by position, by a table and by time, whatever is recorded of the sweep: the drive holds it.
#[test]
fn loads_between_recorded_positions_are_seen() {
    let cases = [
        ("torque (if abs(a - 2) < w then -T else 0) on i;", 3.0),
        ("torque (if a > 2 then (if a < 2 + w then -T else 0) else 0) on i;", 3.0),
        ("torque -T*exp(-((a - 2)/w)^2) on i;", 3.0),
        ("torque -T*f((a - 2)/w) on i;", 3.0),
        ("torque (if t < 1.7 [s] then 0 else if t < 1.7 [s] + w*(1 [s]) then -T else 0) on i;", 3.0),
    ];
    for (load, exact) in cases {
        for width in ["1e-2", "1e-3", "1e-5"] {
            let text = format!(
                "pub Held; coordinates {{ a [rad]; }} parameters {{ w = {width}; T [N*m] = 3; }}
                 tables {{ f over [1] = linear {{ -9, 0; -1, 0; 0, 1; 1, 0; 9, 0; }} }}
                 bodies {{ i: inertia 0.01 [kg*m^2], angle a; }} loads {{ {load} }} initial {{ a = 0.1; dot(a) = 1; }}"
            );
            for steps in [1, 100, 720] {
                let model = interpreted(&text).unwrap();
                let start = declared_start(&model);
                let sweep =
                    Sweep { driven: Driven::Coordinate(0), from: 0.1, to: 6.0, speed: 1.0, steps, held: vec![] };
                let found = kinematics(model, &start, &sweep).unwrap();
                let range = found.extremes.forces[0].unwrap_or_else(|| panic!("{load} {width} {steps}"));
                assert!((range.greatest.value - exact).abs() < 1e-6, "{load} {width} {steps}: {range:?}");
                assert!(range.least.value.abs() < 1e-6, "{load} {width} {steps}: {range:?}");
            }
        }
    }
}
