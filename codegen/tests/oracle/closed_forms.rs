//! Mechanisms whose equations of motion can be written on a line.

use super::{Mechanism, Outcome, assert_value, assert_values};

/// (m l^2 + J) phi'' = -m g l sin phi - c phi' - M.
#[test]
fn simple_pendulum_with_damper_and_moment() -> Outcome {
    let pendulum = Mechanism::parse(
        "pub Pendulum;
        coordinates { phi [rad]; }
        parameters { l [m] = 0.7; m [kg] = 1.3; J [kg*m^2] = 0.2; g [m/s^2] = 9.81; c [N*m*s] = 0.4; M [N*m] = 0.9; }
        bodies { rod: mass m at l*[sin(phi), -cos(phi)], inertia J, angle phi; }
        loads { gravity [0, -g]; torque -c*dot(phi) on rod; torque -M on rod; }
        outputs { height_rate = dot(l*(1 - cos(phi))); tension = m*(g*cos(phi) + l*dot(phi)^2); }",
    )?;
    let (l, m, inertia, g, c, moment) = (0.7, 1.3, 0.2, 9.81, 0.4, 0.9);
    for (phi, speed) in [(0.0f64, 0.0), (0.3, -2.0), (2.9, 4.1), (-1.2, 0.7)] {
        let answer = pendulum.at(0.0, &[phi], &[speed])?;
        let applied = -m * g * l * phi.sin() - c * speed - moment;
        let total = m * l * l + inertia;
        assert_value(answer.terms.mass_matrix[0][0], total);
        assert_values(&answer.terms.applied_forces, &[applied]);
        assert_values(&answer.terms.convective, &[0.0]);
        assert_value(answer.terms.kinetic_energy, 0.5 * total * speed * speed);
        assert_values(&answer.solution.accelerations, &[applied / total]);
        assert_values(&answer.outputs, &[l * phi.sin() * speed, m * (g * phi.cos() + l * speed * speed)]);
        assert_value(answer.power, applied * speed);
    }
    Ok(())
}

/// Two slender bars, absolute angles from the direction of gravity:
/// (4/3) p1'' + cos(d)/2 p2'' + sin(d)/2 p2'^2 + (3/2)(g/l) sin p1 = 0,
/// (1/3) p2'' + cos(d)/2 p1'' - sin(d)/2 p1'^2 + (1/2)(g/l) sin p2 = 0, d = p1 - p2; everything times m l^2.
#[test]
fn double_pendulum() -> Outcome {
    let pendulum = Mechanism::parse(
        "pub DoublePendulum;
        coordinates { p1 [rad]; p2 [rad]; }
        parameters { l [m] = 0.6; m [kg] = 0.0603; g [m/s^2] = 9.81; }
        let u1 = [cos(p1), sin(p1)];
        let u2 = [cos(p2), sin(p2)];
        let J = m*l^2/12;
        bodies { upper: mass m at l/2*u1, inertia J, angle p1; lower: mass m at l*u1 + l/2*u2, inertia J, angle p2; }
        loads { gravity [g, 0]; }",
    )?;
    let (l, m, g) = (0.6, 0.0603, 9.81);
    for (p1, p2, w1, w2) in [(1.5f64, 1.5f64, 0.0, 0.0), (0.4, -1.1, 2.5, -3.0), (-2.6, 2.2, -7.0, 5.0)] {
        let answer = pendulum.at(0.0, &[p1, p2], &[w1, w2])?;
        let (unit, d) = (m * l * l, p1 - p2);
        let matrix = [[4.0 / 3.0, d.cos() / 2.0], [d.cos() / 2.0, 1.0 / 3.0]];
        let right =
            [-d.sin() / 2.0 * w2 * w2 - 1.5 * g / l * p1.sin(), d.sin() / 2.0 * w1 * w1 - 0.5 * g / l * p2.sin()];
        for i in 0..2 {
            assert_values(&answer.terms.mass_matrix[i], &matrix[i].map(|entry| entry * unit));
            assert_value(answer.terms.generalized_forces[i], right[i] * unit);
        }
        assert_values(&answer.terms.convective, &[d.sin() / 2.0 * w2 * w2 * unit, -d.sin() / 2.0 * w1 * w1 * unit]);
        let determinant = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0];
        let first = (right[0] * matrix[1][1] - right[1] * matrix[0][1]) / determinant;
        let second = (right[1] * matrix[0][0] - right[0] * matrix[1][0]) / determinant;
        assert_values(&answer.solution.accelerations, &[first, second]);
    }
    Ok(())
}

