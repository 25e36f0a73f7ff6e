"""What the kinds of body answer, of objects off their symmetries: a page that a person can judge."""

import numpy as np

from design.layout.body import body_of
from design.layout.mould.frame import mould_frame
from tests.support.objects.shell_volume import cast_volume_mm3
from tests.support.objects.worked_objects import OBJECTS, worked
from tests.support.physics_pages import assert_page

FRAMED = [name for name in OBJECTS if "closed" not in name and name != "sleeve"]


def size_models(name):
    spec = worked(name)
    body, axes = body_of(spec), mould_frame(spec).axes
    less = body.less(0.7)
    outer = body.outer_surface()
    sizes = [body.volume_mm3(), outer.volume, outer.area, *np.ravel(body.passage_mm(axes))]
    sizes += [*less.size_mm, sum(slab.volume for slab in body.end_slabs(1.3))]
    if not body.sampled:
        sizes.append(cast_volume_mm3(body, 0.6, spec.body.sensed[:2]))
    yield f"{name}: body, outside (mm³), area (mm²), passage, less 0.7 mm, ends, cast", sizes


def of_faces(name):
    """Border, stretch of areas, lengths and where lines meet the surface, in five places of a face."""
    spec = worked(name)
    body = body_of(spec)
    frame = body.frame(spec.body.sensed[-1])
    turn = np.linspace(0.2, 6.0, 5)
    xy = 0.6 * np.column_stack([np.cos(turn), np.sin(turn)]) * frame.half_extents_mm
    lengths = frame.from_plane(xy)
    onto = frame.project_along(
        frame.to_object(np.column_stack([xy, np.full(5, 2.0)])), frame.normal + 0.2 * frame.x
    )
    stretch = np.column_stack([frame.area_stretch(lengths), onto[:, 2]])
    rows = [lengths, frame.to_plane(lengths), onto[:, :2], stretch, frame.border_mm(7)]
    points = np.random.default_rng(1).uniform(-1.1, 1.1, (30, 3)) * body.half_mm
    yield f"{name}, face {frame.number}: places and border (mm)", np.vstack(rows)
    yield f"{name}: distances to the core (mm)", body.core_distance_mm(points)


def test_the_page_of_bodies():
    sizes = [line for name in OBJECTS for line in size_models(name)]
    faces = [line for name in FRAMED[1::2] for line in of_faces(name)]
    assert_page("design/body", [*sizes, *faces])
