"""`instobj bench bringup`: from soldered chips to a closed object of which is known how it was built."""

from __future__ import annotations

import json
from contextlib import closing, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from design.errors import InputError, StoreError
from design.files import atomic_path
from design.spec.assembly import AsBuiltSpec
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.recordings.boards.link import BAUD, serial_chunks
from instobj.bench.bringup.as_built import merge_as_built, write_as_built
from instobj.bench.bringup.asking.asked import STEPS, Question, asked_of
from instobj.bench.bringup.diagnosis.chip_findings import GAIN_TO_TELL, wide_gains
from instobj.bench.bringup.diagnosis.findings import Finding
from instobj.bench.bringup.dialogue import ask_questions, open_questions
from instobj.bench.bringup.journal import Journal, open_journal, read_journal
from instobj.bench.bringup.page import bringup_page
from instobj.bench.bringup.simulated import parse_fault, simulated_object
from instobj.bench.bringup.sources import Board, FromFile, Simulated, Source
from instobj.bench.bringup.verdict import Verdict, judge
from instobj.store.progress import ProgressLine
from instobj.store.publish import file_rows, run_folder

JOURNAL, PAGE, RESULT = "bringup.csv", "bringup.html", "bringup.json"
_DESIGN_ALONE = "as_built={magnets=[],sensors=[]}"


@dataclass(frozen=True)
class BringupOptions:
    """Options of the command line; `again` names steps or recordings to take once more."""

    spec: Path
    out: Path
    port: str | None = None
    replay: Path | None = None
    faults: tuple[str, ...] | None = None
    again: tuple[str, ...] = ()
    baud: int = BAUD
    overrides: tuple[str, ...] = ()


def bring_up(options: BringupOptions) -> dict[str, Any]:
    """Ask what is still open, judge what is known, and write journal, page and `as_built`.

    Raises
    ------
    InputError
        Not exactly one source, a journal of another object, or a board that broke off; what was
        recorded is kept.
    """
    _require_one_source(options)
    design = load_spec(options.spec, [*options.overrides, _DESIGN_ALONE])
    questions = asked_of(design)
    again = _to_repeat(questions, options.again)
    journal = _journal(options, design)
    _ask(options, design, journal, again)
    unanswered = open_questions(questions, journal)
    progress = ProgressLine()
    with progress.stage("bringup"):
        progress.step("judging all recordings")
        verdict = judge(design, journal.recordings)
    files = _write(options, design, journal, verdict, unanswered)
    return _document(design, journal, verdict, unanswered, files)


def _require_one_source(options: BringupOptions) -> None:
    given = [options.port is not None, options.replay is not None, options.faults is not None]
    if sum(given) != 1:
        raise InputError(
            "give one of --port, --replay and --simulated: where the readings come from"
        )


def _journal(options: BringupOptions, design: ObjectSpec) -> Journal:
    """That of the object's board goes on; replays and simulated objects begin a new one next to it."""
    ending = "_simulated" if options.faults is not None else "_replayed" if options.replay else ""
    path = run_folder(options.out, design.name) / f"bringup{ending}" / JOURNAL
    if options.replay is not None and options.replay.resolve() == path.resolve():
        raise InputError(f"{path} cannot be replayed into itself. Give another --out")
    if ending:
        path.unlink(missing_ok=True)
    return open_journal(path, design)


def _to_repeat(questions: tuple[Question, ...], again: tuple[str, ...]) -> set[str]:
    names = {question.name for question in questions if {question.name, question.step} & set(again)}
    unknown = set(again) - names - {question.step for question in questions}
    if unknown:
        raise InputError(
            f"--repeat {', '.join(sorted(unknown))}: no such step or recording. Give one of "
            f"{', '.join(STEPS)}, or a recording such as 'held F1-S1'"
        )
    return names


def _ask(options: BringupOptions, design: ObjectSpec, journal: Journal, again: set[str]) -> None:
    """All open questions; an error keeps what was recorded and says so."""
    chunks = serial_chunks(options.port, options.baud) if options.port is not None else None
    source: Source
    if chunks is not None:
        source = Board(design, chunks, str(options.port))
    elif options.replay is not None:
        source = FromFile(read_journal(options.replay, design))
    else:
        faults = tuple(parse_fault(text) for text in options.faults or ())
        source = Simulated(simulated_object(design, design.seed, faults))
    with closing(chunks) if chunks is not None else nullcontext():
        try:
            ask_questions(design, source, journal, again)
        except (InputError, StoreError) as error:
            kept = f"{len(journal.recordings)} recordings are kept in {journal.path}"
            raise InputError(f"{error}. {kept}") from None


