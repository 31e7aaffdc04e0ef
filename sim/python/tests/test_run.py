"""Motions against closed forms, and against the command line."""

import csv
import io
import math
import subprocess
import sys

import numpy as np
import pytest

import linkwright


def test_a_motion_is_the_closed_form(oscillator):
    run = oscillator.run(t_end=3, rows=300, rtol=1e-12)
    omega = math.sqrt(8 / 2)
    assert run.units["x"] == "mm" and run.units["twice"] == "m"
    # Ten times the tolerance, along 300 rows.
    np.testing.assert_allclose(run["x"], 100 * np.cos(omega * run.t), rtol=0, atol=1e-8)
    np.testing.assert_allclose(run["twice"], 0.2 * np.cos(omega * run.t), rtol=0, atol=1e-11)
    assert run.t[-1] == 3 and len(run.t) == 301
    first = next(event for event in run.events if event["name"] == "middle")
    assert first["time"] == pytest.approx(math.pi / 2 / omega, abs=1e-10)


def test_values_have_units(oscillator):
    a = oscillator.run("500 ms", parameters={"m": "2000 g"}, initial={"x": "0.1 m"}, inputs={"F": 1})
    b = oscillator.run(0.5, parameters={"m": 2}, initial={"x": 100}, inputs={"F": "1000 mN"})
    assert np.array_equal(a["x"], b["x"]) and a["x"][-1] != oscillator.run(0.5)["x"][-1]
    held = oscillator.with_values({"m": 3}, {"F": 1})
    assert held.parameters["m"] == 3 and held.inputs == {"F": 1.0}
    assert np.array_equal(held.run(1)["x"], oscillator.run(1, parameters={"m": 3}, inputs={"F": 1})["x"])


def test_columns_are_those_of_the_command(quick_return, tmp_path):
    command = [sys.executable, "-m", "linkwright", "run", "quick-return", "--t-end=0.2", "--no-figures",
               "--no-report", "--quiet", f"--out={tmp_path}"]
    subprocess.run(command, check=True)
    rows = list(csv.reader(io.StringIO((tmp_path / "trajectory.csv").read_text())))
    run = quick_return.run(t_end=0.2)
    assert rows[0] == [f"{name} [{run.units[name]}]" for name in run]
    table = np.array(rows[1:], dtype=float)
    for column, name in enumerate(run):
        assert np.array_equal(table[:, column], run[name]), name


@pytest.mark.parametrize("name", linkwright.shipped())
def test_every_shipped_model_runs(name):
    model = linkwright.load(name)
    run = model.run(t_end="1 ms", rows=2)
    assert model.name == name and run.t[-1] == 1e-3
    assert all(np.isfinite(values).all() for values in run.values())


def test_what_was_computed_is_kept():
    text = "pub Root; coordinates { x [m]; } parameters { m [kg] = 1; } bodies { b: mass m at [x, 0]; }\n" \
           "loads { force [-sqrt(x*1 [1/m])*1 [N], 0] at [x, 0]; } initial { x = 1; dot(x) = -2; }"
    with pytest.raises(linkwright.MotionError) as raised:
        linkwright.load(text).run(t_end=5)
    error = raised.value
    assert error.code.startswith("E-") and error.result is not None
    assert 0 < error.result.t[-1] < 5 and error.time == pytest.approx(error.result.t[-1], abs=0.1)
    assert error.place == f"t = {error.time!r} s"


def test_frames(oscillator):
    run = oscillator.run(1, rows=10)
    pandas = pytest.importorskip("pandas")
    frame = run.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and list(frame) == list(run) and frame.attrs["units"]["x"] == "mm"
    page = run.report()
    assert page.startswith("<!doctype html>") or page.startswith("<!DOCTYPE html>")
    shown = run._repr_html_()
    assert shown.startswith('<iframe sandbox="allow-scripts" srcdoc="') and "<script" not in shown
    with pytest.raises(KeyError, match="no column is called"):
        run["y"]


