"""Print settings: the side that lies on the bed, supports, layers, and where slicers find them."""

import xml.etree.ElementTree as ET
import zipfile

import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.build.print_settings import PrintSettings, lying_side, print_settings
from design.build.slicer_file import ORCA, PRUSA, write_3mf
from design.spec.object import ObjectSpec

SPEC = ObjectSpec.model_validate({"name": "t"})


def box(low, high):
    return trimesh.creation.box(bounds=[low, high])


TABLE = trimesh.boolean.union(
    [box((-20, -20, 0), (20, 20, 5)), box((-3, -3, -25), (3, 3, 1))], engine="manifold"
)
"""A plate on one leg: it prints with the plate on the bed."""


@pytest.mark.parametrize("turn", [(0, 0, 0), (180, 0, 0), (90, 0, 0), (35, 20, 50)])
def test_a_plate_on_a_leg_lies_on_its_plate_however_it_is_turned(turn):
    turned = trimesh.transformations.euler_matrix(*np.deg2rad(turn))
    part = TABLE.copy().apply_transform(turned)
    assert_allclose(lying_side(part), turned[:3, :3] @ (0, 0, 1), atol=1e-3)
    settings = print_settings(SPEC, "jig", part, printed=True)
    assert settings is not None
    assert not settings.supports
    assert not settings.brim_mm
    assert_allclose(settings.rotation @ settings.down, (0, 0, -1), atol=1e-9)
    assert_allclose(np.linalg.det(settings.rotation), 1, atol=1e-9)


def test_a_ball_takes_supports_and_a_brim():
    ball = print_settings(SPEC, "core", trimesh.creation.icosphere(radius=10), printed=True)
    assert ball is not None
    assert ball.supports
    assert ball.brim_mm > 0


@pytest.mark.parametrize(
    ("printer", "coarse", "fine"), [("fdm-0.4", 0.2, 0.12), ("fdm-0.25", 0.12, 0.06)]
)
def test_layers_are_finer_where_silicone_copies_them(printer, coarse, fine):
    spec = ObjectSpec.model_validate({"name": "t", "printer": {"name": printer}})
    found = [print_settings(spec, name, TABLE, True) for name in ("core", "mould_box")]
    assert [settings and settings.layer_mm for settings in found] == [coarse, fine]


def test_cast_parts_and_other_printers_have_no_settings():
    assert print_settings(SPEC, "shell", TABLE, printed=False) is None
    resin = ObjectSpec.model_validate({"name": "t", "printer": {"name": "resin"}})
    assert print_settings(resin, "core", TABLE, printed=True) is None
    tpu = ObjectSpec.model_validate({"name": "t", "silicone": {"name": "TPU 85A"}})
    assert print_settings(tpu, "shell", TABLE, printed=False) is not None


def test_both_slicers_find_the_settings_by_the_object(tmp_path):
    settings = PrintSettings(0.12, 3, 25, True, 4.0, (0.0, 0.0, 1.0))
    write_3mf(TABLE, "a <part>", tmp_path / "part.3mf", settings, (220.0, 200.0))
    with zipfile.ZipFile(tmp_path / "part.3mf") as archive:
        prusa, orca = (ET.fromstring(archive.read(name)) for name in (PRUSA, ORCA))
        model = ET.fromstring(archive.read("3D/3dmodel.model"))
    keys = {m.get("key"): m.get("value") for m in prusa.findall("object/metadata")}
    assert keys["layer_height"] == "0.12"
    assert keys["fill_density"] == "25%"
    volume = prusa.find("object/volume")
    assert volume is not None
    assert volume.get("lastid") == str(len(TABLE.faces) - 1)
    keys = {m.get("key"): m.get("value") for m in orca.findall("object/metadata")}
    assert (keys["wall_loops"], keys["enable_support"], keys["name"]) == ("3", "1", "a <part>")
    item = next(element for element in model.iter() if element.tag.endswith("item"))
    numbers = np.array((item.get("transform") or "").split(), float).reshape(4, 3)
    placed = TABLE.vertices @ numbers[:3] + numbers[3]
    assert_allclose(placed.min(axis=0), (90, 80, 0), atol=1e-6)
    assert_allclose(placed.max(axis=0), (130, 120, 30), atol=1e-6)


@pytest.mark.parametrize(
    ("bed_mm2", "height_mm", "brim"),
    [(400, 60.0, False), (400, 60.1, True), (59.9, 9, True), (60.0, 9, False)],
)
def test_slender_parts_and_those_with_little_on_the_bed_get_a_brim(
    bed_mm2, height_mm, brim, monkeypatch
):
    """Taller than three times the root of what lies on the bed, or less than 60 mm² on it."""
    monkeypatch.setattr(
        "design.build.print_settings.standing_on", lambda mesh, down: (bed_mm2, 30.1, height_mm)
    )
    settings = print_settings(SPEC, "jig", TABLE, printed=True)
    assert settings is not None
    assert settings.brim_mm == (4.0 if brim else 0.0)
    assert settings.supports
