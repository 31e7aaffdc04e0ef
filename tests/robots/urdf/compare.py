"""Every robot of the package `example-robot-data` against Pinocchio: forward and inverse dynamics, mass matrix and energies.

    compare.py SIM [NAME ..]
    compare.py SIM --reference FILE

SIM is the program; names choose the files whose paths contain one of them. With `--reference` Pinocchio's numbers of the shipped
robots are written. Each robot is imported with a fixed and with a free
base, with joints that mimic others left alone and without damping, since Pinocchio's reader knows neither. What `sim evaluate` prints at
random states is compared with Pinocchio's algorithms, relative to the largest number. Prints a line for each robot and
one with all of them; exit status 1 if anything differs.
"""

import csv
import io
import json
import re
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pinocchio as pin

STATES = 20
# Relative to the largest number of a result, and never less than FLOOR.
BOUND, FLOOR = 1e-11, 1e-12
GRAVITY = 9.81
# Of equations whose mass matrix is nearly singular: some ten roundings.
RESIDUAL = 1e-14
NAMES = {
    "forward": "forward dynamics",
    "inverse": "inverse dynamics",
    "mass": "mass matrix",
    "kinetic": "kinetic energy",
    "potential": "potential energy",
    "residual": "equations of nearly singular robots",
}
LARGEST = {name: 0.0 for name in NAMES.values()}
# Differences of accelerations that the condition of the mass matrix explains, by robot.
CONDITIONED = {}


def robots():
    package = Path(pin.__file__).parents[3]
    found = sorted(package.glob("**/cmeel.prefix/share/example-robot-data/robots/**/*.urdf"))
    return found or sorted(Path(sys.prefix).glob("**/example-robot-data/robots/**/*.urdf"))


def skew(a):
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def times(p, q):
    """The product of quaternions, scalar part first."""
    return np.append(p[0] * q[0] - p[1:] @ q[1:], p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))