def test_rows_are_states_of_the_kernels(quick_return, oscillator):
    """Accelerations of the rows are those of the kernel at them, whatever the declared units."""
    for model in (quick_return, oscillator):
        run = model.run(0.2, rows=20)
        qdd, _ = model.dynamics(*run.states())
        names = model.coordinate_names
        sizes = [size for _, _, size, _ in model._quantities("coordinates")]
        expected = np.stack([run[f"{name}_ddot"] * size for name, size in zip(names, sizes)], axis=1)
        # Units cost a rounding each way.
        np.testing.assert_allclose(qdd, expected, rtol=1e-12, atol=1e-12 * np.abs(expected).max())


def test_a_start_has_closed_loops(quick_return):
    shorter = quick_return.with_values({"O2A": "150 mm"})
    q, qd = shorter.initial(initial={"alpha": "20 deg"})
    assert abs(shorter.constraints(0, q)).max() < 1e-12 and q[0] == pytest.approx(math.radians(20), rel=1e-15)
    assert abs(shorter.constraint_jacobian(0, q) @ qd).max() < 1e-12
    assert abs(shorter.constraints(0, shorter.declared_start()[0])).max() > 1e-3


def test_an_event_that_does_not_happen_is_told(oscillator):
    with pytest.warns(linkwright.LinkwrightWarning, match="`middle` has happened 0 times, not 1"):
        run = oscillator.run(0.1, until="middle")
    assert run.summary["until"] == {"event": "middle", "asked": 1, "happened": 0}
    with pytest.warns(linkwright.LinkwrightWarning, match="`middle` has happened 1 times, not 9"):
        assert len(oscillator.poincare("middle", count=9, t_end=1).t) == 1


def test_numbers_of_numpy_and_single_names(oscillator):
    assert len(oscillator.run(1, rows=np.int64(10)).t) == 11
    assert oscillator.run(1, method="rk4", steps=np.int64(100), parameters={"m": np.array(2.0)}).t[-1] == 1
    assert oscillator.linearize(inputs="F").inputs == ["F"]
    held = oscillator.with_values({"m": 3}, {"F": 5})
    free = held.with_values({"m": None}, {"F": None})
    assert free.inputs == {"F": None} and free.parameters == oscillator.parameters
    assert np.array_equal(held.run(1, parameters={"m": None}, inputs={"F": None})["x"], oscillator.run(1)["x"])
    moved = held.simulation(t_end=1, parameters={"m": None}, inputs={"F": None})
    assert moved.accelerations[0] == pytest.approx(-8 / 2 * 0.1, rel=1e-12)
    with pytest.raises(linkwright.ArgumentError, match="values by name"):
        oscillator.run(parameters="m=2")
    run = oscillator.run(0.1)
    assert run == run and run != oscillator.run(0.1) and len({run}) == 1


def test_results_name_the_values_that_they_are_of(quick_return):
    shorter = quick_return.with_values({"O2A": "150 mm"})
    sweep = shorter.kinematics("alpha", to="90 deg", speed="75 rpm", steps=4)
    assert "'--set=O2A=0.15 m'" in sweep.summary["provenance"]["command"]
    assert "--set 'O2A=0.15 m'" in shorter.run(0.1).summary["provenance"]["command"]


def test_numbers_that_may_be_wrong_come_with_a_warning():
    spring = linkwright.load(
        "pub A; coordinates { x [m]; } parameters { m [kg] = 1; k [N/m] = 1e4; } bodies { b: mass m at [x, 0]; }\n"
        "loads { force -k*x on x; } initial { x = 1; }"
    )
    # Equal steps of twice the time in which x changes by itself.
    with pytest.warns(linkwright.LinkwrightWarning, match="energy does not balance"):
        run = spring.run(5, method="rk4", step=0.02)
    off, energy = run.summary["warnings"]
    assert off.startswith("`x` is off by") and energy.startswith("energy does not balance")
    assert spring.run(0.5).summary["warnings"] == []


