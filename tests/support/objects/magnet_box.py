"""A box with magnets under 1, 1.5 and 2.5 mm of silicone, of which NGSolve gave forces."""

from design.spec.object import ObjectSpec
from design.spec_io import check

BOX = check(
    ObjectSpec.model_validate(
        {
            "name": "box",
            "body": {"kind": "box", "size_mm": [60, 46, 42], "sensed_faces": [1]},
            "magnets": {
                "diameter_mm": 5,
                "height_mm": 2,
                "positions_mm": [[0, 0], [14, 0], [-14, 0]],
                "depth_mm": [2.0, 2.5, 3.5],
            },
        }
    )
)
