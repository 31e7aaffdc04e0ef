"""What several tests need."""

import pytest

import linkwright

SLIDER = """
/// A mass on a spring.
pub Oscillator;
coordinates { x [mm]; }
parameters { m [kg] = 2; k [N/m] = 8; }
inputs { F [N] = 0; }
bodies { mass: mass m at [x, 0]; }
loads { force [F - k*x, 0] at [x, 0]; }
initial { x = 100 [mm]; dot(x) = 0; }
events { middle: x = 0; }
outputs { twice [m] = 2*x; }
"""


@pytest.fixture
def oscillator():
    return linkwright.load(SLIDER)


@pytest.fixture
def quick_return():
    return linkwright.load("quick-return")
