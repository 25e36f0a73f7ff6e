"""What commands of the chain refuse to write over, before any work."""

from dataclasses import replace
from pathlib import Path

import pytest

from design.errors import InputError
from estimator.frames.dataset import save_frames
from instobj.commands import run
from instobj.commands.run import run_chain, run_estimator
from tests.support.recordings.pressed_frames import made_frames


@pytest.fixture
def specification(tmp_path, monkeypatch):
    """One named cube, in a folder of results; what would be made is not."""
    files = [{"path": "runs/cube/contacts.nc"}]
    monkeypatch.setattr(
        run, "run_one_object", lambda spec, stages, *_: {"stages": list(stages), "files": files}
    )
    path = tmp_path / "cube.toml"
    path.write_text('name = "cube"\n')
    return path


@pytest.mark.parametrize("source", ["recorded", "simulated"])
def test_simulated_presses_do_not_take_the_place_of_a_recording(specification, tmp_path, source):
    save_frames(replace(made_frames(), source=source), tmp_path / "runs" / "cube" / "frames.nc")

    def chain(*stages):
        objects = run_chain([specification], stages, tmp_path, [])["objects"]
        return [item["stages"] for item in objects]

    def trained():
        objects = run_estimator([specification], ("networks",), tmp_path, [])["objects"]
        return [item["stages"] for item in objects]

    assert chain("signals", "discretisation") == [["signals", "discretisation"]]
    if source == "simulated":
        assert (chain("report"), trained()) == ([["report"]], [["inversion"]])
        return
    for command in (lambda: chain("report"), trained):
        with pytest.raises(
            InputError, match=r"cube/frames\.nc is the data set of a recording; .*--out"
        ):
            command()
    assert run_chain([specification], ("report",), tmp_path / "other", [])["objects"]


def test_two_sources_of_one_name_are_refused_before_any_is_trained(specification, tmp_path):
    other = tmp_path / "elsewhere" / "cube.nc"
    for pair in ([specification, other], [Path("a") / "frames.nc", Path("b/a") / "frames.nc"]):
        with pytest.raises(InputError, match=r"are both named '(cube|a)'"):
            run_estimator(pair, ("networks",), tmp_path, [])
