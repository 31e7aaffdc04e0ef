"""What can go wrong. Every exception has a code, a message and, where there is one, a place."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

#: An option of the command line, not a part of a name.
_OPTION = re.compile(r"(?<![\w-])--([a-z][a-z-]*)")
#: Arguments that have another name here.
_ARGUMENTS = {"set": "parameters", "input": "inputs", "from": "start"}


def _as_argument(option: re.Match[str]) -> str:
    """The argument of a method that stands for an option of the command line."""
    name = option[1].replace("-", "_")
    return _ARGUMENTS.get(name, name)


def in_arguments(message: str) -> str:
    """A message of the command line with the arguments of methods in place of its options."""
    return _OPTION.sub(_as_argument, message)


class LinkwrightError(Exception):
    """Something failed.

    Attributes:
        code: what kind of failure, for programs: ``E-NOT-ASSEMBLED``.
        message: what is wrong and, where that is known, what would be right.
        place: where: a file with line and column, or a time; or None.
    """

    code = "E-FAILED"

    def __init__(self, message: str, **details: Any) -> None:
        super().__init__(message)
        self.message = message
        self.code = details.pop("code", type(self).code)
        self.place: str | None = None
        self._details = details

    def __reduce__(self) -> tuple[Any, ...]:
        details = {**self._details, "code": self.code}
        return _again, (type(self), self.message, details, getattr(self, "result", None))


def _again(kind: type[LinkwrightError], message: str, details: dict[str, Any], result: Any) -> LinkwrightError:
    error = kind(message, **details)
    if result is not None:
        setattr(error, "result", result)
    return error


class LinkwrightWarning(UserWarning):
    """Results are right, but may not be what was asked for."""


class ArgumentError(LinkwrightError, ValueError):
    """An argument is not what is needed."""

    code = "E-ARGUMENT"

    def __init__(self, message: str, **details: Any) -> None:
        super().__init__(in_arguments(message), **details)


class ReadError(LinkwrightError, OSError):
    """A file cannot be read."""

    code = "E-READ"

    def __str__(self) -> str:
        return self.message


@dataclass(frozen=True)
class Mistake:
    """A mistake in a declaration. Lines and columns are counted from 1, as editors show them."""

    code: str
    message: str
    line: int
    column: int
    end_line: int
    end_column: int
    #: The word that would be right, if it is known.
    suggestion: str | None
    #: The line.
    words: str | None
    #: Other places that belong to it: what stands there, line and column.
    related: list[tuple[str, int, int]]


class DeclarationError(LinkwrightError):
    """A declaration has mistakes.

    Attributes:
        mistakes: all of them, each at its place.
    """

    code = "E-DECLARATION"

    def __init__(self, message: str, **details: Any) -> None:
        super().__init__(message, **details)
        self.mistakes = [Mistake(**mistake) for mistake in details.get("mistakes", ())]
        if self.mistakes:
            first = self.mistakes[0]
            self.code = first.code
            self.place = f"{details.get('path')}:{first.line}:{first.column}"


class ResultError(LinkwrightError):
    """Results are not what they should be: a check fails, or an output is not finite.

    Attributes:
        result: what was computed.
    """

    code = "E-RESULT"
    result: Any = None


class MotionError(LinkwrightError):
    """A motion, or a computation at a state, fails.

    Attributes:
        time: when, in seconds, if it is known.
        state: coordinates there by name, in SI units.
        states: of a kernel, the states at which it fails, counted from 0.
        result: what was computed until then, or None.
    """

    code = "E-MOTION"
    result: Any = None

    def __init__(self, message: str, **details: Any) -> None:
        super().__init__(in_arguments(message), **details)
        self.time: float | None = details.get("time")
        self.state: dict[str, float] = details.get("state", {})
        self.states: list[int] = details.get("states", [])
        if self.time is not None:
            self.place = f"t = {self.time!r} s"
