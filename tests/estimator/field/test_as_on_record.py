"""Fields of magnets in random poses, their slopes, and models that are chosen, on record.

Where this fails after a deliberate change see `tests/support/recorded_facts.py`.
"""

import numpy as np
import pytest
import torch

from design.spec.object import ObjectSpec
from estimator.field.batched import batched_field
from estimator.field.demagnetisation import of_block, of_cylinders
from estimator.field.environment import environment, with_images
from estimator.field.gradient import field_change
from estimator.field.models import FieldModel, field_model, model_error, total_field
from estimator.field.sources import BlockMagnet, DiskMagnet, magnet_source
from tests.support.recorded_facts import assert_on_record, told, told_whole

DISK = DiskMagnet(6.0, 1.5, 1.3)
RING = DiskMagnet(8.0, 2.0, 1.3, inner_diameter_mm=4.0)
BLOCK = BlockMagnet((8.0, 4.0), 2.0, -1.2)
MODELS = {
    "disk": FieldModel(DISK, "exact"),
    "ring": FieldModel(RING, "multipole", 9),
    "block": FieldModel(BLOCK, "exact"),
    "charges": FieldModel(BLOCK, "charges", charges=3),
    "dipole": FieldModel(DISK, "dipole"),
}


def on_record(section, lines):
    assert_on_record("field", section, lines, "estimator")


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def poses(magnets=3, points=4):
    """Points, centres, axes and first edges at right angles to them."""
    rng = np.random.default_rng(3)
    axes, aside = unit(rng.normal(size=(2, magnets, 3)))
    sides = unit(np.cross(axes, aside))
    centres = rng.uniform(-9, 9, (magnets, 3))
    return 14 * unit(rng.normal(size=(points, 3))) + 4, centres, axes, sides


@pytest.mark.parametrize("name", MODELS)
def test_fields_are_as_on_record(name):
    """In mT."""
    model, (points, centres, axes, sides) = MODELS[name], poses()
    field = 1e3 * total_field(points, centres, axes, model, sides)
    lines = [told("field", field), told("volume", model.magnet.volume_mm3)]
    lines.append(told("factor", model.magnet.demagnetising_factor))
    on_record(name, [*lines, told("moments", model.magnet.mean_solid_harmonics(5))])


def test_slopes_are_as_on_record():
    points, centres, axes, _ = poses(3, 3)
    offset, axis = (torch.as_tensor(given.T.copy()) for given in (points - centres, axes))
    for name, magnet in (("disk", DISK), ("ring", RING)):
        found = field_change(offset, axis, magnet, 7)
        lines = [
            told("field", 1e3 * found.field.numpy()),
            told("slopes", 1e3 * found.by_motion.numpy()),
        ]
        on_record(f"slopes of a {name}", lines)
    given = (torch.as_tensor(one[None]) for one in (points, centres, axes))
    on_record("batched", [told("field", 1e3 * batched_field(*given, MODELS["ring"]).numpy())])


def test_models_that_are_chosen_are_as_on_record():
    lines = [
        f"{name} at {away:g} mm: {told('model', [model.order, model.charges])}, {model.name}"
        for name, magnet in (("disk", DISK), ("ring", RING), ("block", BLOCK))
        for away in (4.6, 5.5, 7.0, 11.0, 20.0)
        for model in [field_model(magnet, away)]
    ]
    errors = [1e3 * model_error(model, 9.0) for model in MODELS.values()]
    factors = [of_block(3.0, 5.0, 2.0), of_cylinders([(4.0, 1.0)], 1.5)]
    lines += [
        told("errors", errors),
        told("factors", [*factors, of_cylinders([(4.0, 1.0), (2.0, -1.0)], 2.0)]),
    ]
    on_record("models", lines)


def test_surroundings_are_as_on_record():
    around = {
        "earth_field_ut": 45.0,
        "earth_direction": [1.0, -2.0, 0.5],
        "magnets": [{"position_mm": [40.0, 10.0, 5.0], "axis": [0.2, 1.0, -0.4]}],
        "steel_plates": [
            {
                "position_mm": [0.0, 0.0, -40.0],
                "normal": [0.1, 0.0, 1.0],
                "relative_permeability": 60.0,
            }
        ],
    }
    spec = ObjectSpec.model_validate({"name": "around", "environment": around})
    found = environment(spec)
    points, centres, axes, sides = poses()
    columns = lambda given: tuple(given.T[:, :, None])  # noqa: E731
    images = with_images(
        tuple(points.T[:, None]),
        columns(centres),
        columns(axes),
        MODELS["block"],
        found.plates,
        columns(sides),
    )
    lines = [
        told("own", 1e6 * np.stack(found.field_at(tuple(points.T)))),
        told("with images", 1e3 * np.stack(images)),
        *told_whole("plates", found.plates),
        *told_whole("source", magnet_source(spec.magnets)),
    ]
    on_record("surroundings", lines)
