"""Forces and magnets' motions under jaws, pads, cylinders and fingertips, against an independent code.

`benchmarks/forces_of_jaws.py`: NGSolve, Taylor–Hood P2/P1, edges of 0.9 to 2.4 mm under the indenter.
"""

import json
from pathlib import Path

import pytest

from benchmarks.forces_of_jaws import case_errors
from design.spec.object import IndenterSpec, ObjectSpec
from fem.linear.response import build_response
from fem.mesh.tetrahedra import tetrahedralize
from tests.support.objects.magnet_box import BOX

RESULTS = Path(__file__).parents[3] / "benchmarks" / "references" / "jaws.json"
WANTED = json.loads(RESULTS.read_text(encoding="utf-8"))
SPECS = {"cube": ObjectSpec(name="cube"), "box": BOX}


@pytest.mark.slow
@pytest.mark.parametrize("body", WANTED)
def test_forces_and_motions_are_within_three_percent(body):
    """Pads that end on the face are too stiff by up to 9 %; the box's fingertip is on a shallow rim."""
    spec = SPECS[body]
    response = build_response(tetrahedralize(spec), spec)
    for name, wanted in WANTED[body].items():
        most = 0.1 if name.startswith("pad 24") else 0.03
        most_motion = max(most, 0.04 if (body, name) == ("box", "fingertip") else 0.0)
        pressed = spec.changed(indenter=IndenterSpec.model_validate(wanted["indenter"]))
        errors = case_errors(pressed, response, wanted["x_mm"], wanted)
        assert max(map(abs, errors["force_percent"])) < 100 * most, (name, errors)
        assert max(errors["motion_percent"]) < 100 * most_motion, (name, errors)
