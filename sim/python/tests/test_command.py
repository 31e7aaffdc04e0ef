"""The command that the wheel installs."""

import shutil
import subprocess
import sys
from pathlib import Path

import linkwright


def sim(*words, cwd=None):
    beside = Path(sys.executable).with_name("sim")
    command = str(beside) if beside.exists() else shutil.which("sim")
    return subprocess.run([command, *words], cwd=cwd, capture_output=True, text=True)


def test_it_knows_the_shipped_models(tmp_path):
    listed = sim("list")
    assert listed.returncode == 0 and all(name in listed.stdout for name in linkwright.shipped())
    run = sim("run", "quick-return", "--t-end", "0.1", "--no-png", cwd=tmp_path)
    assert run.returncode == 0, run.stderr
    assert (tmp_path / "out/quick-return/report.html").exists()
    summary = (tmp_path / "out/quick-return/summary.json").read_text()
    assert "sim run quick-return" in summary and "python" not in summary


def test_exit_statuses(tmp_path):
    assert sim("run", "nothing").returncode == 2
    assert sim("run", "no.mech").returncode == 1
    made = sim("new", "--file", "--from", "four-bar", "mine.mech", cwd=tmp_path)
    assert made.returncode == 0 and sim("check", "mine.mech", cwd=tmp_path).returncode == 0
    again = sim("run", "mine.mech", "--no-figures", "--quiet", cwd=tmp_path)
    assert again.returncode == 0 and again.stderr == ""
