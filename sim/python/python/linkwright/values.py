"""Arguments as the command line writes them."""

from __future__ import annotations

import math
from typing import Any, Mapping, Union

import numpy as np

from .errors import ArgumentError

#: A number in the declared unit, or a text with a unit: ``"180 mm"``.
Value = Union[float, str]


def written(value: Value) -> str:
    """A value as the command line reads it, to the last digit."""
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise ArgumentError(f"{value!r}: a number is needed, or a text with a unit such as '180 mm'")
    number = float(value)
    if not math.isfinite(number):
        raise ArgumentError(f"{value!r} is not finite")
    return repr(number)


def assignments(values: Mapping[str, Value] | None) -> list[str]:
    """``NAME=VALUE`` each."""
    return [f"{name}={written(value)}" for name, value in (values or {}).items()]


def repeated(option: str, values: Mapping[str, Value] | None) -> list[str]:
    """An option for each value."""
    return [f"--{option}={assignment}" for assignment in assignments(values)]


def options(**given: Any) -> list[str]:
    """Options that are given. Underscores are hyphens, as in ``t_end``."""
    words = []
    for name, value in given.items():
        if value is None or value is False:
            continue
        option = f"--{name.replace('_', '-')}"
        if value is True:
            words.append(option)
        elif isinstance(value, int):
            words.append(f"{option}={value}")
        else:
            words.append(f"{option}={written(value)}")
    return words