/// The support moves as s = a sin(w t) along x: l phi'' = -g sin phi - s'' cos phi, and what moves the support does the
/// work s' (m x'').
#[test]
fn pendulum_on_a_moving_support() -> Outcome {
    let pendulum = Mechanism::parse(
        "pub MovingSupport;
        coordinates { phi [rad]; }
        parameters { l [m] = 0.8; m [kg] = 1.7; g [m/s^2] = 9.81; a [m] = 0.15; w [rad/s] = 6; }
        let P = [a*sin(w*t), 0] + l*[sin(phi), -cos(phi)];
        bodies { bob: mass m at P; }
        loads { gravity [0, -g]; }
        outputs { vx = dot(P.x); ax = ddot(P).x; }",
    )?;
    let (l, m, g, a, w) = (0.8, 1.7, 9.81, 0.15, 6.0);
    for (t, phi, speed) in [(0.0f64, 0.3f64, 1.0), (0.21, -2.2, 3.5), (1.7, 1.1, -0.4)] {
        let answer = pendulum.at(t, &[phi], &[speed])?;
        let (support_speed, support_acceleration) = (a * w * (w * t).cos(), -a * w * w * (w * t).sin());
        let acceleration = (-g * phi.sin() - support_acceleration * phi.cos()) / l;
        let vx = support_speed + l * phi.cos() * speed;
        let ax = support_acceleration + l * phi.cos() * acceleration - l * phi.sin() * speed * speed;
        assert_values(&answer.terms.convective, &[m * l * phi.cos() * support_acceleration]);
        assert_values(&answer.solution.accelerations, &[acceleration]);
        assert_values(&answer.outputs, &[vx, ax]);
        let vy = l * phi.sin() * speed;
        assert_value(answer.terms.kinetic_energy, 0.5 * m * (vx * vx + vy * vy));
        assert_value(answer.power, -m * g * vy + m * ax * support_speed);
    }
    Ok(())
}

/// m (r'' - r w^2) = F and m (r^2 phi'' + 2 r r' phi') = 0: the mixed second derivatives of r [cos phi, sin phi].
#[test]
fn bead_on_a_free_rod() -> Outcome {
    let bead = Mechanism::parse(
        "pub Bead;
        coordinates { r [m]; phi [rad]; }
        parameters { m [kg] = 0.35; F [N] = 2.5; }
        let u = [cos(phi), sin(phi)];
        bodies { bead: mass m at r*u; }
        loads { force F*u at r*u; }",
    )?;
    for (r, phi, r_dot, w) in [(0.4, 0.2, -1.3, 5.0), (1.9, -2.5, 0.8, -2.0)] {
        let answer = bead.at(0.0, &[r, phi], &[r_dot, w])?;
        assert_values(&answer.terms.mass_matrix[0], &[0.35, 0.0]);
        assert_values(&answer.terms.mass_matrix[1], &[0.0, 0.35 * r * r]);
        assert_values(&answer.terms.convective, &[-0.35 * r * w * w, 0.35 * 2.0 * r * r_dot * w]);
        assert_values(&answer.solution.accelerations, &[r * w * w + 2.5 / 0.35, -2.0 * r_dot * w / r]);
        assert_value(answer.power, 2.5 * r_dot);
    }
    Ok(())
}

