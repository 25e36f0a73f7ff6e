"""Results that `instobj run --to` names."""

from instobj.cli.options import TARGETS
from instobj.report.remedies import DESIGN_STAGES
from instobj.stages.run import with_needs


def test_a_verdict_needs_all_that_it_is_read_from_and_no_training():
    named = TARGETS["verdict"].split()
    assert {*named} == {*DESIGN_STAGES, "robustness", "alternatives"}
    assert {*TARGETS["scores"].split()} >= {*DESIGN_STAGES}, "a verdict by the design"
    needed = {*with_needs(*named)}
    assert "signals" in needed
    assert not needed & {"frames", "networks", "inversion", "contact_metrics", "report"}
    assert "contact_metrics" in with_needs("report"), "which the report does need"
