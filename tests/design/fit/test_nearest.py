"""What a message says would work does."""

import re

import pytest

from design.errors import SpecError
from design.fit.box import fewer_places
from design.fit.everything import fits
from design.spec_io import load_spec
from tests.support.pages import ROOT


def told(name, changes):
    with pytest.raises(SpecError) as error:
        load_spec(ROOT / "examples" / f"{name}.toml", changes)
    return str(error.value)


@pytest.mark.parametrize(
    ("name", "change", "word", "key"),
    [
        ("handle", "shell.slits.depth_mm=9", "depth_mm", "shell.slits."),
        ("paper_cube", "shell.slits.depth_mm=14", "depth_mm", "shell.slits."),
        ("handle", "core.bay_mm=[18, 18, 30]", "core.bay_mm", ""),
        ("paper_cube", "core.bay_mm=[25, 25, 25]", "core.bay_mm", ""),
    ],
)
def test_a_slit_or_bay_that_would_fit_fits(name, change, word, key):
    said = told(name, [change])
    (value,) = re.findall(rf"would fit with {re.escape(word)} = (.*)$", said, re.M)
    assert load_spec(ROOT / "examples" / f"{name}.toml", [f"{key}{word}={value}"])


def test_smaller_keys_that_would_fit_fit():
    keys = ["core.keys.positions_mm=[[0, 11.5]]"]
    said = told("paper_cube", [*keys, "core.keys.size_mm=[9, 6, 1.5]"])
    (size,) = re.findall(r"would fit with size_mm = (.*)$", said, re.M)
    assert load_spec(ROOT / "examples" / "paper_cube.toml", [*keys, f"core.keys.size_mm={size}"])


@pytest.mark.parametrize(
    ("count", "room_mm", "said"),
    [
        ((4, 8), 6.0, "fewer places (3 at most), contact_grid.pitch_mm of 0.75 or less,"),
        ((4, 2), 4.01, "fewer places (2 at most), contact_grid.pitch_mm of 2 or less,"),
        ((4, 2), 3.9, "fewer places, contact_grid.pitch_mm of 1.95 or less,"),
        ((4, 8), 0.07, "fewer places, contact_grid.count"),
    ],
)
def test_pitches_of_less_than_a_millimetre_are_told_and_none_is_0(count, room_mm, said):
    assert fewer_places(count, 2.0, 1, room_mm).startswith(f"Use {said}")


@pytest.mark.parametrize("name", ["ball", "paper_cube"])
def test_a_grid_that_leaves_its_face_is_told_how_many_places_fit(name):
    count = [f"contact_grid.count={[9, 9] if name == 'ball' else [10, 10]}"]
    said = told(name, [*count, "contact_grid.pitch_mm=4.5"])
    most = int(re.search(r"fewer places \((\d+)", said)[1])
    pitch = float(re.search(r"pitch_mm of ([\d.]+) or less", said)[1])
    spec = load_spec(ROOT / "examples" / f"{name}.toml", count)
    grid = spec.contact_grid
    for better in ({"count": (most, most), "pitch_mm": 4.5}, {"pitch_mm": pitch}):
        assert fits(spec.changed(contact_grid=grid.changed(**better)))
    assert not fits(spec.changed(contact_grid=grid.changed(count=(most + 2,) * 2, pitch_mm=4.5)))


@pytest.mark.parametrize(
    ("name", "change", "pattern", "key"),
    [
        (
            "ball",
            "shell.thickness_mm=24",
            r"shell\.thickness_mm below ([\d.]+)",
            "shell.thickness_mm",
        ),
        (
            "hall_skin",
            "shell.thickness_mm=11",
            r"thickness_mm below ([\d.]+)",
            "shell.thickness_mm",
        ),
        ("ball", "press.depths_mm=[1, 7]", r"Press ([\d.]+) mm deep", "press.depths_mm"),
        ("paper_cube", "press.depths_mm=[1, 7]", r"Press ([\d.]+) mm deep", "press.depths_mm"),
    ],
)
def test_a_limit_that_is_told_is_the_limit(name, change, pattern, key):
    limit = float(re.search(pattern, told(name, [change]))[1])

    def still_told(value):
        written = f"[1, {value}]" if "depths" in key else value
        try:
            load_spec(ROOT / "examples" / f"{name}.toml", [f"{key}={written}"])
        except SpecError as error:
            return re.search(pattern, str(error)) is not None
        return False

    assert not still_told(limit - 1e-3)
    assert still_told(limit + 1e-2)


ALONGSIDE = {"sensors": "sensors.count_per_face=1"}
STRAY = "environment.magnets=[{position_mm=[%s, 0, 0]}]"
STEEL = "environment.steel_plates=[{position_mm=[0, 0, %s], normal=[0, 0, -1]}]"


@pytest.mark.parametrize(
    ("setting", "wrong", "pattern", "step"),
    [
        ("contact_grid.pitch_mm=%s", 25.0, r"contact_grid\.pitch_mm of ([\d.]+), a", 0.1),
        ("contact_grid.pitch_mm=%s", 0.3, r"Use a pitch of ([\d.]+) or more", -0.01),
        ("shell.pocket_depth_mm=%s", 0.6, r"deeper than ([\d.]+) mm", 0.0),
        ("sensors.positions_mm=[[%s, 0]]", 12.0, r"by more than ([\d.]+) mm in x", 0.0),
        (STRAY, 20.0, r"outwards by more than ([\d.]+) mm", 0.0),
        (STEEL, 18.0, r"back by ([\d.]+) mm or more", -0.1),
        (
            "as_built.magnets=[{face=1,magnet=1,dent_mm=%s}]",
            2.5,
            r"dent_mm \(as_built\) smaller than ([\d.]+)",
            0.0,
        ),
    ],
)
def test_the_nearest_value_is_told_and_is_the_nearest(setting, wrong, pattern, step):
    """`step`: from the told value to one that is refused; 0 where it is itself refused. "more than",
    "back by" and "outwards by" tell the way from the wrong value."""
    more = [line for key, line in ALONGSIDE.items() if key in setting]
    value = float(re.search(pattern, told("paper_cube", [*more, setting % wrong]))[1])
    if "by" in pattern and "Space" not in pattern:
        value = wrong + (-value if setting.startswith("sensors") else value)

    def refused(given):
        try:
            load_spec(ROOT / "examples" / "paper_cube.toml", [*more, setting % round(given, 4)])
        except SpecError as error:
            return re.search(pattern, str(error)) is not None
        return False

    towards = 0.02 if value > wrong else -0.02
    assert not refused(value if step else value + towards)
    assert refused(value + step if step else value - towards)
