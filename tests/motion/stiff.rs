//! A stiff linkage: explicit methods are held back by stability, the implicit one by accuracy alone.

use sim::{Method, Rows, Run, Settings, mechanism};
use tests::any_model::{AnyModel, run_with};

mechanism! {
    /// A slider-crank whose piston drags a slider of 10 g by a spring and a damper.
    Dragged;
    coordinates { theta [rad]; phi [rad]; x [m]; }
    parameters {
        r [m] = 0.15; l [m] = 0.45; J [kg*m^2] = 0.05; rod [kg] = 2; piston [kg] = 1.5; m [g] = 10;
        k [N/m] = 1e8; c [N*s/m] = 1e4; start [rad] = 0.5; w [rad/s] = 20;
    }
    let A = r*[cos(theta), sin(theta)];
    let C = A + l*[cos(phi), sin(phi)];
    let pull = k*(C.x - x) + c*dot(C.x - x);
    let side = sqrt(l^2 - (r*sin(start))^2);
    bodies {
        crank: inertia J, angle theta;
        bar: mass rod at A + l/2*[cos(phi), sin(phi)], inertia rod*l^2/12, angle phi;
        head: mass piston at C;
        slider: mass m at [x, 0];
    }
    loads { gravity [0, -9.81 [m/s^2]]; force [pull, 0] at [x, 0]; force [-pull, 0] at C; }
    constraints { guide: C.y = 0; }
    initial {
        theta = start; dot(theta) = w; guess phi = -0.1;
        x = r*cos(start) + side;
        dot(x) = -r*w*sin(start) - r^2*w*sin(start)*cos(start)/side;
    }
}

/// The largest error of a coordinate or speed at the end, relative to its size.
fn error(run: &Run<AnyModel>, exact: &Run<AnyModel>) -> f64 {
    assert_eq!(run.trajectory.failure, None);
    let end = |run: &Run<AnyModel>| {
        let state = run.trajectory.samples.last().unwrap().state.clone();
        [state.positions.as_ref(), state.speeds.as_ref()].concat()
    };
    end(run).iter().zip(end(exact)).fold(0.0, |worst, (a, b)| f64::max(worst, ((a - b) / b).abs()))
}

#[test]
fn the_implicit_method_takes_a_fiftieth_of_the_steps_at_equal_error() {
    let run = |method, rtol| {
        let settings = Settings { rows: Rows::Even(1), ..Settings::adaptive(method, 0.1, rtol) };
        run_with(Dragged::default(), &settings).unwrap()
    };
    let exact = run(Method::Dop853, 1e-11);
    let explicit = [run(Method::Dopri5, 1e-6), run(Method::Dop853, 1e-6)];
    let implicit = run(Method::Radau5, 1e-8);
    for found in explicit.iter().chain([&implicit]) {
        println!(
            "{:<8} {:>8} steps, {:>3} refused, {:>8} right-hand sides, error {:.1e}, energy {:.1e}",
            found.settings.method.name(),
            found.steps.accepted,
            found.steps.rejected,
            found.evaluations,
            error(found, &exact),
            found.energy_balance
        );
    }
    for found in &explicit {
        assert!(error(&implicit, &exact) <= error(found, &exact));
        assert!(50 * implicit.steps.accepted <= found.steps.accepted, "{}", found.steps.accepted);
    }
}
