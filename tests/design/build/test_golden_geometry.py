"""Golden geometry of the preset and of every example, and the preset beside the authors' parts."""

from functools import cache

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.build.parts import parts_of
from design.layout.body import body_of
from design.solids.core import make_core
from design.spec_io import load_spec
from tests.support.objects.golden_geometry import (
    FILES,
    golden_geometry,
    measured_part,
    measured_places,
)

GOLDEN = golden_geometry()
PARTS = [(name, part) for name, of_name in GOLDEN.items() for part in of_name["parts"]]
SLOW = ("preset", "paper_cube", "search_cube", "better_cube", "reverse_cube", "pear", "egg")
"""The paper's cube, whose parts test_export builds and compares with the same reference, what differs
from it by places alone, and two sampled bodies beside the ball."""

AUTHORS = {
    "core": (9034.89, [26.0, 26.0, 26.0], 0.02),
    "shell": (48983.42, [42.0, 42.0, 42.0], 1e-6),
    "mould_box": (16477.68, [45.0, 45.0, 47.5], 0.02),
    "mould_plug": (34454.65, [30.0, 44.0, 50.0], 0.02),
}
"""Read off the authors' public CAD: volume (mm³), edges of the box in rising order, and how near."""


def assert_part(measured, golden):
    """Solids to 1e-6 of their volume, triangles of sampled bodies to 0.5 % and 0.1 mm."""
    exact = "faces" in golden
    volume, length = (1e-6, 1e-4) if exact else (5e-3, 0.1)
    assert measured.get("faces") == golden.get("faces")
    assert measured["count"] == golden["count"]
    assert_allclose(measured["volume_mm3"], golden["volume_mm3"], rtol=volume)
    for key in ("box_mm", "centre_of_mass_mm"):
        assert_allclose(measured[key], golden[key], rtol=0, atol=length)


@cache
def specification(name):
    return load_spec(FILES[name])


@cache
def parts(name):
    return {part.name: part for part in parts_of(specification(name))}


def test_every_object_has_a_reference_and_the_other_way_round():
    """Where this fails after a deliberate change: python -m tests.support.objects.golden_geometry."""
    assert set(GOLDEN) == set(FILES)


@pytest.mark.parametrize("name", FILES)
def test_every_part_has_a_reference_and_the_other_way_round(name):
    assert set(GOLDEN[name]["parts"]) == set(parts(name))


def marked(key):
    return pytest.param(*key, marks=pytest.mark.slow if key[0] in SLOW else [], id="-".join(key))


@pytest.mark.parametrize(("name", "part"), [marked(key) for key in PARTS])
def test_golden_parts(name, part):
    assert_part(measured_part(parts(name)[part]), GOLDEN[name]["parts"][part])


@pytest.mark.parametrize("name", FILES)
def test_golden_places(name):
    exact = not body_of(specification(name)).sampled
    places = measured_places(specification(name))
    for key in ("pocket_floors_mm", "sensors_mm"):
        assert places[key].keys() == GOLDEN[name][key].keys()
        for face, golden in GOLDEN[name][key].items():
            assert_allclose(places[key][face], golden, rtol=0, atol=2e-6 if exact else 0.05)


@pytest.mark.parametrize("part", AUTHORS)
def test_the_preset_agrees_with_the_authors_parts(part):
    volume, edges, within = AUTHORS[part]
    golden = GOLDEN["preset"]["parts"][part]
    assert_allclose(golden["volume_mm3"], volume, rtol=within)
    low, high = np.array(golden["box_mm"])
    assert_allclose(sorted(high - low), edges, rtol=0, atol=1e-6)


def test_the_preset_s_pockets_by_hand():
    """Floors 3 mm below each closed face at (0, 0) and (±10, ±10): 18 mm from the middle."""
    in_face = [(0, 0), (10, 10), (-10, 10), (-10, -10), (10, -10)]
    axes = {1: "xyz", 2: "ZxY", 3: "Zyx", 4: "ZXy", 5: "ZYX"}  # face x, y, n; capitals: negative
    unit = dict(zip("xyz", np.eye(3), strict=True))
    unit |= {letter.upper(): -row for letter, row in list(unit.items())}
    for face, names in axes.items():
        x, y, n = (unit[letter] for letter in names)
        by_hand = [u * x + v * y + 18 * n for u, v in in_face]
        assert_allclose(GOLDEN["preset"]["pocket_floors_mm"][face], by_hand, rtol=0, atol=1e-6)


def test_the_locked_cube_s_shell_by_hand():
    """The paper's less ten keys of 3 × 3 × 1.5 mm."""
    paper, locked = (GOLDEN[name]["parts"]["shell"] for name in ("paper_cube", "locked_cube"))
    assert_allclose(locked["volume_mm3"], paper["volume_mm3"] - 10 * 13.5, rtol=1e-9)


def test_the_relief_cube_s_shell_by_hand():
    """The paper's less slits of 1.25 × 5 mm, without the corner's triangle, along 240 mm of edges."""
    paper, relief = (GOLDEN[name]["parts"]["shell"] for name in ("paper_cube", "relief_cube"))
    slits = (1.25 * 5 - 1.25**2 / 4) * (4 * (42 - 16) + 4 * (42 - 8))
    assert_allclose(relief["volume_mm3"], paper["volume_mm3"] - slits, rtol=1e-9)


@pytest.mark.parametrize("key", ["volume_mm3", "box_mm", "centre_of_mass_mm", "faces", "count"])
def test_a_changed_part_is_seen(key):
    golden = GOLDEN["ball"]["parts"]["shell"]
    slack = {"volume_mm3": 2e-6 * golden["volume_mm3"], "faces": 1, "count": 1}.get(key, 2e-4)
    changed = golden | {key: (np.asarray(golden[key]) + slack).tolist()}
    with pytest.raises(AssertionError):
        assert_part(changed, golden)


@pytest.mark.parametrize(("key", "slack"), [("volume_mm3", 300.0), ("box_mm", 0.15)])
def test_a_changed_sampled_part_is_seen(key, slack):
    golden = GOLDEN["egg"]["parts"]["shell"]
    with pytest.raises(AssertionError):
        assert_part(golden | {key: (np.asarray(golden[key]) + slack).tolist()}, golden)


def test_the_authors_core_is_the_preset_with_their_wire_channels():
    """15 channels of 2 × 0.5 mm, 38.8 mm³, are what the preset's core is larger by, to 0.03 %."""
    channels = ["core.wire_channel_mm=[2, 0.5]"]
    plain, channelled = (make_core(load_spec(FILES["paper_cube"], c)) for c in ([], channels))
    assert_allclose(channelled.Volume(), AUTHORS["core"][0], rtol=3e-4)
    assert plain.Volume() > 1.004 * AUTHORS["core"][0]
