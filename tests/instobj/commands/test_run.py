"""What commands of the chain refuse to write over, before any work."""

from dataclasses import replace
from pathlib import Path

import pytest

from design.errors import InputError
from design.spec_io import load_spec
from estimator.frames.dataset import save_frames
from instobj.commands import run
from instobj.commands.run import build_objects, run_chain, run_estimator
from instobj.report.remedies import DESIGN_STAGES
from instobj.stages.run import Run
from tests.support.objects.tiny_cube import CHANGES, SMALL_CUBE, lend_mechanics
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


def test_parts_of_an_object_that_was_scored_a_no_go_are_written_with_a_warning(
    specification, tmp_path, monkeypatch, recwarn
):
    """`build` says nothing of an object that is good enough, or was not scored."""
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    lend_mechanics(tmp_path / "store")

    steps = []

    def warned_of(position_bound_mm, scored=True):
        limits = [f"limits.position_bound_mm={position_bound_mm}", "limits.detectable_force_n=50"]
        changes = ['name="tiny"', *CHANGES, *limits]
        if scored:
            chain = Run(load_spec(SMALL_CUBE, changes))
            for stage in DESIGN_STAGES:
                chain.require(stage)
        steps.append(build_objects([SMALL_CUBE], tmp_path, changes)["next"])
        return [str(w.message) for w in recwarn if "scored" in str(w.message)]

    assert not warned_of(0.001, scored=False)
    assert not warned_of(50.0)
    (text,) = warned_of(0.001)
    assert text.startswith("tiny was scored NO-GO: not good enough for the use 'grasp'")
    # firmware was the next step of an object that is not good enough
    assert [step.split()[1:3] for step in steps] == [
        ["score", str(SMALL_CUBE)],
        ["bench", "firmware"],
        ["run", "--to"],
    ]


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
