"""Order of demoulding: what is drawn in which step, and a picture that shows it."""

import numpy as np
import pytest
import trimesh
from matplotlib.image import imread

from design.layout.mould.pins import loose_pins
from design.spec.object import ObjectSpec
from instobj.render.demoulding import draw_demoulding, one_piece_steps, split_steps
from instobj.render.pieces import Piece

GREY = (0.5, 0.5, 0.5)
NAMES = ("mould_half_a", "mould_half_b", "mould_holder", "shell")


def written(folder, *names):
    for name in names:
        trimesh.creation.box((40, 40, 40)).export(folder / f"{name}.stl")
    return {name: Piece(trimesh.creation.box((40, 40, 40)), GREY) for name in names}


def test_a_ball_loses_pins_then_its_rod_then_its_halves(tmp_path):
    ball = ObjectSpec.model_validate(
        {"name": "t", "body": {"kind": "sphere", "size_mm": [50.0] * 3, "sensed_faces": [2, 3]}}
    )
    pins = loose_pins(ball)
    steps = split_steps(ball, written(tmp_path, *NAMES), pins)
    assert [step.text.split()[-1] for step in steps] == ["cured", "outwards", "rod", "halves", "in"]
    assert [len(step.pieces) for step in steps] == [3 + len(pins), 3 + len(pins), 3, 3, 1]
    for pin, before, after in zip(pins, steps[0].pieces[2:], steps[1].pieces[2:], strict=False):
        way = after.mesh.centroid - before.mesh.centroid
        assert way @ pin.way == pytest.approx(np.linalg.norm(way)), "each along its own axis"
    image = imread(draw_demoulding(ball, tmp_path, pins, tmp_path / "demoulding.png"))[..., :3]
    red, green, blue = np.moveaxis(image, -1, 0)
    assert ((red > 1.5 * green) & (red > 2 * blue)).mean() > 1e-3, "pins are red"


def test_a_cube_loses_its_plug_first(tmp_path):
    parts = written(tmp_path, "mould_box", "mould_plug", "shell")
    steps = one_piece_steps(ObjectSpec.model_validate({"name": "t"}), parts)
    assert [len(step.pieces) for step in steps] == [3, 3, 2]
    assert steps[1].pieces[2].mesh.bounds[1, 2] < -15, "out of the open face 6, downwards"
