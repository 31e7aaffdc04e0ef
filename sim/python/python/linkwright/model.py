"""A mechanism, and everything that can be asked of it."""

from __future__ import annotations

import json
import os
import warnings
from typing import Any, Iterable, Mapping

import numpy as np

from . import _linkwright
from .errors import ArgumentError, LinkwrightWarning, in_arguments
from .results import Linearization, Motion, checked
from .simulation import Simulation
from .values import Value, assignments, declared, listed, options, repeated

#: Values by name; one that is None is as declared.
Values = Mapping[str, Value | None]


def load(source: str | os.PathLike[str], name: str | None = None) -> "Model":
    """Read a declaration and derive its equations of motion.

    Args:
        source: a file that ends in ``.mech`` or ``.rs`` (or ``FILE:Name``), a robot's file that ends in ``.urdf``, the text of a declaration (told by its braces or
            lines), or the name of a shipped model: see ``linkwright.shipped()``. Tables are read from the folder of the file
            and below it; those of a text, from the current folder.
        name: which mechanism, where there are several: ``FourBar`` or ``four-bar``.

    Raises:
        DeclarationError: with all mistakes, each at its place.
        ReadError: if the file cannot be read.
        ArgumentError: if no mechanism, or more than one, is meant.
    """
    if isinstance(source, str):
        if "{" in source or "\n" in source:
            return Model(_linkwright.from_text(source, "declaration.mech", name))
        path, colon, inside = source.rpartition(":")
        if colon and name is None and path.endswith((".mech", ".rs")):
            return Model(_linkwright.read(path, inside))
        is_file = source.endswith((".mech", ".rs", ".urdf")) or os.sep in source or "/" in source
        if not is_file and source not in _linkwright.shipped() and os.path.isfile(source):
            raise ArgumentError(f"`{source}` does not end in .mech, .rs or .urdf: rename it, or give its text")
        if not is_file:
            return Model(_linkwright.read(None, source))
    return Model(_linkwright.read(os.fspath(source), name))


def import_robot(
    path: str | os.PathLike[str],
    *,
    base: str = "fixed",
    mimic: str = "substitute",
    damping: bool = True,
    stops: bool = False,
    straighten: float | None = None,
    packages: Mapping[str, str | os.PathLike[str]] | None = None,
) -> str:
    """Write the declaration of a robot that stands in a URDF file, to be loaded or changed first.

    Warns of what the file lacks or contradicts.

    Args:
        path: the robot's file.
        base: whether the root link is ``"fixed"`` or ``"free"``.
        mimic: what becomes of joints that mimic others: ``"substitute"`` writes their value by the other's, ``"couple"`` by a
            constraint, ``"free"`` leaves them alone.
        damping: whether joints have their damping and friction.
        stops: whether limits stop joints, by impacts without rebound.
        straighten: rotations this close to a quarter turn, in radians, are set straight; 1e-11 by default.
        packages: folders of packages that meshes are in, by name.

    Raises:
        DeclarationError: with the mistakes of the file, each at its place.
        ReadError: if the file cannot be read.
    """
    folders = [(name, os.fspath(folder)) for name, folder in (packages or {}).items()]
    text, told = _linkwright.import_robot(os.fspath(path), base, mimic, damping, stops, straighten, folders)
    for message in told:
        warnings.warn(message, LinkwrightWarning, stacklevel=2)
    return text


def warn(*messages: str) -> None:
    """Warn whoever called the method that calls this."""
    for message in messages:
        warnings.warn(in_arguments(message), LinkwrightWarning, stacklevel=3)


def _restored(
    declaration: str, source: str, parameters: list[float], inputs: list[float | None], activities: list[float]
) -> "Model":
    model = _linkwright.from_text(declaration, source, None)
    return Model(model._restored(parameters, inputs, activities))