def test_tolerances_of_the_declaration_hold_one_by_one():
    declared = linkwright.load(
        "pub A; coordinates { x [m]; } parameters { m [kg] = 1; k [N/m] = 4; } bodies { b: mass m at [x, 0]; }\n"
        "loads { spring k, rest 0 on x; } initial { x = 1; } run { rtol = 1e-9; atol = 1e-6; }"
    )
    def tolerances(**given):
        stepping = declared.run(1, **given).summary["method"]["stepping"]
        return stepping["rtol"], stepping["atol"]
    assert tolerances() == (1e-9, 1e-6)
    assert tolerances(rtol=1e-7) == (1e-7, 1e-6)
    assert tolerances(atol=1e-5) == (1e-9, 1e-5)


def test_what_is_held_has_a_value_by_name():
    arm = linkwright.load(
        "pub AR; coordinates { a [deg]; b [deg]; } parameters { l [m] = 0.3; m [kg] = 1; }\n"
        "let E = l*[cos(a), sin(a)]; bodies { e: mass m at E; p: mass m at E + l*[cos(b), sin(b)]; } initial { a = 30; b = 45; }"
    )
    for hold in ["b=30", ["b=30"], {"b": 30}, {"b": "30 deg"}]:
        assert arm.kinematics("a", hold=hold)["b"][0] == pytest.approx(30)
    assert arm.kinematics("a", hold="b")["b"][0] == pytest.approx(45)


def test_unknown_names_are_refused_without_a_value_too(oscillator):
    for given in ({"parameters": {"mm": None}}, {"inputs": {"G": None}}):
        with pytest.raises(linkwright.ArgumentError, match="mm|G"):
            oscillator.run(t_end=0.1, **given)
        with pytest.raises(linkwright.ArgumentError, match="mm|G"):
            oscillator.with_values(**given)


def test_runs_are_compared_with_a_smaller_tolerance():
    chaos = linkwright.load(
        """pub Chaos; coordinates { a [rad]; b [rad]; }
        let P = 1 [m]*[sin(a), -cos(a)]; let Q = P + 1 [m]*[sin(b), -cos(b)];
        bodies { p: mass 1 [kg] at P; q: mass 1 [kg] at Q; } loads { gravity [0, -9.81 [m/s^2]]; }
        initial { a = 2; b = 2; }"""
    )
    assert chaos.run(1).summary["compared_with_rtol"] < 1e-10
    with pytest.warns(linkwright.LinkwrightWarning, match=r"is off by .*\(`rtol`\)"):
        assert chaos.run(60).summary["off_from_tolerance"]["by"] > 0.1
    alone = chaos.run(60, comparison=False).summary
    assert alone["compared_with_rtol"] is None and alone["off_from_tolerance"] is None


def test_values_by_name_have_the_bits_of_the_declaration():
    units, rng = ["mm", "um", "inch", "km", "cm", "ft"], np.random.default_rng(5)
    values = {f"p{i}": float(f"{rng.uniform(-1, 1) * 10.0 ** rng.integers(-3, 4):.6g}") for i in range(120)}
    declared = " ".join(f"{name} [{units[i % 6]}] = {value!r};" for i, (name, value) in enumerate(values.items()))
    model = linkwright.load("pub Many; coordinates { x [m]; } parameters { " + declared + " } bodies { b: mass 1 [kg] at [x, 0]; }\n"
                            "loads { force 1 [N/m]*(" + " + ".join(values) + ") on x; }")
    assert model.parameters == values
    assert model.with_values(values)._parameter_values() == model._parameter_values()
    in_words = {name: f"{value!r} {model.units[name]}" for name, value in values.items()}
    assert model.with_values(in_words)._parameter_values() == model._parameter_values()
    shown = linkwright.load("cart-pole").parameters
    assert shown["start"] == 170
