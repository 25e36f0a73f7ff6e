"""Golden geometry of the example with keys, slits, channels and the split mould."""

from pathlib import Path

import pytest
import yaml
from numpy.testing import assert_allclose

from design.parts import parts_of
from design.spec_io import load_spec

ROOT = Path(__file__).parents[2]
LOCKED = load_spec(ROOT / "examples" / "locked_cube.toml")
PARTS = {part.name: part for part in parts_of(LOCKED) if not part.name.startswith("probe")}
GOLDEN = yaml.safe_load((ROOT / "tests/references/locked_cube.yaml").read_text(encoding="utf-8"))


def test_every_part_has_a_reference():
    assert set(GOLDEN["parts"]) == set(PARTS)


@pytest.mark.parametrize("name", GOLDEN["parts"])
def test_golden_geometry(name):
    golden, solid = GOLDEN["parts"][name], PARTS[name].make()
    box = solid.BoundingBox()
    corners = [(box.xmin, box.ymin, box.zmin), (box.xmax, box.ymax, box.zmax)]
    assert PARTS[name].count == golden["count"]
    assert len(solid.Faces()) == golden["face_count"]
    assert_allclose(solid.Volume(), golden["volume_mm3"], rtol=1e-8)
    assert_allclose(corners, golden["bounding_box_mm"], rtol=0, atol=1e-5)
    assert_allclose(solid.Center().toTuple(), golden["centre_of_mass_mm"], rtol=0, atol=1e-6)


def test_the_shell_by_hand():
    """The paper's shell less ten keys of 3 × 3 × 1.5 mm and slits of 1 × 5 mm along 240 mm of edges."""
    paper = 48983.4249588
    by_hand = paper - 10 * 13.5 - (5 - 0.25) * (4 * (42 - 16) + 4 * (42 - 8))
    assert_allclose(GOLDEN["parts"]["shell"]["volume_mm3"], by_hand, rtol=1e-9)