def _write(
    options: BringupOptions,
    design: ObjectSpec,
    journal: Journal,
    verdict: Verdict,
    open_questions: list[Question],
) -> list[Path]:
    folder = journal.path.parent
    written = [journal.path]
    page = bringup_page(design, journal.recordings, journal.skipped, verdict, open_questions)
    for name, text in ((RESULT, json.dumps(_figures(verdict), indent=1)), (PAGE, page)):
        with atomic_path(folder / name) as temporary:
            temporary.write_text(text, encoding="utf-8")
        written.append(folder / name)
    if open_questions:
        return written
    as_built_path = options.spec.with_name(f"{options.spec.stem}.as_built.toml")
    earlier = AsBuiltSpec()
    if as_built_path.is_file():
        earlier = load_spec(options.spec, options.overrides).as_built
    target = folder / as_built_path.name if options.faults is not None else as_built_path
    as_built = merge_as_built(design, verdict, earlier)
    remarks = [str(finding) for finding in verdict.findings]
    return [*written, write_as_built(as_built, target, remarks)]


def _figures(verdict: Verdict) -> dict[str, Any]:
    """All that was measured, for programs."""
    chips, earth = verdict.chips or (), verdict.earth
    return {
        "findings": [_finding_row(finding) for finding in verdict.findings],
        "chips": [
            {
                "sits_at": chip.site,
                "turn": np.round(chip.turn, 4).tolist(),
                "gain": _plain(chip.gain),
                "gain_interval": _plain(chip.gain_interval),
                "dead": list(chip.dead),
            }
            for chip in chips
        ],
        "earth": earth
        and {
            "field_ut": [round(earth.field_ut, 2), round(earth.field_interval_ut, 2)],
            "offset_counts": _plain(earth.offset),
            "offset_interval_counts": _plain(earth.offset_interval),
            "gain": _plain(earth.gain),
            "gain_interval": _plain(earth.gain_interval),
        },
        "moments": [round(magnet.strength, 3) for magnet in verdict.magnets],
        "resting_levels_fit": None if verdict.levels is None else verdict.levels.fit,
    }


def _plain(values: np.ndarray) -> Any:
    """Rounded lists, None where nothing is known."""
    rounded = np.round(values, 4).astype(object)
    rounded[~np.isfinite(values)] = None
    return rounded.tolist()


def _finding_row(finding: Finding) -> dict[str, str]:
    return {
        "found": finding.kind,
        "where": finding.where,
        "measured": finding.measured,
        "to do": finding.remedy,
    }


def _document(
    design: ObjectSpec,
    journal: Journal,
    verdict: Verdict,
    open_questions: list[Question],
    files: list[Path],
) -> dict[str, Any]:
    texts = []
    if journal.cut_bytes:
        texts.append(f"an unfinished recording of {journal.cut_bytes} bytes was cut off")
    if open_questions:
        texts.append(
            f"{len(open_questions)} recordings are open, the next one: {open_questions[0].name}. "
            "Repeat the command"
        )
    wide = wide_gains(design, verdict.chips, verdict.earth) if verdict.chips else []
    if wide and not open_questions:
        texts.append(
            f"gains of {', '.join(wide)} are not known well enough to tell {GAIN_TO_TELL:.0%} surely"
        )
    if journal.skipped:
        texts.append(f"skipped: {', '.join(sorted(journal.skipped))} (--repeat takes them)")
    if not verdict.findings:
        texts.append("nothing is out of order in what was recorded")
    return {
        "command": "bringup",
        "object": design.name,
        "recorded": len(journal.recordings),
        "left": [question.name for question in open_questions],
        "texts": texts,
        "tables": {"what to put right": [_finding_row(finding) for finding in verdict.findings]},
        "files": file_rows(files),
        "passed": not verdict.findings and not open_questions,
    }
