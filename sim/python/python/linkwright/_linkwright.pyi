"""The compiled part. Use the classes of the package instead."""

from typing import Optional, Sequence, Union, final

import numpy as np
from numpy.typing import ArrayLike, NDArray
from typing_extensions import disjoint_base

from .errors import LinkwrightError

__all__ = ["Answer", "Model", "Simulation", "from_text", "import_robot", "in_unit", "main", "read", "shipped"]

_Array = NDArray[np.float64]
_Times = Union[float, ArrayLike]

def shipped() -> list[str]:
    """The names of the shipped models."""

def main(words: Sequence[str]) -> int:
    """Execute a command line, which begins with the program's name, and give its exit status."""

def import_robot(
    path: str,
    base: str,
    mimic: str,
    damping: bool,
    stops: bool,
    straighten: Optional[float],
    packages: Sequence[tuple[str, str]],
) -> tuple[str, list[str]]:
    """The declaration of a robot's file, and what the file lacks or contradicts."""

def from_text(text: str, path: str, name: Optional[str]) -> Model: ...
def read(path: Optional[str], name: Optional[str]) -> Model: ...
def in_unit(value: float, unit: str) -> float:
    """A value in SI units in a unit: the number that a declaration would have for it."""

@final
class Answer:
    @property
    def summary(self) -> str: ...
    @property
    def problem(self) -> Optional[LinkwrightError]: ...
    def columns(self) -> list[tuple[str, str, _Array]]: ...
    def report(self) -> Optional[str]: ...

@final
class Simulation:
    @property
    def time(self) -> float: ...
    @property
    def has_ended(self) -> bool: ...
    @property
    def events(self) -> list[tuple[str, float]]: ...
    def state(self) -> tuple[_Array, _Array]: ...
    def sample(self) -> tuple[_Array, _Array]: ...
    def step(self) -> bool: ...
    @property
    def t_end(self) -> float: ...
    def advance_to(self, time: float) -> bool: ...
    def set_parameter(self, name: str, value: str) -> None: ...
    def set_input(self, name: str, value: Optional[str]) -> None: ...
    def model(self) -> Model: ...
    def save(self) -> bytes: ...
    def restore(self, saved: bytes) -> None: ...

@disjoint_base
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
    def _quantities(self, kind: str) -> list[tuple[str, str, float, str]]:
        """Name, unit, size of the unit in SI units and documentation, of a kind."""
    @property
    def event_names(self) -> list[str]:
        """The names of the events."""
    def _parameter_values(self) -> list[float]:
        """Parameters in SI units."""
    def _input_values(self) -> list[Optional[float]]:
        """Values of the inputs that are held, in SI units."""
    def _activities(self) -> list[float]:
        """For each constraint that events switch, 1 where it holds and 0 where it is released."""
    def _initial(self) -> tuple[_Array, _Array]:
        """The declared start, not yet assembled: q and q', each (n,)."""
    def mass_matrix(self, t: _Times, q: ArrayLike) -> _Array:
        """M, (n, n)."""
    def speed_mass_matrix(self, t: _Times, q: ArrayLike) -> _Array:
        """The mass matrix in speeds, with free bodies by their velocities; the declaration has to request it."""
    def constraints(self, t: _Times, q: ArrayLike) -> _Array:
        """C, (m,)."""
    def constraint_magnitudes(self, t: _Times, q: ArrayLike) -> _Array:
        """The magnitudes of the terms of C, (m,)."""
    def constraint_jacobian(self, t: _Times, q: ArrayLike) -> _Array:
        """C_q, (m, n)."""
    def constraint_time_derivative(self, t: _Times, q: ArrayLike) -> _Array:
        """C_t, (m,)."""
    def constraint_linearization(self, t: _Times, q: ArrayLike) -> tuple[_Array, _Array, _Array]:
        """C (m,), C_t (m,) and C_q (m, n)."""
    def sparse_linearization(self, t: _Times, q: ArrayLike) -> tuple[_Array, _Array, _Array]:
        """C (m,), C_t (m,) and the entries of C_q that are not zero everywhere."""
    def drawing(self, t: _Times, q: ArrayLike) -> _Array:
        """The numbers of the drawing."""
    def convective_forces(self, t: _Times, q: ArrayLike, qd: ArrayLike) -> _Array:
        """Convective inertia forces, (n,)."""
    def generalized_forces(self, t: _Times, q: ArrayLike, qd: ArrayLike) -> _Array:
        """Q, (n,)."""
    def constraint_convective(self, t: _Times, q: ArrayLike, qd: ArrayLike) -> _Array:
        """Convective terms of C'', (m,)."""
    def kinetic_energy(self, t: _Times, q: ArrayLike, qd: ArrayLike) -> Union[float, _Array]:
        """In joules."""
    def dynamics(self, t: _Times, q: ArrayLike, qd: ArrayLike) -> tuple[_Array, _Array]:
        """q'' (n,) and lambda (m,)."""
    def dynamics_jacobian(self, t: _Times, q: ArrayLike, qd: ArrayLike) -> tuple[_Array, _Array, _Array, _Array]:
        """d q''/dq (n, n), d q''/dq' (n, n), d lambda/dq (m, n), d lambda/dq' (m, n)."""
    def dynamics_sensitivity(self, t: _Times, q: ArrayLike, qd: ArrayLike) -> tuple[_Array, _Array]:
        """d q''/dp (n, p) and d lambda/dp (m, p) by the parameters p."""
    def velocity_variables(self, t: _Times, q: ArrayLike, qd: ArrayLike) -> _Array:
        """Generalised speeds of q', (n,)."""
    def velocities(self, t: _Times, q: ArrayLike, qd: ArrayLike) -> _Array:
        """q' of generalised speeds, (n,)."""
    def switching_functions(self, t: _Times) -> _Array:
        """Functions of time alone where expressions change their form."""
    def event_values(self, t: _Times, q: ArrayLike, qd: ArrayLike) -> _Array:
        """The values that actions of events need."""
    def load_conditions(self, t: _Times, q: ArrayLike, qd: ArrayLike) -> _Array:
        """The conditions of loads on positions and speeds."""
    def inverse_dynamics(self, t: _Times, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike) -> _Array:
        """The generalised forces that give these accelerations, (n,)."""
    def output_rates(self, t: _Times, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike) -> _Array:
        """The rates of outputs that have one."""
    def power(
        self, t: _Times, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, multipliers: ArrayLike
    ) -> Union[float, _Array]:
        """The power of loads and drives, in watts."""
    def events(self, t: _Times, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, multipliers: ArrayLike) -> _Array:
        """The conditions of the events."""
    def outputs(self, t: _Times, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, multipliers: ArrayLike) -> _Array:
        """The outputs, in SI units."""
    def _set(self, parameters: Sequence[str], inputs: Sequence[str]) -> Model:
        """The same with other values, each as ``NAME=VALUE``."""
    def _as_declared(self, parameters: Sequence[str], inputs: Sequence[str]) -> Model:
        """The same with these parameters and inputs as they are declared."""
    def _restored(
        self, parameters: Sequence[float], inputs: Sequence[Optional[float]], activities: Sequence[float]
    ) -> Model:
        """The same with values in SI units, as many as there are."""
    def _answer(self, words: Sequence[str]) -> Answer:
        """Execute a command line on this mechanism."""
    def _simulated(self, words: Sequence[str]) -> Simulation:
        """A motion with the settings of a command line ``run``."""
    def _equation_groups(self, notation: str) -> list[tuple[str, str]]:
        """The equations of motion: headings and texts."""
    def generate_rust(self) -> str:
        """The kernels as Rust."""