/// The rod turns at a given speed: r'' = r w^2, the rod pushes with 2 m r' w and so works with 2 m r r' w^2. The same
/// motion three ways: time in the position, time in a constraint, and the constraint scaled by 3 with its sides
/// exchanged.
#[test]
fn bead_on_a_driven_rod() -> Outcome {
    let driven = Mechanism::parse(
        "pub Driven; coordinates { r [m]; } parameters { m [kg] = 0.35; w [rad/s] = 4; }
        bodies { bead: mass m at r*[cos(w*t), sin(w*t)]; }",
    )?;
    let constrained = |equation: &str| {
        Mechanism::parse(&format!(
            "pub Constrained; coordinates {{ r [m]; phi [rad]; }} parameters {{ m [kg] = 0.35; w [rad/s] = 4; }}
            bodies {{ bead: mass m at r*[cos(phi), sin(phi)]; }}
            constraints {{ drive: {equation}; }} outputs {{ moment = reaction(drive); }}"
        ))
    };
    let (m, w) = (0.35, 4.0);
    for (t, r, r_dot) in [(0.3, 0.4, -1.3), (2.0, 1.9, 0.8)] {
        let (moment, power) = (2.0 * m * r * r_dot * w, 2.0 * m * r * r_dot * w * w);
        let answer = driven.at(t, &[r], &[r_dot])?;
        assert_values(&answer.solution.accelerations, &[r * w * w]);
        assert_value(answer.power, power);
        let answer = constrained("phi = w*t")?.at(t, &[r, w * t], &[r_dot, w])?;
        assert_values(&answer.terms.constraints, &[0.0]);
        assert_values(&answer.terms.constraint_jacobian[0], &[0.0, 1.0]);
        assert_values(&answer.terms.constraint_time_derivative, &[-w]);
        assert_values(&answer.solution.accelerations, &[r * w * w, 0.0]);
        assert_values(&answer.outputs, &[-moment]);
        assert_value(answer.power, power);
        let answer = constrained("3*w*t = 3*phi")?.at(t, &[r, w * t], &[r_dot, w])?;
        assert_values(&answer.terms.constraint_time_derivative, &[3.0 * w]);
        assert_values(&answer.solution.accelerations, &[r * w * w, 0.0]);
        assert_values(&answer.outputs, &[moment / 3.0]);
        assert_value(answer.power, power);
    }
    Ok(())
}

/// A free body pinned to the ground swings as a pendulum; the pin bears F = m (g - a) as seen by the ground.
#[test]
fn pinned_body_with_vector_constraint() -> Outcome {
    let pinned = Mechanism::parse(
        "pub Pinned;
        coordinates { x [m]; y [m]; phi [rad]; }
        parameters { l [m] = 0.5; m [kg] = 2.2; J [kg*m^2] = 0.3; g [m/s^2] = 9.81; }
        bodies { rod: mass m at [x, y], inertia J, angle phi; }
        loads { gravity [0, -g]; }
        constraints { pin: [x, y] - l*[sin(phi), -cos(phi)] = [0, 0]; }
        outputs { pin_x = reaction(pin).x; pin_y = reaction(pin).y; pin_size = norm(reaction(pin)); }",
    )?;
    let (l, m, inertia, g) = (0.5, 2.2, 0.3, 9.81);
    for (phi, w) in [(0.4f64, 1.5), (-2.0, -3.0)] {
        let (sin, cos) = phi.sin_cos();
        let answer = pinned.at(0.0, &[l * sin, -l * cos, phi], &[l * cos * w, l * sin * w, w])?;
        let acceleration = -m * g * l * sin / (m * l * l + inertia);
        let (ax, ay) = (l * (cos * acceleration - sin * w * w), l * (sin * acceleration + cos * w * w));
        let (pin_x, pin_y) = (-m * ax, -m * (ay + g));
        assert_values(&answer.terms.constraints, &[0.0, 0.0]);
        assert_values(&answer.terms.constraint_jacobian[0], &[1.0, 0.0, -l * cos]);
        assert_values(&answer.terms.constraint_jacobian[1], &[0.0, 1.0, -l * sin]);
        assert_values(&answer.terms.constraint_convective, &[l * sin * w * w, -l * cos * w * w]);
        assert_values(&answer.solution.accelerations, &[ax, ay, acceleration]);
        assert_values(&answer.solution.multipliers, &[pin_x, pin_y]);
        assert_values(&answer.outputs, &[pin_x, pin_y, pin_x.hypot(pin_y)]);
        assert_value(answer.power, -m * g * l * sin * w);
    }
    Ok(())
}

/// A constraint between two bodies, C = x2 - x1 - l: body 1 feels lambda, body 2 feels -lambda.
#[test]
fn reaction_between_two_bodies() -> Outcome {
    let towed = Mechanism::parse(
        "pub Towed; coordinates { x1 [m]; x2 [m]; } parameters { m1 [kg] = 2; m2 [kg] = 3; F [N] = 10; l [m] = 1; }
        bodies { a: mass m1 at [x1, 0]; b: mass m2 at [x2, 0]; }
        loads { force [F, 0] at [x2, 0]; }
        constraints { rod: x2 - x1 = l; } outputs { tension [N] = reaction(rod); }",
    )?;
    let answer = towed.at(0.0, &[0.0, 1.0], &[0.0, 0.0])?;
    assert_values(&answer.solution.accelerations, &[2.0, 2.0]);
    assert_values(&answer.outputs, &[4.0]);
    Ok(())
}
