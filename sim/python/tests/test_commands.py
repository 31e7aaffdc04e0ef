"""Everything else that can be asked of a mechanism."""

import math

import numpy as np
import pytest

import linkwright


def test_a_linearization_is_the_closed_form(oscillator):
    found = oscillator.linearize(inputs=["F"])
    np.testing.assert_allclose(found.A, [[0, 1], [-4, 0]], atol=1e-12)
    np.testing.assert_allclose(found.B, [[0], [0.5]], atol=1e-12)
    np.testing.assert_allclose(found.C, [[2, 0]], atol=1e-12)
    assert found.D.shape == (1, 1) and found.states == ["x", "x_dot"] and found.steady
    assert found.modes[0].frequency == pytest.approx(2 / (2 * math.pi), rel=1e-12)
    assert sorted(found.eigenvalues.imag) == pytest.approx([-2, 2])


def test_equilibria_and_starts(oscillator):
    rest = oscillator.equilibrium(parameters={"k": "16 N/m"})
    assert rest["coordinates"]["x"] == {"value": pytest.approx(0, abs=1e-9), "unit": "mm"}
    start = oscillator.assemble(initial={"x": "2 cm"})
    assert start["coordinates"]["x"]["value"] == pytest.approx(20) and start["degrees_of_freedom"] == 1
    assert len(linkwright.load("four-bar").branches()["branches"]) == 2


def test_kinematics(quick_return):
    sweep = quick_return.kinematics("alpha", start=0, to="360 deg", speed="75 rpm", steps=36)
    assert len(sweep.t) >= 37 and sweep.summary["cycle"]
    assert sweep.summary["outputs"]["x6"]["time_ratio"]["ratio"] > 1
    assert "<canvas" in sweep.report()


def test_sections():
    found = linkwright.load("pendulum").poincare("bottom", direction="rising", count=3, t_end=20)
    agm = (1, math.cos(math.pi / 4))
    for _ in range(6):
        agm = (sum(agm) / 2, math.sqrt(agm[0] * agm[1]))
    period = 2 * math.pi / math.sqrt(9.81) / agm[0]
    assert found.summary["period"]["seconds"] == pytest.approx(period, rel=1e-8)
    assert np.diff(found.t) == pytest.approx([period, period], rel=1e-8)


def test_checks(oscillator):
    checks = oscillator.verify(t_end=0.5)
    assert checks and all(check["passes"] for check in checks)


def test_texts(quick_return):
    assert "\\begin{align*}" in quick_return.equations("latex")
    assert "<math" in quick_return.equations("mathml")
    assert quick_return.equations().startswith("# ")
    assert "pub struct QuickReturn" in quick_return.generate_rust()
    with pytest.raises(linkwright.ArgumentError, match="known: text, latex, mathml"):
        quick_return.equations("html")


def test_mistakes_have_places(tmp_path):
    text = "pub A;\ncoordinates { x [m]; }\nparameters { m [kg] = 1; }\nbodies { b: mass n at [x, 0]; }\n"
    with pytest.raises(linkwright.DeclarationError) as raised:
        linkwright.load(text)
    [mistake] = raised.value.mistakes
    assert (mistake.line, mistake.column, mistake.code) == (4, 18, "E-MEANING") and "`n`" in mistake.message
    assert raised.value.place == "declaration.mech:4:18" and "bodies" in str(raised.value)
    with pytest.raises(linkwright.DeclarationError) as raised:
        linkwright.load(text.replace("m [kg] = 1;", "m [kg] = 1; m [kg] = 2;").replace("mass n", "mass m"))
    assert raised.value.mistakes[0].related == [("the first definition of `m` is here", 3, 14)]
    file = tmp_path / "a.mech"
    file.write_text(text.replace("mass n", "mass m"))
    assert linkwright.load(file).name == linkwright.load(f"{file}:A").name == "a"
    with pytest.raises(linkwright.ReadError, match="cannot read"):
        linkwright.load("nowhere/b.mech")
    with pytest.raises(linkwright.ArgumentError, match="did you mean `four-bars`"):
        linkwright.load("four-bars2")


@pytest.mark.parametrize(
    "given, says",
    [
        ({"parameters": {"q": 1}}, "no parameter is called `q`"),
        ({"parameters": {"m": "2 m"}}, "is a unit of dimension"),
        ({"parameters": {"m": True}}, "a number is needed"),
        ({"parameters": {"m": float("nan")}}, "is not finite"),
        ({"parameters": ["m=1"]}, "values by name are needed"),
        ({"t_end": True}, "t_end: True: a number or a text"),
        ({"until": np.False_}, "until: .*False.*: a number or a text"),
        ({"method": "rk5"}, "no method is called `rk5`"),
        ({"t_end": -1}, "above 0"),
        ({"steps": 0, "method": "rk4"}, "above 0"),
        ({"until": "period"}, "no event is called `period`"),
        ({"rtol": 1}, "`?rtol"),
    ],
)
def test_arguments_are_checked(oscillator, given, says):
    with pytest.raises(linkwright.ArgumentError, match=says):
        oscillator.run(**given)


def test_a_motion_that_cannot_be_verified_says_why():
    four_bar = linkwright.load("four-bar").with_values({"a": "5 m"})
    with pytest.raises(linkwright.MotionError) as raised:
        four_bar.verify()
    assert raised.value.code == "E-NOT-ASSEMBLED" and raised.value.place == "t = 0.0 s"


def test_messages_speak_of_arguments(oscillator):
    with pytest.raises(linkwright.ArgumentError) as raised:
        oscillator.run(t_end=-1)
    assert "t_end" in str(raised.value) and "--" not in str(raised.value)


def test_names_are_kept_as_they_are(tmp_path):
    with pytest.raises(linkwright.ReadError, match="robot--version.mech"):
        linkwright.load("nowhere/robot--version.mech")
    model = linkwright.load("pub Same; coordinates { x [m]; } parameters { m [kg] = 1; l [m] = 1; }\n"
                            "bodies { b: mass m at [x, 0]; } constraints { x: x = l; }")
    assert model.units["x"] == "m" and model.units["lambda_x"] == "N"


def test_what_matrices_may_not_be_is_told():
    text = "pub Bent; coordinates {{ x [m]; }} inputs {{ u [N] = {input}; }} bodies {{ a: mass 1 [kg] at [x, 0]; }}\n" \
        "loads {{ force u - (if x > 0 then 40 [N/m] else 10 [N/m])*x on x; }} outputs {{ v [m/s] = norm([dot(x), 0]); }}"
    bent = linkwright.load(text.format(input="0"))
    with pytest.warns(linkwright.LinkwrightWarning) as told:
        found = bent.linearize()
    assert [str(warning.message) for warning in told] == found.summary["warnings"]
    assert "has a corner" in found.summary["warnings"][0] and "v: no derivative here" in found.summary["warnings"][1]
    assert np.isnan(found.C).all()
    with pytest.warns(linkwright.LinkwrightWarning, match="has a corner"):
        bent.equilibrium()
    with pytest.warns(linkwright.LinkwrightWarning, match="holds at t = 0 alone"):
        linkwright.load(text.format(input="5 [N]*cos(3 [rad/s]*t)")).equilibrium()
