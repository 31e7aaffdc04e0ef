"""Kernels on arrays: shapes, values and refusals."""

import numpy as np
import pytest

import linkwright


def states(model, count, seed=1):
    random = np.random.default_rng(seed)
    q, qd = model.initial()
    return q + 0.05 * random.standard_normal((count, len(q))), qd + 0.05 * random.standard_normal((count, len(q)))


def test_one_state_is_the_closed_form(oscillator):
    qdd, multipliers = oscillator.dynamics(0.0, [0.1], [0.3])
    assert qdd.shape == (1,) and multipliers.shape == (0,)
    assert qdd[0] == pytest.approx(-8 / 2 * 0.1, rel=1e-15)
    assert oscillator.kinetic_energy(0, [0.1], [0.3]) == pytest.approx(0.5 * 2 * 0.3**2, rel=1e-15)
    assert oscillator.mass_matrix(0, [0.1]).tolist() == [[2.0]]
    assert oscillator.outputs(0, [0.1], [0], [0], []).tolist() == [0.2]


def test_equations_of_motion_hold(quick_return):
    """M q'' + C_q' lambda = Q - h, and C_q q'' + convective terms = 0."""
    q, qd = states(quick_return, 20)
    m, jacobian = quick_return.mass_matrix(0, q), quick_return.constraint_jacobian(0, q)
    qdd, multipliers = quick_return.dynamics(0, q, qd)
    forces = quick_return.generalized_forces(0, q, qd) - quick_return.convective_forces(0, q, qd)
    inertia = np.einsum("sij,sj->si", m, qdd)
    reactions = np.einsum("sij,si->sj", jacobian, multipliers)
    # The reaction does virtual work -lambda delta C. Rounding of sums of terms of this size.
    assert np.abs(inertia - forces + reactions).max() < 1e-11 * np.abs(reactions).max()
    convective = quick_return.constraint_convective(0, q, qd)
    closed = np.einsum("sij,sj->si", jacobian, qdd) + convective
    assert np.abs(closed).max() < 1e-11 * np.abs(convective).max()


@pytest.mark.parametrize("count", [0, 1, 7, 64, 100])
def test_many_states_have_the_bits_of_each(quick_return, count):
    q, qd = states(quick_return, count)
    t = np.linspace(0, 1, count)
    many = quick_return.dynamics(t, q, qd)
    assert [part.shape for part in many] == [(count, q.shape[1]), (count, len(quick_return.constraint_names))]
    for place in range(count):
        for part, one in zip(many, quick_return.dynamics(t[place], q[place], qd[place])):
            assert np.array_equal(part[place], one)


def test_every_kernel_has_its_shape(quick_return):
    q, qd = states(quick_return, 3)
    n, m = q.shape[1], len(quick_return.constraint_names)
    p = len(quick_return.parameters)
    shapes = {
        "mass_matrix": [(n, n)], "constraints": [(m,)], "constraint_magnitudes": [(m,)],
        "constraint_jacobian": [(m, n)], "constraint_time_derivative": [(m,)],
        "constraint_linearization": [(m,), (m,), (m, n)], "convective_forces": [(n,)], "generalized_forces": [(n,)],
        "constraint_convective": [(m,)], "kinetic_energy": [()], "dynamics": [(n,), (m,)],
        "dynamics_jacobian": [(n, n), (n, n), (m, n), (m, n)], "dynamics_sensitivity": [(n, p), (m, p)],
        "inverse_dynamics": [(n,)], "power": [()], "outputs": [(len(quick_return.output_names),)],
        "events": [(len(quick_return.event_names),)],
    }
    one = {"mass_matrix", "constraints", "constraint_magnitudes", "constraint_jacobian", "constraint_time_derivative",
           "constraint_linearization"}
    for name, expected in shapes.items():
        kernel = getattr(quick_return, name)
        levels = [q, qd, q, np.ones((3, m))][: 1 if name in one else 4 if name in {"power", "outputs", "events"}
                                             else 3 if name == "inverse_dynamics" else 2]
        many, single = kernel(0, *levels), kernel(0, *[level[1] for level in levels])
        many = many if isinstance(many, tuple) else (many,)
        single = single if isinstance(single, tuple) else (single,)
        assert [np.shape(part) for part in many] == [(3, *shape) for shape in expected], name
        assert [np.shape(part) for part in single] == expected, name
        assert all(np.array_equal(a[1], b) for a, b in zip(many, single)), name


def test_the_mass_matrix_in_speeds_of_a_free_body():
    body = """pub Body;
    bodies { body: free, mass 2, inertia [1, 2, 3]; }
    %s"""
    one = linkwright.load(body % "kernels { speed_mass_matrix; }")
    q, _ = one.initial()
    np.testing.assert_allclose(one.speed_mass_matrix(0, q), np.diag([2, 2, 2, 1, 2, 3]), rtol=1e-15)
    assert one.speed_mass_matrix(0, np.stack([q, q])).shape == (2, 6, 6)
    with pytest.raises(ValueError, match=r"`body` has no `speed_mass_matrix`; write `kernels \{ speed_mass_matrix; \}`"):
        linkwright.load(body % "").speed_mass_matrix(0, q)


