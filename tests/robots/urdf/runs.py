"""Runs of the robots of the package `example-robot-data`.

    runs.py SIM first          the time from a robot's file to report and figures, as a process
    runs.py SIM trip [NAME ..] what `sim import` writes runs to the same bytes as the robot's file
"""

import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from compare import robots

RUNS = 5


def first(sim):
    for name, path in (("Panda", "panda_description/urdf/panda.urdf"), ("Talos", "talos_data/robots/talos_reduced.urdf")):
        file = next(robot for robot in robots() if str(robot).endswith(path))
        times = []
        with tempfile.TemporaryDirectory() as out:
            for _ in range(RUNS):
                begin = time.monotonic()
                subprocess.run([sim, "run", file, "--out", out, "-q"], check=True, capture_output=True)
                times.append(time.monotonic() - begin)
        print(f"{name}, in s: {sorted(times)[RUNS // 2]:.3f}")
    return 0


def trip(sim, chosen):
    files = [path for path in robots() if not chosen or any(name in str(path) for name in chosen)]
    with tempfile.TemporaryDirectory() as folder:

        def differs(task):
            at, file = task
            written = Path(folder) / f"{at}.mech"
            if subprocess.run([sim, "import", file, "-q", "-o", written], capture_output=True).returncode != 0:
                return None
            found = []
            for k, source in enumerate((file, written)):
                out = Path(folder) / f"{at}-{k}"
                words = [sim, "run", source, "--out", out, "--t-end", "0.2", "--rows", "50", "-q", "--no-report", "--no-png"]
                done = subprocess.run(words, capture_output=True, text=True)
                # Figures carry the name of their run, which differs with the file's name.
                table = out / "trajectory.csv"
                found.append((done.returncode, done.stderr, table.read_bytes() if table.exists() else b""))
            return found[0] != found[1]

        with ThreadPoolExecutor(2) as pool:
            results = list(zip(files, pool.map(differs, enumerate(files))))
    for file, is_other in results:
        if is_other:
            print(f"other bytes: {file}")
    read = [is_other for _, is_other in results if is_other is not None]
    print(f"{len(read)} robots run from their files and from their imports")
    print(f"robots whose import runs to other bytes than their file: {sum(read)}")
    return 1 if any(read) else 0


if __name__ == "__main__":
    sys.exit(first(sys.argv[1]) if sys.argv[2] == "first" else trip(sys.argv[1], sys.argv[3:]))
