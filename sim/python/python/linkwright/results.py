"""What commands find."""

from __future__ import annotations

import html
import json
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterator, Mapping, TypeVar

import numpy as np

from ._linkwright import Answer
from .errors import ArgumentError, MotionError, ResultError

if TYPE_CHECKING:
    import pandas

_Result = TypeVar("_Result")

#: Of the frame that shows a report in a notebook, in pixels.
_HEIGHT = 760


class Motion(Mapping[str, np.ndarray]):
    """The columns of a motion, by name: ``motion["alpha_dot"]``.

    Columns are those of ``trajectory.csv``: time ``t``, coordinates, speeds, accelerations, multipliers ``lambda_NAME``,
    work and outputs. All have the same length, and are in the units that ``units`` tells.

    Attributes:
        columns: name to array.
        units: name to unit.
        summary: everything else, as in ``summary.json``.
    """

    def __init__(self, answer: Answer, factors: Mapping[str, float]) -> None:
        named = answer.columns()
        self._factors = dict(factors)
        self.columns: dict[str, np.ndarray] = {name: values for name, _, values in named}
        self.units: dict[str, str] = {name: unit for name, unit, _ in named}
        self.summary: dict[str, Any] = json.loads(answer.summary)
        self._answer: Answer | None = answer
        self._report: str | None = None

    @property
    def t(self) -> np.ndarray:
        """Times, in seconds."""
        return self.columns["t"]

    def states(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """t, q and q' of all rows in SI units, of shapes (rows,), (rows, n) and (rows, n): what kernels take."""
        coordinates = [name for name in self._factors if f"{name}_dot" in self._factors]
        q, qd = ([f"{name}{of}" for name in coordinates] for of in ("", "_dot"))
        return self.t, self._in_si_units(q), self._in_si_units(qd)

    def _in_si_units(self, names: list[str]) -> np.ndarray:
        columns = [self.columns[name] * self._factors[name] for name in names]
        return np.stack(columns, axis=1) if columns else np.empty((len(self.t), 0))

    @property
    def events(self) -> list[dict[str, Any]]:
        """The events of a run, in order of time."""
        events: list[dict[str, Any]] = self.summary.get("events", [])
        return events

    def __getitem__(self, name: str) -> np.ndarray:
        try:
            return self.columns[name]
        except KeyError:
            known = ", ".join(self.columns)
            raise KeyError(f"no column is called {name!r}; there are {known}") from None

    # As of an object: columns are arrays, which have no truth value.
    __eq__ = object.__eq__
    __hash__ = object.__hash__

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def __repr__(self) -> str:
        model, rows = self.summary.get("model"), len(self.t)
        return f"<motion of {model}: {len(self.columns)} columns of {rows} rows>"

    def to_pandas(self) -> "pandas.DataFrame":
        """The columns as a data frame. Units are in its ``attrs["units"]``."""
        import pandas

        frame = pandas.DataFrame(self.columns, copy=False)
        frame.attrs["units"] = dict(self.units)
        return frame

    def report(self) -> str | None:
        """The report as a page: the mechanism in motion, plots and tables. None of a motion that has no report.

        A motion that was pickled has one if it was drawn before.
        """
        if self._report is None and self._answer is not None:
            self._report = self._answer.report()
        return self._report

    def save_report(self, path: str | os.PathLike[str]) -> None:
        """Write the report to a file, which any browser shows without a network."""
        page = self.report()
        if page is None:
            raise ArgumentError("this motion has no report")
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(page)

    def _repr_html_(self) -> str | None:
        """The report, in a frame that reaches nothing of the notebook."""
        page = self.report()
        if page is None:
            return None
        page = html.escape(page, quote=True)
        return (
            f'<iframe sandbox="allow-scripts" srcdoc="{page}" '
            f'style="width: 100%; height: {_HEIGHT}px; border: 0"></iframe>'
        )

    def __getstate__(self) -> dict[str, Any]:
        """A motion that is pickled keeps its report if that has been drawn before."""
        return {**self.__dict__, "_answer": None}


@dataclass(frozen=True)
class Mode:
    """A mode of small motions. Its shape has an entry for each coordinate, the largest of magnitude 1."""

    eigenvalue: complex
    #: In hertz.
    frequency: float
    damping_ratio: float
    shape: dict[str, complex]
    #: Whether the eigenvalue is 0 but for rounding: the motion stays where it is, or drifts.
    neutral: bool


class Linearization:
    """x' = A x + B u, y = C x + D u about a state; all in SI units.

    Attributes:
        A, B, C, D: arrays.
        states, inputs, outputs: the names of x, u and y.
        eigenvalues: of A, complex.
        modes: with frequencies and shapes.
        steady: whether A is constant along the motion.
        summary: everything, as in ``linear.json``.
    """

    def __init__(self, answer: Answer) -> None:
        self.summary: dict[str, Any] = json.loads(answer.summary)
        said = self.summary
        n, inputs, outputs = len(said["states"]), len(said["inputs"]), len(said["outputs"])
        self.A = _matrix(said["A"], n, n)
        self.B = _matrix(said["B"], n, inputs)
        self.C = _matrix(said["C"], outputs, n)
        self.D = _matrix(said["D"], outputs, inputs)
        self.states: list[str] = said["states"]
        self.inputs: list[str] = said["inputs"]
        self.outputs: list[str] = said["outputs"]
        self.steady: bool = said["steady"]
        self.eigenvalues = np.array([complex(*value) for value in said["eigenvalues"]], dtype=complex)
        self.modes = [_mode(mode) for mode in said["modes"]]

    def __repr__(self) -> str:
        return f"<linearization of {self.summary['model']}: states {', '.join(self.states)}>"


def _matrix(rows: list[list[float | None]], height: int, width: int) -> np.ndarray:
    """A row of an output that has no derivative is not a number; ``outputs_without_derivative`` names it."""
    return np.array(rows, dtype=float).reshape(height, width)


def _mode(said: dict[str, Any]) -> Mode:
    shape = {name: entry["amplitude"] * np.exp(1j * entry["phase"]) for name, entry in said["shape"].items()}
    return Mode(complex(*said["eigenvalue"]), said["frequency_hz"], said["damping_ratio"], shape, said["neutral"])


def checked(answer: Answer, result: _Result) -> _Result:
    """The result; or, if something is wrong with it, an exception that has it."""
    problem = answer.problem
    if problem is None:
        return result
    if problem.code == "E-INTERRUPTED":
        raise KeyboardInterrupt
    if isinstance(problem, (MotionError, ResultError)):
        problem.result = result
    raise problem