def test_derivatives_are_those_of_the_accelerations(quick_return):
    q, qd = quick_return.initial()
    by_q, by_qd, _, _ = quick_return.dynamics_jacobian(0, q, qd)
    step = 1e-5
    for j in range(len(q)):
        e = np.eye(len(q))[j] * step
        quotient = (quick_return.dynamics(0, q + e, qd)[0] - quick_return.dynamics(0, q - e, qd)[0]) / (2 * step)
        # Second-order quotients lose half of the digits.
        np.testing.assert_allclose(by_q[:, j], quotient, rtol=1e-5, atol=1e-5 * np.abs(by_q).max())
        quotient = (quick_return.dynamics(0, q, qd + e)[0] - quick_return.dynamics(0, q, qd - e)[0]) / (2 * step)
        np.testing.assert_allclose(by_qd[:, j], quotient, rtol=1e-5, atol=1e-5 * max(1e-3, np.abs(by_qd).max()))


def test_arrays_of_other_layouts(quick_return):
    q, qd = states(quick_return, 5)
    expected = quick_return.dynamics(0, q, qd)[0]
    assert np.array_equal(quick_return.dynamics(0, np.asfortranarray(q), qd.tolist())[0], expected)
    wide = np.zeros((5, 2 * q.shape[1]))
    wide[:, ::2] = q
    assert np.array_equal(quick_return.dynamics(np.zeros(5), wide[:, ::2], qd)[0], expected)
    shifted = np.frombuffer(b"x" + q.tobytes(), float, offset=1).reshape(q.shape)
    assert np.array_equal(quick_return.dynamics(np.float64(0), shifted, qd)[0], expected)
    assert np.array_equal(quick_return.dynamics(0, shifted[2], qd[2])[0], expected[2])


def test_refusals_say_what_is_needed(quick_return):
    q, qd = quick_return.initial()
    n = len(q)
    with pytest.raises(linkwright.ArgumentError, match=rf"q: an array of shape \({n},\)"):
        quick_return.dynamics(0, q[:-1], qd)
    with pytest.raises(linkwright.ArgumentError, match="qd: numbers of one state, where those before are of 2 states"):
        quick_return.dynamics(0, [q, q], qd)
    with pytest.raises(linkwright.ArgumentError, match="t: a number, or 2 of them"):
        quick_return.dynamics([0, 1, 2], [q, q], [qd, qd])
    with pytest.raises(linkwright.ArgumentError, match="q: a number of state 1"):
        quick_return.dynamics(0, [q, q * np.nan], [qd, qd])
    class Lengths(np.ndarray):
        """An array whose numbers are not all that it says."""

    for odd, says in [
        ("text", "real numbers are needed"),
        (["1"] * n, "real numbers are needed"),
        ([True] * n, "real numbers are needed"),
        (q + 1e-20j, "real numbers are needed"),
        (np.ma.masked_array(q, mask=[True] + [False] * (n - 1)), "not a MaskedArray"),
        (q.view(Lengths), "not a Lengths"),
    ]:
        with pytest.raises(linkwright.ArgumentError, match=says):
            quick_return.dynamics(0, odd, qd)
    for t in (1j, np.complex128(1), "1"):
        with pytest.raises(linkwright.ArgumentError, match="real numbers are needed"):
            quick_return.dynamics(t, q, qd)
    for t, many in [(np.nan, False), (np.inf, True), ([0, np.nan], True)]:
        with pytest.raises(linkwright.ArgumentError, match="t: .*finite"):
            quick_return.dynamics(t, [q, q] if many else q, [qd, qd] if many else qd)
    root = linkwright.load("pub Root; coordinates { x [m]; } parameters { m [kg] = 1; a [m] = 1; }\n"
                           "bodies { b: mass m at [x, 0]; } outputs { root = sqrt(x/a); }")
    with pytest.raises(linkwright.MotionError, match="not finite in state 1") as raised:
        root.outputs(0, [[1], [-1]], [[0], [0]], [[0], [0]], np.zeros((2, 0)))
    assert raised.value.states == [1] and raised.value.code == "E-NOT-FINITE"
    linkage = linkwright.load(
        "pub Rod; coordinates { x [m]; y [m]; } parameters { m [kg] = 1; } bodies { b: mass m at [x, y]; }\n"
        "constraints { length: x^2 + y^2 = 1 [m^2]; } initial { x = 1; }"
    )
    with pytest.raises(linkwright.MotionError, match="singular") as raised:
        linkage.dynamics(0, [[1, 0], [0, 0]], [[0, 0], [0, 0]])
    assert raised.value.states == [1] and raised.value.code == "E-SINGULAR"


def test_states_that_the_plan_refuses_are_solved_as_in_a_run():
    # A hinge written twice, and little inertia: phi'' = -g/l sin(phi).
    bob = linkwright.load(
        "pub Bob; coordinates { x [m]; y [m]; phi [rad]; } parameters { m [kg] = 2; I [kg*m^2] = 1e-12; l [m] = 0.5; g [m/s^2] = 9.81; }\n"
        "bodies { bob: mass m at [x, y], inertia I, angle phi; } loads { gravity [0, -g]; }\n"
        "constraints { along: x = l*sin(phi); down: y = -l*cos(phi); again: x = l*sin(phi); } initial { phi = 0.3; guess y = -0.5; }"
    )
    phi = np.array([0.3, 1.2, -2.0])
    q = np.column_stack([0.5 * np.sin(phi), -0.5 * np.cos(phi), phi])
    right = -9.81 / 0.5 * np.sin(phi)
    many = bob.dynamics(0, q, 0 * q)
    np.testing.assert_allclose(many[0][:, 2], right, rtol=1e-9)
    np.testing.assert_allclose(many[1][:, 0], many[1][:, 2], rtol=1e-9)
    for i in range(3):
        one = bob.dynamics(0, q[i], 0 * q[i])
        assert np.array_equal(one[0], many[0][i]) and np.array_equal(one[1], many[1][i])
