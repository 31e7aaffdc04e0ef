//! 1. A pendulum: declare, run, look at numbers.
//!
//! `cargo run --release --example 01_pendulum`

use sim::{Settings, declared_start, mechanism, run};

mechanism! {
    /// A point mass on a rod without mass.
    pub Pendulum;

    coordinates { phi [rad]; }
    parameters { l [m] = 1; m [kg] = 1; g [m/s^2] = 9.81; }
    let P = l*[sin(phi), -cos(phi)];
    bodies { bob: mass m at P; }
    loads { gravity [0, -g]; }
    initial { phi = 60 [deg]; }
    // It comes to rest on the other side after half a period, and here after a whole one.
    events { rest: dot(phi) = 0; }
    outputs { height [m] = P.y; }
    drawing { ground [0, 0]; line [0, 0], P; }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // A mechanism is its parameters: a struct with a field for each, in SI units.
    let pendulum = Pendulum { l: 0.5, ..Pendulum::default() };
    let found = run(pendulum, &declared_start(&pendulum), &Settings::new(3.0))?;
    if let Some(failure) = found.trajectory.failure {
        return Err(failure.into());
    }
    let rests: Vec<f64> = found.events.iter().map(|event| event.state.time).collect();
    println!("half a period takes {:.9} s", rests[0]);

    // The exact one: 2 pi sqrt(l/g) / agm(1, cos(amplitude/2)), by Gauss.
    let (mut a, mut b) = (1.0, f64::cos(std::f64::consts::PI / 6.0));
    for _ in 0..6 {
        (a, b) = ((a + b) / 2.0, f64::sqrt(a * b));
    }
    println!("the exact half is   {:.9} s", std::f64::consts::PI * f64::sqrt(0.5 / 9.81) / a);
    Ok(())
}
