"""The gallery's small cube, and its mechanics made once per run of the tests.

Meshes take most of the time of a small object, and depend neither on contact locations nor on
anything that is trained: objects that differ in those alone share them.
"""

import shutil
from pathlib import Path

from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from instobj.stages.run import Run
from tests.support.shared import only_one

SMALL_CUBE = Path(__file__).parents[3] / "examples" / "gallery" / "small_cube.toml"
MESHED = (
    "body.sensed_faces=[1]",
    "mesh.edge_mm=8.0",
    "mesh.surface_edge_mm=3.0",
    "mesh.rim_edge_ratio=1",
    "mesh.envelope_mm=0.1",
)
"""What makes the mesh of the small cube from the paper's."""
CHANGES = (
    "contact_grid.count=[3, 3]",
    "contact_grid.pitch_mm=6.0",
    "press.depths_mm=[1.0, 2.0]",
    "score.force_n=2.0",
    'training.model="compact"',
    "training.epochs=2",
    "training.hidden_units=[8, 8]",
    "training.ensemble=1",
    "training.trees=0",
    "training.process=false",
)
MECHANICS = ("mesh", "response", "coarse_response")


def tiny_cube() -> ObjectSpec:
    """Nine contact locations on one face."""
    return load_spec(SMALL_CUBE, ['name="tiny"', *CHANGES])


def lend_mechanics(store: Path) -> None:
    """Copy mesh and responses into a store; all processes of the tests make them once."""
    with only_one("mechanics") as shared:
        run = Run(tiny_cube(), root=shared)
        made = [run.require(name) for name in MECHANICS]
    for result in made:
        shutil.copytree(result.folder, store / result.folder.relative_to(shared))
