"""An explorer on made-up motions, for tests of the page and of what it is told."""

from functools import cache

from design.spec.learning import LimitsSpec
from estimator.layouts.presses.basis import press_bases
from instobj.explore.engine import Explorer
from tests.support.mechanics.candidate_cases import made_up_motions, made_up_spec

FORCES_N = (2.0, 5.0, 8.0)
"""Forces that are pressed: the second is `score.force_n`, which the search does not name."""


@cache
def made_explorer():
    """Explorer of the paper's cube with 5 × 4 contact locations on a face, which stands still as zeroed."""
    spec = made_up_spec().changed(limits=LimitsSpec(use="bench"))
    spec = spec.changed(search=spec.search.changed(forces_n=FORCES_N[::2]))
    motions = made_up_motions(spec)
    faces = spec.body.sensed
    return Explorer(spec, FORCES_N, {f: [press_bases(spec, motions, f, FORCES_N)] for f in faces})
