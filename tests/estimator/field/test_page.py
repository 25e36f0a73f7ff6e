"""Fields of magnets in random poses and among steel: a page that a person can judge."""

import numpy as np
import torch

from design.spec.object import ObjectSpec
from estimator.field.demagnetisation import block_factor, cylinders_factor
from estimator.field.environment import environment, with_images
from estimator.field.gradient import field_change
from estimator.field.models import FieldModel, field_model, model_error
from estimator.field.sources import BlockMagnet, DiskMagnet
from tests.support.mechanics.magnet_poses import total_field
from tests.support.physics_pages import assert_page

DISK = DiskMagnet(6.0, 1.5, 1.3)
RING = DiskMagnet(8.0, 2.0, 1.3, inner_diameter_mm=4.0)
BLOCK = BlockMagnet((8.0, 4.0), 2.0, -1.2)
MODELS = {
    "disk": FieldModel(DISK, "exact"),
    "ring": FieldModel(RING, "multipole", 9),
    "block": FieldModel(BLOCK, "exact"),
    "block as charges": FieldModel(BLOCK, "charges", charges=3),
    "dipole": FieldModel(DISK, "multipole", 1),
}
STRAY_T = (1.3 * np.array([0.2, 1.0, -0.4]) / np.sqrt(1.2)).tolist()
AROUND = {
    "earth_ut": (np.array([1.0, -2.0, 0.5]) * 45 / np.sqrt(5.25)).tolist(),
    "magnets": [{"position_mm": [40.0, 10.0, 5.0], "remanence_t": STRAY_T}],
    "steel_plates": [
        {"position_mm": [0, 0, -40.0], "normal": [0.1, 0, 1.0], "relative_permeability": 60.0}
    ],
}


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def poses(magnets=3, points=4):
    """Points, centres, axes and first edges at right angles to them."""
    rng = np.random.default_rng(3)
    axes, aside = unit(rng.normal(size=(2, magnets, 3)))
    sides = unit(np.cross(axes, aside))
    centres = rng.uniform(-9, 9, (magnets, 3))
    return 14 * unit(rng.normal(size=(points, 3))) + 4, centres, axes, sides


def of_models():
    points, centres, axes, sides = poses()
    for name, model in MODELS.items():
        yield f"{name}, field (mT)", 1e3 * total_field(points, centres, axes, model, sides)
    magnets = [model.magnet for model in MODELS.values()]
    yield "volumes (mm³)", [magnet.volume_mm3 for magnet in magnets]
    yield "demagnetising factors", [magnet.demagnetising_factor for magnet in magnets]
    yield "fourth moments", [magnet.mean_solid_harmonics(5)[4] for magnet in magnets]
    yield "errors at 9 mm (mT)", [1e3 * model_error(model, 9.0) for model in MODELS.values()]
    two = cylinders_factor([(4.0, 1.0), (2.0, -1.0)], 2.0)
    yield "factors by hand", [block_factor(3.0, 5.0, 2.0), cylinders_factor([(4.0, 1.0)], 1.5), two]
    for name, magnet in (("disk", DISK), ("ring", RING), ("block", BLOCK)):
        chosen = [field_model(magnet, away) for away in (4.6, 5.5, 7.0, 11.0, 20.0)]
        told = (f"{model.name} {model.order or model.charges}" for model in chosen)
        yield f"{name} at 4.6, 5.5, 7, 11, 20 mm", ", ".join(told)


def of_slopes():
    points, centres, axes, _ = poses(3, 3)
    offset, axis = (torch.as_tensor(given.T.copy()) for given in (points - centres, axes))
    for name, magnet in (("disk", DISK), ("ring", RING)):
        change = field_change(offset, axis, magnet, 7)
        yield f"field of a {name} (mT)", 1e3 * change.field.numpy()
        yield "its slopes (mT/mm, mT/rad)", 1e3 * change.by_motion.numpy()


def of_surroundings():
    around = environment(ObjectSpec.model_validate({"name": "around", "environment": AROUND}))
    points, centres, axes, sides = poses()
    columns = [tuple(given.T[:, :, None]) for given in (centres, axes, sides)]
    at = tuple(points.T[:, None])
    images = with_images(at, *columns[:2], MODELS["block"], around.plates, columns[2])
    yield "field around (µT)", 1e6 * np.stack(around.field_at(tuple(points.T)))
    yield "block beside steel (mT)", 1e3 * np.stack(images)
    (plate,) = around.plates
    yield "steel plate: normal and strength", [*plate.normal, plate.strength]


def test_the_page_of_fields():
    assert_page("estimator/field", [*of_models(), *of_slopes(), *of_surroundings()])
