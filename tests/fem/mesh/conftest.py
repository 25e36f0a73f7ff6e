"""Here the mesher itself is under test: nothing comes from a record."""

import pytest

from fem.mesh import mesher, tetrahedra


@pytest.fixture(autouse=True)
def _no_record(monkeypatch):
    monkeypatch.setattr(tetrahedra, "run_mesher", mesher.run_mesher)