class Robot:
    """A robot in Pinocchio, and the coordinates of its declaration."""

    def __init__(self, path, is_free, folder, sim, options=()):
        self.sim, self.is_free = sim, is_free
        self.model = (
            pin.buildModelFromUrdf(str(path), pin.JointModelFreeFlyer()) if is_free else pin.buildModelFromUrdf(str(path))
        )
        self.data = self.model.createData()
        self.file = folder / f"{path.stem}-{'free' if is_free else 'fixed'}.mech"
        base = "free" if is_free else "fixed"
        words = [sim, "import", path, "--base", base, "--mimic", "free", "--no-damping", "-q", "-o", self.file, *options]
        subprocess.run(words, check=True, capture_output=True)
        text = self.file.read_text()
        self.names = re.findall(r"^    (\w+) \[(?:rad|m)\];$", text, re.M)
        joints = [j.get("name") for j in ElementTree.parse(path).getroot().findall("joint") if j.get("type") != "fixed"]
        self.joints = [self.model.joints[self.model.getJointId(name)] for name in joints]
        assert len(self.joints) == len(self.names), "as many coordinates as joints"
        self.base, self.centre = None, np.zeros(3)
        if is_free:
            self.base = re.search(r"^    (\w+): free, mass", text, re.M).group(1)
            frame = re.search(rf"at on\({self.base}, \[(.*)\]\), attitude attitude\({self.base}\);", text).group(1)
            self.centre = -np.array([float(x.replace("[m]", "")) for x in frame.split(",")])
        self.masses = []
        heights = ""
        for k, (mass, place) in enumerate(re.findall(r"^    \w+: mass (\S+) \[kg\] at (on\(.*?\]\)), inertia", text, re.M)):
            self.masses.append(float(mass))
            heights += f"    height_of_{k} [m] = {place}.z;\n"
        if is_free:
            self.masses.append(float(re.search(r"free, mass (\S+) \[kg\]", text).group(1)))
            heights += f"    height_of_base [m] = on({self.base}, [0, 0, 0]).z;\n"
        self.file.write_text(text + f"\noutputs {{\n{heights}}}\n")

    def columns(self):
        base = [f"{self.base}_{x}" for x in "x y z q0 q1 q2 q3".split()] if self.is_free else []
        return self.names + base

    def own(self, q, v, a):
        """Coordinates, rates and accelerations of the declaration for those of Pinocchio."""
        x, x1, x2 = [], [], []
        for joint in self.joints:
            i, k = joint.idx_q, joint.idx_v
            x.append(np.arctan2(q[i + 1], q[i]) if joint.nq == 2 else q[i])
            x1.append(v[k])
            x2.append(a[k])
        if self.is_free:
            turn, c = pin.Quaternion(q[6], q[3], q[4], q[5]).matrix(), self.centre
            p = np.array([q[6], q[3], q[4], q[5]])
            linear, w, dlinear, dw = v[:3], v[3:6], a[:3], a[3:6]
            x += list(q[:3] + turn @ c) + list(p)
            p1 = times(p, np.append(0, w)) / 2
            x1 += list(turn @ (linear + np.cross(w, c))) + list(p1)
            centre2 = dlinear + np.cross(w, linear) + np.cross(dw, c) + np.cross(w, np.cross(w, c))
            p2 = (times(p1, np.append(0, w)) + times(p, np.append(0, dw))) / 2
            x2 += list(turn @ centre2) + list(p2)
        return x, x1, x2

    def accelerations(self, q, v, own):
        """The accelerations of Pinocchio for those of the declaration."""
        a = np.zeros(self.model.nv)
        for joint, acceleration in zip(self.joints, own):
            a[joint.idx_v] = acceleration
        if self.is_free:
            turn, c, w = pin.Quaternion(q[6], q[3], q[4], q[5]).matrix(), self.centre, v[3:6]
            p, centre2, p2 = np.array([q[6], q[3], q[4], q[5]]), own[-7:-4], own[-4:]
            p1 = times(p, np.append(0, w)) / 2
            back = np.array([1, -1, -1, -1])
            dw = 2 * (times(back * p, p2) + times(back * p1, p1))[1:]
            a[:3] = turn.T @ centre2 - np.cross(w, v[:3]) - np.cross(dw, c) - np.cross(w, np.cross(w, c))
            a[3:6] = dw
        return a

    def residual(self, at, tau, own):
        """What Newton-Euler's recursion leaves of the torques at accelerations of the declaration, relative to its terms."""
        (q, v), data = at, self.data
        a = self.accelerations(q, v, own)
        left = pin.rnea(self.model, data, q, v, a) - tau
        mass = pin.crba(self.model, data, q)
        mass = np.triu(mass) + np.triu(mass, 1).T
        return np.max(np.abs(left)) / np.max(np.abs(mass) @ np.abs(a) + np.abs(tau))

    def forces(self, q, tau):
        """Generalised forces of the declaration's coordinates for those of Pinocchio's speeds."""
        out = [tau[joint.idx_v] for joint in self.joints]
        if self.is_free:
            turn = pin.Quaternion(q[6], q[3], q[4], q[5]).matrix()
            w, x, y, z = q[6], q[3], q[4], q[5]
            spin = 2 * np.array([[-x, w, z, -y], [-y, -z, w, x], [-z, y, -x, w]])
            out += list(turn @ tau[:3])
            out += list(spin.T @ tau[3:6] + (skew(self.centre) @ spin).T @ tau[:3])
        return out

    def mass_matrix(self, q):
        """In the declaration's speeds: those of the joints, then those of the base at its centre of mass."""
        mass = pin.crba(self.model, self.data, q)
        mass = np.triu(mass) + np.triu(mass, 1).T
        order = [joint.idx_v for joint in self.joints]
        if self.is_free:
            change = np.eye(self.model.nv)
            change[:3, 3:6] = skew(self.centre)
            mass = change.T @ mass @ change
            order += list(range(6))
        return mass[np.ix_(order, order)]

    def evaluate(self, kernel, states, inputs=()):
        names = self.columns()
        heading = names + [f"{n}_dot" for n in names] + [f"{n}_ddot" for n in names]
        norm = [f"lambda_{self.base}_norm"] if self.is_free else []
        rows = [[repr(float(x)) for x in sum(state, [])] + ["0"] * len(norm) for state in states]
        table = io.StringIO()
        csv.writer(table).writerows([heading + norm] + rows)
        words = [self.sim, "evaluate", self.file, "--kernel", kernel, "--at", "-"]
        words += [word for given in inputs for word in ("--input", given)]
        done = subprocess.run(words, input=table.getvalue(), capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        rows = list(csv.reader(io.StringIO(done.stdout)))
        kept = [k for k, name in enumerate(rows[0]) if name not in ("t [s]", "refused")]
        heads = [rows[0][k] for k in kept]
        numbers = [[float(row[k]) if row[k] else np.nan for k in kept] for row in rows[1:]]
        return heads, np.array(numbers), [row[-1] == "1" for row in rows[1:]]


def differs(own, known):
    """The largest difference at all states, relative to the largest number."""
    known = np.array(known).ravel()
    own = np.asarray(own).ravel()
    return float(np.max(np.abs(own - known)) / max(np.max(np.abs(known)), FLOOR / BOUND)) if len(own) else 0.0


def pinocchio(robot, count, strength=5.0):
    """Random states of the declaration, what Pinocchio finds there, the torques, and the worst condition of mass matrices."""
    model, data = robot.model, robot.data
    random = np.random.default_rng(1)
    states, places, known = [], [], {k: [] for k in ("forward", "inverse", "mass", "kinetic", "potential")}
    tau = strength * random.uniform(-1, 1, model.nv)
    if robot.is_free:
        tau[:6] = 0
    singular = 0.0
    for _ in range(count):
        q = pin.neutral(model)
        for joint in robot.joints:
            angle = random.uniform(-2, 2)
            if joint.nq == 2:
                q[joint.idx_q], q[joint.idx_q + 1] = np.cos(angle), np.sin(angle)
            else:
                q[joint.idx_q] = angle
        if robot.is_free:
            q[:3] = random.uniform(-1, 1, 3)
            q[3:7] = random.normal(size=4)
            q[3:7] /= np.linalg.norm(q[3:7])
        v, a = random.uniform(-1, 1, model.nv), random.uniform(-1, 1, model.nv)
        states.append(robot.own(q, v, a))
        places.append((q, v))
        mass = robot.mass_matrix(q)
        sizes = np.sqrt(np.abs(np.diag(mass)))
        scaled = mass / np.outer(np.where(sizes > 0, sizes, 1), np.where(sizes > 0, sizes, 1))
        singular = max(singular, np.linalg.cond(scaled))
        known["forward"].append(robot.own(q, v, pin.aba(model, data, q, v, tau))[2])
        known["inverse"].append(robot.forces(q, pin.rnea(model, data, q, v, a)))
        known["mass"].append(mass)
        known["kinetic"].append(pin.computeKineticEnergy(model, data, q, v))
        moving = range(1, len(model.inertias))
        pin.forwardKinematics(model, data, q)
        heights = [(data.oMi[k].act(model.inertias[k].lever))[2] * model.inertias[k].mass for k in moving]
        known["potential"].append(GRAVITY * sum(heights))
    return states, known, tau, singular, places


def compare(robot):
    states, known, tau, singular, places = pinocchio(robot, STATES)
    inputs = [f"tau_{name}={float(tau[joint.idx_v])!r}" for name, joint in zip(robot.names, robot.joints)]
    found = {}
    found["inverse"] = robot.evaluate("inverse_dynamics", states)[1]
    found["mass"] = robot.evaluate("speed_mass_matrix" if robot.is_free else "mass_matrix", states)[1]
    found["kinetic"] = robot.evaluate("kinetic_energy", states)[1]
    heads, outputs, _ = robot.evaluate("outputs", states) if robot.masses else ([], [], [])
    of = [k for k, head in enumerate(heads) if head.startswith("height_of_")]
    found["potential"] = [GRAVITY * sum(m * row[k] for m, k in zip(robot.masses, of)) for row in outputs]
    worst = {}
    heads, forward, refused = robot.evaluate("dynamics", states, inputs)
    count = len(robot.columns())
    found["forward"] = forward[:, :count]
    for what, values in known.items():
        if what == "forward" and (singular > 1e15 or any(refused)):
            continue
        if what == "potential" and not robot.masses:
            continue
        worst[what] = differs(found[what], values)
    names = singular > 1e15 or any(refused)
    if worst.get("forward", 0) > BOUND:
        # Nearly singular: the solution is known to rounding times the condition, but the equations hold.
        left = max(robot.residual(at, tau, own) for at, own in zip(places, found["forward"]))
        if left <= RESIDUAL:
            worst["residual"] = left
            CONDITIONED[robot.file.stem] = worst.pop("forward")
    return worst, names, singular


def named_in(robot):
    """The joint that a run names where accelerations are not determined."""
    with tempfile.TemporaryDirectory() as out:
        words = [robot.sim, "run", robot.file, "--t-end", "0.01", "--out", out, "--no-report", "--no-figures"]
        said = subprocess.run(words, capture_output=True, text=True)
    match = re.search(r"acceleration of `(\w+)`", said.stderr)
    return match.group(1) if match and said.returncode == 1 else None


def one(task):
    path, is_free, folder, sim = task
    base = "free" if is_free else "fixed"
    begin = time.monotonic()
    label = f"{path.parent.parent.name}/{path.stem} {base}"
    said = subprocess.run([sim, "check", path], capture_output=True, text=True)
    if "there is no robot here" in said.stderr:
        return label, "no robot", True
    try:
        robot = Robot(path, is_free, folder, sim)
    except AssertionError as error:
        return label, str(error), False
    except subprocess.CalledProcessError as error:
        message = error.stderr.decode()
        return label, "nothing moves" if "nothing moves" in message else message, "nothing moves" in message and not is_free
    worst, is_singular, condition = compare(robot)
    straightened = ""
    if any(value > BOUND for value in worst.values()):
        # Quarter turns that a file writes with 12 digits are exact in its declaration; without that they are not.
        straightened = f" as the file writes its angles, and {max(worst.values()):.1e} with quarter turns set straight"
        again = folder / base
        again.mkdir()
        worst, is_singular, condition = compare(Robot(path, is_free, again, sim, ["--straighten", "0"]))
    text = ", ".join(f"{what} {value:.1e}" for what, value in worst.items())
    text += straightened
    for what, value in worst.items():
        LARGEST[NAMES[what]] = max(LARGEST[NAMES[what]], value)
    is_right = all(value <= BOUND for value in worst.values())
    if is_singular:
        name = named_in(robot)
        text += f"; singular, named: {name}"
        is_right &= name is not None
    return label, f"{len(robot.columns())} coordinates: {text} ({time.monotonic() - begin:.1f} s, cond {condition:.0e})", is_right


def write_reference(sim, file):
    """Three states of each shipped robot, without torques."""
    robots, out = Path(__file__).resolve().parents[3] / "sim/examples/robots", {}
    with tempfile.TemporaryDirectory() as folder:
        for name in ("arm", "quadruped"):
            for is_free in (False, True):
                robot = Robot(robots / f"{name}.urdf", is_free, Path(folder), sim)
                states, known, *_ = pinocchio(robot, 3, 0.0)
                rows = []
                for k, (q, qd, qdd) in enumerate(states):
                    row = {"q": q, "qd": qd, "qdd": qdd, "forward": known["forward"][k], "inverse": known["inverse"][k]}
                    row["mass"] = known["mass"][k].ravel()
                    rows.append({what: [float(x) for x in numbers] for what, numbers in row.items()})
                out[f"{name} {'free' if is_free else 'fixed'}"] = rows
    file.write_text(json.dumps(out, indent=1) + "\n")
    return 0


def main():
    sim, chosen = sys.argv[1], sys.argv[2:]
    if chosen[:1] == ["--reference"]:
        return write_reference(sim, Path(chosen[1]))
    files = [path for path in robots() if not chosen or any(name in str(path) for name in chosen)]
    with tempfile.TemporaryDirectory() as folder:
        tasks = []
        for k, path in enumerate(files):
            own = Path(folder) / str(k)
            own.mkdir()
            tasks += [(path, is_free, own, sim) for is_free in (False, True)]
        with ThreadPoolExecutor(2) as pool:
            wrong = 0
            for label, text, is_right in pool.map(one, tasks):
                print(f"{'ok   ' if is_right else 'WRONG'} {label}: {text}", flush=True)
                wrong += not is_right
    print(f"{len(files)} files, fixed and free: {len(tasks) - wrong} right")
    print(f"robots that differ or are read wrongly: {wrong}")
    for name, difference in CONDITIONED.items():
        print(f"accelerations of {name} differ by {difference:.1e}, and solve the equations")
    for what, largest in LARGEST.items():
        print(f"{what}, largest difference: {largest:.1e}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
