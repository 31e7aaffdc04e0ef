//! Mechanisms with many constraints, in which a product over all of them is tiny.

use crate::trees::scaled;
use sim::{Erased, Method, Run, Settings, Stepping, dead_points, declared_start};

/// A crank that a slider on the x-axis is given for, with so many sliders on lines through its centre besides.
fn sliders(count: usize) -> String {
    format!(
        "
    pub Sliders;
    coordinates {{ a [rad]; b0 [rad]; x0 [m]; }}
    parameters {{ L [m] = 1; m [kg] = 1; }}
    fragment Slider(phase, tilt) {{
        coordinates {{ b [rad]; x [m]; }}
        let P = 0.3*L*[cos(a + phase), sin(a + phase)];
        bodies {{ piston: mass 0.05*m at [x, tilt*x]; }}
        constraints {{ pin: P + L*[cos(b), sin(b)] = [x, tilt*x]; }}
        initial {{ guess b = 0.1; guess x = 1.2*L; }}
    }}
    bodies {{ wheel: inertia 5*m*L^2, angle a; }}
    constraints {{ pin: 0.3*L*[cos(a), sin(a)] + L*[cos(b0), sin(b0)] = [x0, 0]; }}
    repeat i in 1..={count} {{ use Slider(0.7*i, 0.1*(i - 1)) as c_[i]; }}
    initial {{ guess a = 0.4; guess b0 = -0.1; x0 = 1.2*L; dot(x0) = -0.3; }}"
    )
}

/// The slider turns back where crank and rod are in line. Scaled products of pivots are 1e-4 with one slider, and 1e-12 with 25.
#[test]
fn dead_points_are_found_among_many_rows() {
    for count in [1, 10, 25] {
        let mechanism = Erased::of(scaled(&sliders(count), 1.0, 1.0));
        let stepping = Stepping::Equal(400);
        let settings = Settings { method: Method::Rk4, stepping, ..Settings::new(8.0) };
        let run: Run<_> = sim::run(mechanism.clone(), &declared_start(&mechanism), &settings).unwrap();
        let passed = dead_points(&run);
        for point in &passed {
            let off = point.state.positions[0].sin();
            assert!(point.of == ["x0"] && off.abs() < 1e-9, "{count}: {off:e} at {} s", point.state.time);
        }
        assert_eq!(passed.len(), 3, "{count}");
    }
}
