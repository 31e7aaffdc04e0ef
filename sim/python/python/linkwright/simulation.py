"""A motion that its owner advances."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ._linkwright import Simulation as _Simulation
from .errors import ArgumentError
from .values import Value, seconds, written

if TYPE_CHECKING:
    from .model import Model


class Simulation:
    """A motion that its owner advances, step by step or to a time. In between, inputs and parameters may be set.

    Positions, speeds, accelerations and multipliers are arrays in SI units, in the order of declaration.
    """

    def __init__(self, simulation: _Simulation) -> None:
        self._simulation = simulation

    @property
    def time(self) -> float:
        """In seconds."""
        return self._simulation.time

    @property
    def positions(self) -> np.ndarray:
        """q, of shape (n,)."""
        return self._simulation.state()[0]

    @property
    def speeds(self) -> np.ndarray:
        """q', of shape (n,)."""
        return self._simulation.state()[1]

    @property
    def accelerations(self) -> np.ndarray:
        """q'', of shape (n,)."""
        return self._simulation.sample()[0]

    @property
    def multipliers(self) -> np.ndarray:
        """lambda, of shape (m,)."""
        return self._simulation.sample()[1]

    @property
    def model(self) -> "Model":
        """The mechanism with its parameters and inputs now. Kernels have the constraints that events have switched; runs and
        analyses begin with those that are declared.

        ``simulation.model.outputs(time, q, qd, qdd, multipliers)`` gives the outputs.
        """
        from .model import Model  # which makes simulations

        return Model(self._simulation.model())

    @property
    def has_ended(self) -> bool:
        """Whether the end of the motion is reached, or an event that ends it."""
        return self._simulation.has_ended

    @property
    def events(self) -> list[tuple[str, float]]:
        """The names and times of past events."""
        return self._simulation.events

    def step(self) -> bool:
        """Make one step. False if none was left to make."""
        return self._simulation.step()

    @property
    def t_end(self) -> float:
        """When the motion ends, if no event ends it before, in seconds."""
        return self._simulation.t_end

    def advance_to(self, time: float) -> bool:
        """Advance to a time in seconds, at which a step ends. False if an event has ended the motion before.

        Ctrl-C ends it after a step.

        Raises:
            ArgumentError: if the time is past, later than ``t_end``, or no number.
        """
        return self._simulation.advance_to(seconds(time))

    def set_parameter(self, name: str, value: Value) -> None:
        """Set a parameter, in its declared unit or with a unit: ``"20 mm"``. The loops are closed anew."""
        self._simulation.set_parameter(name, written(value))

    def set_input(self, name: str, value: Value | None) -> None:
        """Hold an input at a value; None gives it back its declared value."""
        self._simulation.set_input(name, None if value is None else written(value))

    def save(self) -> bytes:
        """Everything needed to continue with the same bits."""
        return bytes(self._simulation.save())

    def restore(self, saved: bytes) -> None:
        """Continue from where another simulation of the same mechanism with the same settings was saved."""
        if not isinstance(saved, (bytes, bytearray, memoryview)):
            raise ArgumentError(f"{type(saved).__name__}: the bytes that `save()` gave are needed")
        self._simulation.restore(bytes(saved))

    def __reduce__(self) -> str:
        raise TypeError("a simulation cannot be pickled: `save()` gives its state as bytes, and `restore()` takes them")

    def __repr__(self) -> str:
        return f"<simulation at t = {self.time!r} s>"
