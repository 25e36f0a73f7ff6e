"""Dialogue of a bring-up: one question after the other, each answered by a recording, kept at once."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from design.spec.object import ObjectSpec
from estimator.signals.hall import full_scale_counts
from instobj.bench.bringup.asking.asked import STEPS, Question, Recording, asked_of
from instobj.bench.bringup.diagnosis.findings import ChipFound, Finding
from instobj.bench.bringup.diagnosis.poles import PocketFields, magnet_findings, pocket_fields
from instobj.bench.bringup.journal import Journal
from instobj.bench.bringup.sources import KEEP, QUIT, SKIP, Source
from instobj.bench.bringup.verdict import drawn_chips, identified_chips, magnet_found
from instobj.store.progress import ProgressLine

_LEAST_RESPONSE_COUNTS = 300.0
"""Change of counts from which a magnet is held near enough."""


@dataclass
class _Checks:
    """Checks of a recording as soon as it is there."""

    design: ObjectSpec
    journal: Journal

    @cached_property
    def chips(self) -> tuple[ChipFound, ...]:
        """Return the chips as found, once the first magnet is in."""
        return identified_chips(self.design, self.journal.recordings) or drawn_chips(self.design)

    @cached_property
    def fields(self) -> PocketFields:
        """Steps that magnets make, as these chips read them."""
        return pocket_fields(self.design, self.chips)

    def doubts(self, question: Question, recording: Recording) -> list[str]:
        """Return why the recording should be repeated; nothing where it is as it should be."""
        if question.step == "held":
            return self._hold_doubts(recording)
        if question.step == "magnet":
            return [
                f"{finding}. {finding.remedy}"
                for finding in self._magnet_findings(question, recording)
            ]
        return []

    def _hold_doubts(self, recording: Recording) -> list[str]:
        limit = full_scale_counts(self.design.sensors)
        if np.nanmax(abs(recording.counts), initial=0.0) >= limit:
            return [f"a chip is at full scale ({limit:.0f} counts): hold the magnet higher"]
        still = self.journal.recordings.get("still")
        if still is None:
            return []
        change = np.nanmax(abs(recording.mean - still.mean), initial=0.0)
        if change >= _LEAST_RESPONSE_COUNTS:
            return []
        return [f"the largest change is {change:.0f} counts: hold the magnet nearer"]

    def _magnet_findings(self, question: Question, recording: Recording) -> list[Finding]:
        recordings = self.journal.recordings | {question.name: recording}
        magnet = magnet_found(self.design, recordings, self.chips, self.fields, question)
        return [] if magnet is None else magnet_findings(self.design, magnet)


def open_questions(questions: tuple[Question, ...], journal: Journal) -> list[Question]:
    """Questions without an answer, in their order."""
    done = journal.recordings.keys() | journal.skipped
    return [question for question in questions if question.name not in done]


def ask_questions(design: ObjectSpec, source: Source, journal: Journal, again: set[str]) -> None:
    """Ask what is open or to be repeated, until all is answered or the user stops."""
    questions, progress = asked_of(design), ProgressLine()
    open_ones = {question.name for question in open_questions(questions, journal)} | again
    checks = _Checks(design, journal)
    for number, question in enumerate(questions, start=1):
        if question.name not in open_ones:
            continue
        title = f"{number} of {len(questions)}, {STEPS[question.step]}"
        if not _answered(question, title, source, journal, checks, progress):
            return


def _answered(
    question: Question,
    title: str,
    source: Source,
    journal: Journal,
    checks: _Checks,
    progress: ProgressLine,
) -> bool:
    """Return whether to go on: False where the user stops."""
    text = f"[{title}] {question.question}, then press Enter (s skips, q stops)"
    allowed = SKIP + QUIT
    while True:
        answer = source.answer(text, allowed)
        if answer == QUIT:
            return False
        if answer == KEEP:
            return True
        if answer == SKIP:
            journal.skip(question.name)
            return True
        recording = source.record(question)
        if recording is None:
            return True
        doubts = checks.doubts(question, recording)
        journal.append(recording)
        if not doubts:
            return True
        progress.say(f"{question.name}: {'; '.join(doubts)}")
        text = f"[{title}] Put it right and press Enter to record it again (k keeps it, s skips, q stops)"
        allowed = KEEP + SKIP + QUIT
