"""Fit of what is cut into curved cores and stands on them."""

import re

import numpy as np
import pytest
import trimesh

from design.body.triangles import Block
from design.errors import SpecError
from design.fit import curved
from design.fit.blocks import check_passages
from design.fit.curved import check_recesses
from design.layout.body import core_frames
from design.layout.places import positions
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from tests.support.pages import ROOT

EXAMPLES = ROOT / "examples"

EGG = {
    "name": "egg",
    "body": {"kind": "ellipsoid", "size_mm": [62.0, 56.0, 50.0], "bore_mm": 9.0},
    "contact_grid": {"count": [3, 3]},
}


def egg(outer_mm=None):
    spec = ObjectSpec.model_validate(EGG)
    core = spec.core.changed(recess_inner_radius_mm=1.0, recess_outer_radius_mm=outer_mm or 5.0)
    return spec.changed(core=core)


def test_a_recess_reaches_as_far_as_the_smallest_patch():
    reach = sorted(float(np.hypot(*frame.half_extents_mm)) for frame in core_frames(egg()))
    assert reach[-1] > 1.05 * reach[0]
    assert not list(check_recesses(egg(reach[0] - 0.01)))
    (told,) = check_recesses(egg(reach[0] + 0.01))
    assert f"{reach[0]:.4g} mm; got" in told


def test_a_key_below_stands_in_the_bore_until_it_is_beside_it():
    spec = egg()
    for x, stands in ((0.0, True), (6.4, True), (6.6, False)):
        key = Block(np.array([x, 0.0, -15.0]), np.eye(3), np.array([2.0, 2.0, 1.0]))
        told = [text for text in check_passages(spec, "the key", key) if "bore" in text]
        assert bool(told) == stands, x
    above = Block(np.array([0.0, 0.0, 8.0]), np.eye(3), np.array([2.0, 2.0, 1.0]))
    assert not [text for text in check_passages(spec, "the key", above) if "bore" in text]


@pytest.mark.parametrize("upside_down", [False, True])
def test_given_counts_stay_on_both_ends_of_a_pear(tmp_path, upside_down):
    """Its thin end is steeper: whichever way it points, ten rows 4.6 mm apart leave the patch there."""
    pear = trimesh.load_mesh(EXAMPLES / "bodies" / "pear.stl")
    if upside_down:
        pear.apply_transform(trimesh.transformations.rotation_matrix(np.pi, [1, 0, 0]))
    pear.export(tmp_path / "pear.stl")
    file, faces = f'body.file="{tmp_path / "pear.stl"}"', "body.sensed_faces=[5]"
    given = [file, faces, "contact_grid.count=[10, 2]"]
    assert load_spec(EXAMPLES / "pear.toml", [*given, "contact_grid.pitch_mm=3.4"])
    with pytest.raises(SpecError, match="leave face 5"):
        load_spec(EXAMPLES / "pear.toml", [*given, "contact_grid.pitch_mm=4.6"])


def test_a_magnet_over_which_the_silicone_is_not_known_is_refused(monkeypatch):
    """At the rim of a frustum's patch the cover is no number, and passed as it is not below 0."""

    def known_within_5_mm(frame, bodies):
        return np.array([2.0 if abs(body.centre_mm[0]) <= 5 else np.nan for body in bodies])

    monkeypatch.setattr(positions, "covers_mm", known_within_5_mm)
    magnets = egg().magnets
    within = egg().changed(magnets=magnets.changed(positions_mm=((5.0, 0.0),)))
    assert not [text for text in curved.check_body(within) if "not known" in text]
    beyond = egg().changed(magnets=magnets.changed(positions_mm=((10.0, 1.0),)))
    (told,) = [text for text in curved.check_body(beyond) if "not known" in text]
    assert "on faces 1, 2, 3, 4, 5" in told
    assert told.endswith("Move it inwards, as to (5, 0.5)")


def test_boards_that_find_no_room_are_told_together_with_a_radius_that_works():
    """A line for each board of the pear's twelve, without a number, were told."""

    def with_boards_at(radius):
        core = {"recess_inner_radius_mm": radius - 3.25, "recess_outer_radius_mm": radius + 3.25}
        return ObjectSpec.model_validate(
            small | {"core": core | {"wall_mm": 9.0}, "sensors": {"radius_mm": radius}}
        )

    small = EGG | {"body": EGG["body"] | {"sensed_faces": [2, 4]}}
    (one,) = curved.check_sensors(with_boards_at(13.0))
    assert "in it: sensor 1 of face 2; sensor 2 of face 4." in one
    (told,) = curved.check_sensors(with_boards_at(15.0))
    assert "in it: sensors 1, 2, 3 of faces 2, 4." in told
    radius = float(re.findall(r"sensors.radius_mm = ([\d.]+)", told)[0])
    assert 11 < radius < 13
    assert not [*curved.check_sensors(with_boards_at(radius))]
    assert [*curved.check_sensors(with_boards_at(radius + 0.5))]
