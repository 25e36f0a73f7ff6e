"""Studies of a sweep: which specifications they make, and what they refuse."""

import numpy as np
import pytest

from design.errors import InputError, SpecError
from instobj.sweep.study import load_study
from tests.support.cli import CUBE


def study(tmp_path, text):
    path = tmp_path / "study.toml"
    path.write_text(f'name = "s"\n{text}')
    return load_study(path)


ON_CUBE = f'specification = "{CUBE}"\n'


def test_a_grid_holds_every_combination_and_what_is_set_for_all(tmp_path):
    grid = 'set = {"score.force_n" = 3.0}\n[grid]\n"shell.thickness_mm" = [7.5, 8.0]\n'
    found = study(tmp_path, ON_CUBE + grid + '"sensors.averaging" = [1, 16, 32]')
    assert found.keys == ("shell.thickness_mm", "sensors.averaging")
    made = [(v.spec.shell.thickness_mm, v.spec.sensors.averaging) for v in found.variants if v.spec]
    assert made == [(t, a) for t in (7.5, 8.0) for a in (1, 16, 32)]
    assert {v.spec.score.force_n for v in found.variants} == {3.0}
    assert [v.label for v in found.variants] == [f"s_{n}" for n in range(1, 7)]


def test_a_latin_hypercube_has_one_point_in_every_slice_and_repeats(tmp_path):
    text = "[latin_hypercube]\ncount = 12\nseed = 4\n[latin_hypercube.ranges]\n"
    text = ON_CUBE + text + '"score.force_n" = [2.0, 8.0]\n"sensors.drift_counts" = [0.0, 60.0]'
    found, again = study(tmp_path, text), study(tmp_path, text)
    assert [v.changes for v in found.variants] == [v.changes for v in again.variants]
    for key, (low, high) in {"score.force_n": (2, 8), "sensors.drift_counts": (0, 60)}.items():
        values = np.array([v.changes[key] for v in found.variants])
        assert sorted(np.floor((values - low) / (high - low) * 12)) == list(range(12))


def test_specifications_that_do_not_fit_say_why_and_the_others_stay(tmp_path):
    found = study(tmp_path, ON_CUBE + '[grid]\n"shell.thickness_mm" = [8.0, 30.0]')
    assert [v.spec is None for v in found.variants] == [False, True]
    assert "thickness" in found.variants[1].refused


def test_files_are_taken_as_they_are(tmp_path):
    (tmp_path / "one.toml").write_text('name = "inner"')
    found = study(tmp_path, 'files = ["one.toml"]')
    assert [(v.label, v.changes) for v in found.variants] == [("one", {})]


BAD = {
    "exactly one of files": ON_CUBE,
    "give either specification": '[grid]\n"seed" = [1, 2]',
    "no specification can be made": ON_CUBE + '[grid]\n"no.such_key" = [1]',
    "must rise": ON_CUBE + '[latin_hypercube]\ncount = 3\nranges = {"seed" = [3, 1]}',
    "20000": ON_CUBE + f'[grid]\n"seed" = {list(range(20000))}',
    "is not TOML": "= 3",
    "colour": ON_CUBE + "colour = 3",
    "stages": 'stages = ["hopes"]\n' + ON_CUBE + '[grid]\n"seed" = [1, 2]',
}


@pytest.mark.parametrize("text", BAD)
def test_a_bad_study_is_one_error(tmp_path, text):
    with pytest.raises(SpecError, match=text):
        study(tmp_path, BAD[text])


def test_a_study_that_is_not_there(tmp_path):
    with pytest.raises(InputError, match="no study at"):
        load_study(tmp_path / "none.toml")
