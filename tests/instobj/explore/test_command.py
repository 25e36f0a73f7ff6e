"""The command `explore`: a specification, or what is requested from nothing, with its first map."""

import time

import pytest

from design.errors import InputError
from design.spec_io import load_spec
from instobj.commands.new import request_of
from instobj.explore.command import explore, requested_specification
from instobj.explore.engine import open_coarse_explorer, summary_of


def test_a_box_from_nothing_has_its_first_map_within_fifteen_seconds(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    began, said = time.process_time(), []
    request = request_of("box", (70.0, 50.0, 35.0))
    path = requested_specification(request, said.append)
    spec = load_spec(path)
    explorer = open_coarse_explorer(spec)
    judged = explorer.judge(spec, explorer.forces_n[-1]).position_bound_mm
    assert time.process_time() - began < 15  # of a core, whatever else runs
    assert path.name == "box_70x50x35.toml"
    assert spec.body.size_mm == (70.0, 50.0, 35.0)
    assert 0.05 < summary_of(judged).median < 20
    assert said == []
    assert requested_specification(request, said.append) == path
    assert "opened again" in said[0]


def test_neither_or_both_of_a_file_and_a_request_is_refused(tmp_path):
    request = request_of("box", (70.0, 50.0, 35.0))
    for spec, asked in ((None, None), (tmp_path / "a.toml", request)):
        with pytest.raises(InputError, match="Give one of them"):
            explore(spec, asked, 0, None, [])
