"""The compiled part. Use the classes of the package instead."""

from typing import Any, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import LinkwrightError

Array = NDArray[np.float64]
Times = Union[float, ArrayLike]

def shipped() -> list[str]:
    """The names of the shipped models."""

def main(words: Sequence[str]) -> int:
    """Execute a command line, which begins with the program's name, and give its exit status."""

def from_text(text: str, path: str, name: Optional[str]) -> Model: ...
def read(path: Optional[str], name: Optional[str]) -> Model: ...

class Answer:
    @property
    def summary(self) -> str: ...
    @property
    def problem(self) -> Optional[LinkwrightError]: ...
    def columns(self) -> list[tuple[str, str, Array]]: ...
    def report(self) -> Optional[str]: ...

class Simulation:
    @property
    def time(self) -> float: ...
    @property
    def has_ended(self) -> bool: ...
    @property
    def events(self) -> list[tuple[str, float]]: ...
    def state(self) -> tuple[Array, Array]: ...
    def sample(self) -> tuple[Array, Array]: ...
    def step(self) -> bool: ...
    def advance_to(self, time: float) -> None: ...
    def set_parameter(self, name: str, value: str) -> None: ...
    def set_input(self, name: str, value: Optional[str]) -> None: ...
    def save(self) -> bytes: ...
    def restore(self, saved: bytes) -> None: ...

class Model:
    """Kernels at one state, q of shape (n,), or at many, (states, n); all in SI units."""

    def __new__(cls, other: Model) -> Model: ...
    @property
    def name(self) -> str:
        """The name: ``four-bar``."""
    @property
    def docs(self) -> str:
        """The documentation of the declaration."""
    @property
    def declaration(self) -> str:
        """The text of the declaration, with its tables written out."""
    @property
    def declaration_hash(self) -> str:
        """The same however the text is laid out."""
    @property
    def source(self) -> str:
        """The file, or the name of the shipped model."""
    def quantities(self, kind: str) -> list[tuple[str, str, float, str]]:
        """Name, unit, size of the unit in SI units and documentation, of a kind."""
    @property
    def event_names(self) -> list[str]:
        """The names of the events."""
    def parameter_values(self) -> list[float]:
        """Parameters in SI units."""
    def input_values(self) -> list[Optional[float]]:
        """Values of the inputs that are held, in SI units."""
    def initial(self) -> tuple[Array, Array]:
        """The declared start, not yet assembled: q and q', each (n,)."""
    def mass_matrix(self, t: Times, q: ArrayLike) -> Array:
        """M, (n, n)."""
    def constraints(self, t: Times, q: ArrayLike) -> Array:
        """C, (m,)."""
    def constraint_magnitudes(self, t: Times, q: ArrayLike) -> Array:
        """The magnitudes of the terms of C, (m,)."""
    def constraint_jacobian(self, t: Times, q: ArrayLike) -> Array:
        """C_q, (m, n)."""
    def constraint_time_derivative(self, t: Times, q: ArrayLike) -> Array:
        """C_t, (m,)."""
    def constraint_linearization(self, t: Times, q: ArrayLike) -> tuple[Array, Array, Array]:
        """C (m,), C_t (m,) and C_q (m, n)."""
    def sparse_linearization(self, t: Times, q: ArrayLike) -> tuple[Array, Array, Array]:
        """C (m,), C_t (m,) and the entries of C_q that are not zero everywhere."""
    def drawing(self, t: Times, q: ArrayLike) -> Array:
        """The numbers of the drawing."""
    def convective_forces(self, t: Times, q: ArrayLike, qd: ArrayLike) -> Array:
        """Convective inertia forces, (n,)."""
    def generalized_forces(self, t: Times, q: ArrayLike, qd: ArrayLike) -> Array:
        """Q, (n,)."""
    def constraint_convective(self, t: Times, q: ArrayLike, qd: ArrayLike) -> Array:
        """Convective terms of C'', (m,)."""
    def kinetic_energy(self, t: Times, q: ArrayLike, qd: ArrayLike) -> Union[float, Array]:
        """In joules."""
    def dynamics(self, t: Times, q: ArrayLike, qd: ArrayLike) -> tuple[Array, Array]:
        """q'' (n,) and lambda (m,)."""
    def dynamics_jacobian(self, t: Times, q: ArrayLike, qd: ArrayLike) -> tuple[Array, Array, Array, Array]:
        """d q''/dq (n, n), d q''/dq' (n, n), d lambda/dq (m, n), d lambda/dq' (m, n)."""
    def dynamics_sensitivity(self, t: Times, q: ArrayLike, qd: ArrayLike) -> tuple[Array, Array]:
        """d q''/dp (n, p) and d lambda/dp (m, p) by the parameters p."""
    def velocity_variables(self, t: Times, q: ArrayLike, qd: ArrayLike) -> Array:
        """Generalised speeds of q', (n,)."""
    def velocities(self, t: Times, q: ArrayLike, qd: ArrayLike) -> Array:
        """q' of generalised speeds, (n,)."""
    def event_values(self, t: Times, q: ArrayLike, qd: ArrayLike) -> Array:
        """The values that actions of events need."""
    def inverse_dynamics(self, t: Times, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike) -> Array:
        """The generalised forces that give these accelerations, (n,)."""
    def output_rates(self, t: Times, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike) -> Array:
        """The rates of outputs that have one."""
    def power(
        self, t: Times, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, multipliers: ArrayLike
    ) -> Union[float, Array]:
        """The power of loads and drives, in watts."""
    def events(self, t: Times, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, multipliers: ArrayLike) -> Array:
        """The conditions of the events."""
    def outputs(self, t: Times, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, multipliers: ArrayLike) -> Array:
        """The outputs, in SI units."""
    def generate_rust(self) -> str:
        """The kernels as Rust."""
