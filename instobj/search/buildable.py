"""Buildability of a layout that a search found: checks of fabrication, solids and mould included."""

from __future__ import annotations

from design.fabrication.finding import Finding
from design.spec.object import ObjectSpec
from instobj.stages.run import Run
from instobj.store.readers import FINDINGS


def failed_checks(spec: ObjectSpec) -> dict[tuple[str, str], str]:
    """By part and check, all that `instobj check --fabrication` fails, in words; from the store, or made."""
    findings = [Finding(**found) for found in Run(spec).read(FINDINGS)["findings"]]
    return {(one.part, one.check): one.told for one in findings if one.status == "fail"}


def why_unbuildable(found: ObjectSpec, start: ObjectSpec) -> str:
    """What fails in a layout and not in the start, which is what a search can answer for; or nothing."""
    new = failed_checks(found)
    known = failed_checks(start) if new else {}
    return "; ".join(text for key, text in new.items() if key not in known)
