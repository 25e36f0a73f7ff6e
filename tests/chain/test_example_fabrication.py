"""Every example can be made: `instobj check FILE --fabrication` finds nothing that fails."""

import json
from pathlib import Path

import pytest

from tests.support.cli import run

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.toml"))


@pytest.mark.slow
@pytest.mark.parametrize("path", EXAMPLES, ids=[path.stem for path in EXAMPLES])
def test_fabrication_checks_of_the_example_pass(path, tmp_path):
    done = run("check", path, "--fabrication", "--json", cwd=tmp_path)
    found = json.loads(done.stdout)["fabrication"][0]
    assert not [f for f in found["findings"] if f["status"] == "fail"]
    assert len(found["findings"]) > 20
    assert done.returncode == 0, done.stderr
