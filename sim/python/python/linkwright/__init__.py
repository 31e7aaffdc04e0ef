"""Mechanisms from a declaration to their motion.

>>> import linkwright
>>> m = linkwright.load("pendulum")
>>> run = m.run(t_end="1 s", parameters={"l": "50 cm"})
>>> bool(run.t[-1] == 1.0)
True
"""

from ._linkwright import shipped
from .errors import (
    ArgumentError,
    DeclarationError,
    LinkwrightError,
    LinkwrightWarning,
    Mistake,
    MotionError,
    ReadError,
    ResultError,
)
from .model import Model, import_robot, load
from .results import Linearization, Mode, Motion
from .simulation import Simulation

__all__ = [
    "ArgumentError",
    "DeclarationError",
    "Linearization",
    "LinkwrightError",
    "LinkwrightWarning",
    "Mistake",
    "Mode",
    "Model",
    "Motion",
    "MotionError",
    "ReadError",
    "ResultError",
    "Simulation",
    "import_robot",
    "load",
    "shipped",
]
