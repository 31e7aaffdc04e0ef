"""Arguments as the command line writes them."""

from __future__ import annotations

import math
from typing import Any, Iterable, Mapping, Union

import numpy as np

from .errors import ArgumentError

#: A number in the declared unit, or a text with a unit: ``"180 mm"``.
Value = Union[float, str]


def written(value: Value) -> str:
    """A value as the command line reads it, to the last digit."""
    if isinstance(value, str):
        return value
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise ArgumentError(f"{value!r}: a number is needed, or a text with a unit such as '180 mm'")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise ArgumentError(f"{value!r} is not finite")
    return repr(number)


def seconds(time: float) -> float:
    """A time as a number; its range is checked where it is used."""
    if isinstance(time, (str, bool)):
        raise ArgumentError(f"{time!r}: a number of seconds is needed")
    try:
        return float(time)
    except (TypeError, ValueError, OverflowError):
        raise ArgumentError(f"{time!r}: a number of seconds is needed") from None


def assignments(values: Mapping[str, Value | None] | None) -> list[str]:
    """``NAME=VALUE`` each. Those that are None are left out: see ``declared``."""
    return [f"{name}={written(value)}" for name, value in _by_name(values) if value is not None]


def declared(values: Mapping[str, Value | None] | None) -> list[str]:
    """The names whose value is None: they are as declared."""
    return [name for name, value in _by_name(values) if value is None]


def _by_name(values: Mapping[str, Value | None] | None) -> Iterable[tuple[str, Value | None]]:
    if values is None:
        return ()
    if not isinstance(values, Mapping):
        raise ArgumentError(f"{values!r}: values by name are needed, such as {{'a': 0.2}}")
    return values.items()


def repeated(option: str, values: Mapping[str, Value | None] | None) -> list[str]:
    """An option for each value."""
    return [f"--{option}={assignment}" for assignment in assignments(values)]


def listed(names: str | Iterable[str] | Mapping[str, Value]) -> list[str]:
    """One name, or several; each may have a value, as ``"phi=30deg"`` or ``{"phi": 30}``."""
    if isinstance(names, str):
        return [names]
    return assignments(names) if isinstance(names, Mapping) else list(names)


def options(**given: Any) -> list[str]:
    """Options that are given. Underscores are hyphens, as in ``t_end``."""
    words = []
    for name, value in given.items():
        if value is None:
            continue
        option = f"--{name.replace('_', '-')}"
        if isinstance(value, (bool, np.bool_)):
            raise ArgumentError(f"{name}: {value!r}: a number or a text is needed")
        if isinstance(value, (int, np.integer)):
            words.append(f"{option}={int(value)}")
        elif name == "projection" and isinstance(value, str):
            words.append(f"{option}={value.replace('_', '-')}")
        else:
            words.append(f"{option}={written(value)}")
    return words
