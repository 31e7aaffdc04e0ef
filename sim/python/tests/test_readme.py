"""The Python lines of the READMEs do what they say."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1]
READMES = [PACKAGE / "README.md", PACKAGE.parents[1] / "README.md"]


@pytest.mark.parametrize("readme", READMES, ids=["package", "project"])
def test_its_lines_run(readme, tmp_path):
    blocks = re.findall(r"^```python\n(.*?)^```", readme.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    assert blocks
    made = subprocess.run([Path(sys.executable).with_name("sim"), "new", "--file", "my-linkage.mech"], cwd=tmp_path)
    assert made.returncode == 0
    run = subprocess.run([sys.executable, "-c", "\n".join(blocks)], cwd=tmp_path, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert run.stdout
