"""Robots from URDF."""

import pickle
from pathlib import Path

import numpy as np
import pytest

import linkwright

ARM = Path(__file__).resolve().parents[2] / "examples" / "robots" / "arm.urdf"


def test_a_robots_file_is_loaded_as_it_is():
    arm = linkwright.load(ARM)
    q, qd = arm.initial()
    assert arm.coordinate_names[0] == "waist" and q.shape == (6,)
    torques = arm.inverse_dynamics(0.0, q, qd, np.zeros(6))
    # The axis of the waist is upright; the shoulder bears weight, but for the arm's stretched start it is small.
    assert torques[0] == pytest.approx(0, abs=1e-12)
    again = pickle.loads(pickle.dumps(arm))
    np.testing.assert_array_equal(again.dynamics(0.0, q, qd)[0], arm.dynamics(0.0, q, qd)[0])


def test_an_import_is_a_declaration_with_its_warnings():
    with pytest.warns(linkwright.LinkwrightWarning, match="is called `left_finger_link`"):
        text = linkwright.import_robot(ARM, base="free", damping=False)
    assert len(linkwright.load(text).initial()[0]) == 13 and "damping" not in text


def test_what_is_no_robot_is_an_exception_at_its_place(tmp_path):
    file = tmp_path / "no.urdf"
    file.write_text("<robot name=\"a\">\n</robot>")
    with pytest.raises(linkwright.DeclarationError, match="there is no robot here"):
        linkwright.load(file)
    with pytest.raises(linkwright.ArgumentError, match="known are fixed and free"):
        linkwright.import_robot(ARM, base="floating")