class Model(_linkwright.Model):
    """A mechanism with its parameters and inputs. It never changes, and may be used by several threads at once, but no thread may
    change an array while a kernel works on it.

    Values that are given by name, such as ``parameters={"a": 0.2}``, are in the declared unit or say theirs:
    ``"200 mm"``. Columns of results are in declared units. The kernels take and give arrays in SI units, of one state,
    q of shape (n,), or of many, q of shape (states, n) with t one number or (states,); results of many have an axis of
    states in front.
    """

    @property
    def coordinate_names(self) -> list[str]:
        """The names of q."""
        return [name for name, *_ in self._quantities("coordinates")]

    @property
    def constraint_names(self) -> list[str]:
        """The names of the constraints, whose multipliers are ``lambda_NAME``."""
        return [name for name, *_ in self._quantities("constraints")]

    @property
    def output_names(self) -> list[str]:
        """The names of the outputs."""
        return [name for name, *_ in self._quantities("outputs")]

    @property
    def parameters(self) -> dict[str, float]:
        """Parameters by name, in declared units."""
        named = self._quantities("parameters")
        return {name: _linkwright.in_unit(value, unit) for (name, unit, *_), value in zip(named, self._parameter_values())}

    @property
    def inputs(self) -> dict[str, float | None]:
        """Inputs by name, in declared units; None where the declared value holds."""
        named = zip(self._quantities("inputs"), self._input_values())
        return {name: None if value is None else _linkwright.in_unit(value, unit) for (name, unit, *_), value in named}

    @property
    def units(self) -> dict[str, str]:
        """The declared unit of every quantity; those of multipliers as ``lambda_NAME``."""
        kinds = ("coordinates", "speeds", "parameters", "inputs", "outputs")
        units = {name: unit for kind in kinds for name, unit, *_ in self._quantities(kind)}
        return units | {f"lambda_{name}": unit for name, unit, *_ in self._quantities("constraints")}

    def initial(
        self, *, parameters: Values | None = None, initial: Values | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """The start with its loops closed: q and q' in SI units, each of shape (n,).

        Args:
            parameters, initial: values by name, in place of the declared ones.
        """
        start = self.simulation(parameters=parameters, initial=initial)
        return start.positions, start.speeds

    def declared_start(self) -> tuple[np.ndarray, np.ndarray]:
        """The start as it is declared, guesses among it: q and q' in SI units, not on the constraints."""
        return self._initial()

    def with_values(self, parameters: Values | None = None, inputs: Values | None = None) -> "Model":
        """The same mechanism with other parameters, and inputs held at values."""
        as_declared = self._with_declared(parameters, inputs)
        return Model(as_declared._set(assignments(parameters), assignments(inputs)))

    def _with_declared(self, parameters: Values | None, inputs: Values | None = None) -> "Model":
        """The same with what is None as it is declared."""
        names = declared(parameters), declared(inputs)
        return Model(self._as_declared(*names)) if any(names) else self

    def run(
        self,
        t_end: Value | None = None,
        *,
        parameters: Values | None = None,
        initial: Values | None = None,
        inputs: Values | None = None,
        method: str | None = None,
        rtol: float | None = None,
        atol: float | None = None,
        steps: int | None = None,
        step: Value | None = None,
        projection: str | None = None,
        rows: int | str | None = None,
        until: str | None = None,
        comparison: bool = True,
    ) -> Motion:
        """Integrate the motion. What is not given is as the declaration's block ``run`` says, or as of ``sim run``.

        Args:
            t_end: end, in seconds.
            parameters, initial, inputs: values by name; ``initial`` of coordinates and speeds: ``{"alpha_dot": "75 rpm"}``.
            method: euler, heun, rk3, rk4, dopri5, radau5, dop853.
            rtol, atol: tolerances of a method that chooses its steps.
            steps, step: equal steps, by number or size.
            projection: projection, mass-projection, partitioning, baumgarte=RATE, none.
            rows: so many intervals between rows, or ``"steps"``.
            until: an event that ends the run, ``"period"`` or ``"period:3"``. If it does not happen, the run goes on to its
                end, with a ``LinkwrightWarning``.
            comparison: whether the run is compared with one of a smaller tolerance, which tells where errors have grown and may
                take four times as long as the run itself.

        A ``LinkwrightWarning`` also says where numbers may be wrong: energy that does not balance, errors that have grown, and equal
        steps over sudden changes. They stand in ``summary["warnings"]``.

        ``step`` is made shorter where the end is not a multiple of it. A value of a coordinate that is declared as a guess is
        a guess.

        Raises:
            MotionError: with ``result``, what was computed until then.
        """
        settings = options(
            t_end=t_end, method=method, rtol=rtol, atol=atol, steps=steps, step=step, projection=projection, rows=rows,
            until=until,
        )
        model = self._with_declared(None, inputs)
        compared = [] if comparison else ["--no-comparison"]
        found = model._motion("run", settings + compared + repeated("input", inputs), parameters, initial)
        warn(*found.summary["warnings"])
        event = found.summary["until"]
        if event is not None and event["happened"] < event["asked"]:
            happened, asked = event["happened"], event["asked"]
            end = found.summary["end"]["reached"]
            warn(f"`{event['event']}` has happened {happened} times, not {asked}, until the run has ended at {end} s")
        return found

    def assemble(self, *, parameters: Values | None = None, initial: Values | None = None) -> dict[str, Any]:
        """Close the loops at the start: coordinates and speeds with units, degrees of freedom, redundant constraints."""
        return self._summary("assemble", [], parameters, initial)

    def branches(self, *, parameters: Values | None = None, initial: Values | None = None) -> dict[str, Any]:
        """All configurations with the given coordinates of the start: elbow up and elbow down. None if it cannot be closed."""
        return self._summary("assemble", ["--branches"], parameters, initial)

    def equilibrium(self, *, parameters: Values | None = None, initial: Values | None = None) -> dict[str, Any]:
        """Find the equilibrium near the start: coordinates, multipliers, and eigenvalues of small motions.

        A ``LinkwrightWarning`` says where it holds at one time alone, or at a corner of what acts. They stand in its ``"warnings"``.
        """
        found = self._summary("equilibrium", [], parameters, initial)
        warn(*found["warnings"])
        return found

    def linearize(
        self,
        at: Value = "equilibrium",
        *,
        inputs: str | Iterable[str] = (),
        parameters: Values | None = None,
        initial: Values | None = None,
    ) -> Linearization:
        """Linearise about an equilibrium, the start (``"initial"``) or the state at a time.

        Args:
            at: ``"equilibrium"``, ``"initial"``, or a time in seconds.
            inputs: names of inputs or parameters, for B and D; all inputs unless given.

        A ``LinkwrightWarning`` says where an output has no derivative, so that rows of C and D are not numbers, or where what acts has
        a corner, so that small motions differ to either side. They stand in ``summary["warnings"]``.
        """
        words = options(at=at) + [f"--input={name}" for name in listed(inputs)]
        found = Linearization(self._asked("linearize", words, parameters, initial))
        warn(*found.summary["warnings"])
        return found

    def kinematics(
        self,
        drive: str | None = None,
        *,
        start: Value | None = None,
        to: Value | None = None,
        speed: Value | None = None,
        steps: int | None = None,
        hold: str | Iterable[str] | Values = (),
        parameters: Values | None = None,
        initial: Values | None = None,
    ) -> Motion:
        """Drive a coordinate or an output through a range, without integration.

        Args:
            drive: what is driven; the first given coordinate unless said.
            start, to: the range, in the declared unit or with one; a turn unless given. The declared start is closed first, and
                the mechanism then driven to ``start``.
            speed: of what is driven.
            steps: number of positions.
            hold: other coordinates that stay, ``"phi"``, ``"phi=30deg"`` or ``{"phi": "30deg"}``.
        """
        words = options(drive=drive, to=to, speed=speed, steps=steps) + [f"--hold={name}" for name in listed(hold)]
        words += [] if start is None else [word.replace("--start", "--from", 1) for word in options(start=start)]
        return self._motion("kinematics", words, parameters, initial)

    def poincare(
        self,
        event: str,
        *,
        direction: str | None = None,
        count: int | None = None,
        t_end: Value | None = None,
        rtol: float | None = None,
        parameters: Values | None = None,
        initial: Values | None = None,
    ) -> Motion:
        """The states of a motion each time an event happens, and its period in ``summary``.

        Args:
            event: which event.
            direction: rising, falling or both.
            count: so many states.
        """
        words = options(event=event, direction=direction, count=count, t_end=t_end, rtol=rtol)
        found = self._motion("poincare", words, parameters, initial)
        if count is not None and len(found.t) < count:
            warn(f"`{event}` has happened {len(found.t)} times, not {count}: the motion went on to its end")
        return found

    def verify(
        self, t_end: Value | None = None, *, parameters: Values | None = None, initial: Values | None = None
    ) -> list[dict[str, Any]]:
        """Compare kernels, equations and runs with independent computations.

        Each is a dictionary: ``name``, ``figure``, ``bound``, ``passes``, and ``what`` the figure means.

        Raises:
            ResultError: if a check fails; its ``result`` has all of them.
        """
        answer = self._asked("verify", options(t_end=t_end), parameters, initial)
        checks: list[dict[str, Any]] = json.loads(answer.summary)
        return checked(answer, checks)

    def simulation(
        self,
        t_end: Value | None = None,
        *,
        parameters: Values | None = None,
        initial: Values | None = None,
        inputs: Values | None = None,
        method: str | None = None,
        rtol: float | None = None,
        atol: float | None = None,
        steps: int | None = None,
        step: Value | None = None,
        projection: str | None = None,
        until: str | None = None,
    ) -> Simulation:
        """A motion that you advance yourself; arguments are those of ``run``. It ends at ``t_end``, after 2 s unless given."""
        settings = options(
            t_end=t_end, method=method, rtol=rtol, atol=atol, steps=steps, step=step, projection=projection, until=until
        )
        given = repeated("set", parameters) + repeated("initial", initial) + repeated("input", inputs)
        model = self._with_declared(parameters, inputs)
        return Simulation(model._simulated(["run", self._word, *settings, *given]))

    def equations(self, notation: str = "text") -> str:
        """The equations of motion as ``"text"``, ``"latex"`` or ``"mathml"``."""
        heading = {"latex": "\\subsection*{{{}}}\n", "mathml": "<h2>{}</h2>\n"}.get(notation, "# {}\n\n")
        return "\n".join(heading.format(title) + text for title, text in self._equation_groups(notation))

    def _factors(self) -> dict[str, float]:
        """The sizes of the units of coordinates and speeds in SI units."""
        return {name: size for kind in ("coordinates", "speeds") for name, _, size, _ in self._quantities(kind)}

    def _asked(
        self, command: str, words: list[str], parameters: Values | None, initial: Values | None
    ) -> _linkwright.Answer:
        given = repeated("set", parameters) + repeated("initial", initial)
        return self._with_declared(parameters)._answer([command, self._word, *words, *given])

    @property
    def _word(self) -> str:
        """The source as a word of a command line, which is no option."""
        return f"./{self.source}" if self.source.startswith("-") else self.source

    def _summary(
        self, command: str, words: list[str], parameters: Values | None, initial: Values | None
    ) -> dict[str, Any]:
        summary: dict[str, Any] = json.loads(self._asked(command, words, parameters, initial).summary)
        return summary

    def _motion(self, command: str, words: list[str], parameters: Values | None, initial: Values | None) -> Motion:
        answer = self._asked(command, words, parameters, initial)
        return checked(answer, Motion(answer, self._factors()))

    def __reduce__(self) -> tuple[Any, ...]:
        values = self._parameter_values(), self._input_values(), self._activities()
        return _restored, (self.declaration, self.source, *values)

    def __repr__(self) -> str:
        n, m = len(self.coordinate_names), len(self.constraint_names)
        return f"<model {self.name}: {n} coordinates, {m} constraints>"
