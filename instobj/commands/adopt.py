"""`instobj adopt`: logs of an object that others built, identified and made a specification."""

from __future__ import annotations

import tomllib
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.errors import InputError
from design.files import atomic_path
from design.spec_io import load_spec
from estimator.adoption.columns import ORDER_OF_COLUMNS
from estimator.adoption.findings import CERTAIN
from estimator.adoption.identify import Identified, Known, identify
from instobj.commands.adopt_fit import (
    boards_of_logs,
    complaint_about,
    fit_specification,
    why_not_fitted,
)
from instobj.commands.next_step import next_step
from instobj.store.progress import ProgressLine
from instobj.store.publish import file_rows, require_writable, run_folder
from instobj.store.stage import write_json

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

_NO_ARRANGEMENT = (
    "arrangement, normal or reverse: in no log alone. A chip's reading changes with the motion between it "
    "and the magnets, whichever moves. --spec FILE with the places of chips and magnets has both fitted"
)
_MOST_QUESTIONS = 3
"""Questions asked at once, in the order in which their answers are needed."""


def adopt_logs(
    logs: list[Path], statements: list[str], spec: Path | None, out: Path, overrides: list[str]
) -> dict[str, Any]:
    """Identify the object of some logs; with a specification, fit it to them as well.

    Results go to `runs/<name>/adoption.json` and, with a specification, to `runs/<name>/<name>.toml`.

    Raises
    ------
    InputError
        A log that cannot be read, an answer that is not asked for, or a bad specification.
    """
    from estimator.recordings.formats.travel import is_travel_recording

    require_writable(out)
    answers = read_answers(statements)
    start = None if spec is None else load_spec(spec, overrides)
    if any(is_travel_recording(path) for path in logs):
        return _adopt_folders(logs, start, spec)
    progress = ProgressLine()
    with progress.stage("identification from the data"):
        identified = identify(logs, answers)
    name = "+".join(path.name.split(".")[0] for path in logs)
    target = run_folder(out, name)
    target.mkdir(parents=True, exist_ok=True)
    document, texts, files = _document(identified), _texts(identified), [target / "adoption.json"]
    further = {}
    if spec is not None and start is not None:
        if identified.kind == "force" and identified.presses[0].face.shape[1] > 1:
            boards = boards_of_logs(identified, start)
            document["findings"] += [{"log": where} | asdict(finding) for where, finding in boards]
            heads = len(logs) > 1  # one log's head stands there already
            texts += [
                line
                for where, finding in boards
                for line in (*([where] if heads else []), f"  {finding}")
            ]
        elif why := why_not_fitted(identified, answers):
            texts.append(why)
        else:
            fitted = target / f"{start.name}_adopted.toml"
            findings, document["fit"], text = fit_specification(
                identified, answers, spec, start, progress
            )
            document["findings"] += [{"log": spec.name} | asdict(finding) for finding in findings]
            texts += [spec.name, *(f"  {finding}" for finding in findings)]
            with atomic_path(fitted) as temporary:
                temporary.write_text(text, encoding="utf-8")
            files.append(fitted)
            further = {"next": next_step("adopt", fitted)}
            if complaint := complaint_about(text, fitted):
                further = {"next": next_step("new", fitted)}
                texts.append(f"{fitted.name} does not pass `instobj check`: {complaint}")
            else:
                from instobj.commands.first_layout import gain_text  # loads torch

                with progress.stage("a better layout of the same parts"):
                    texts.append(gain_text(tomllib.loads(text)))
    elif identified.orders:
        texts.append(_NO_ARRANGEMENT)
    write_json(document, target / "adoption.json")
    questions = open_questions(identified, answers, spec is not None)
    return {
        "command": "adopt",
        "adoption": document,
        "texts": texts,
        **({"tables": {"still to be stated": questions}} if questions else {}),
        "questions": questions,
        "files": file_rows(files),
        **further,
    }


def _adopt_folders(
    folders: list[Path], spec: ObjectSpec | None, path: Path | None
) -> dict[str, Any]:
    """Find the chips' order in folders of presses of known travel: `instobj validate` does the rest."""
    from estimator.adoption.sinking import order_by_sinking
    from estimator.recordings.formats.travel import read_travel

    if spec is None or path is None:
        raise InputError(
            "a folder of sensor.csv and states.csv names its places and travels; the order of its chips is "
            "found with --spec FILE"
        )
    findings = []
    for folder in folders:
        readings = read_travel(folder).field_mt
        if readings.shape[1] != spec.sensors.count_per_face:
            raise InputError(
                f"{folder} holds {readings.shape[1]} chips; {spec.name} has "
                f"{spec.sensors.count_per_face} on a face. Give the specification of this object"
            )
        findings.append((folder.name, order_by_sinking(spec, readings)[1]))
    return {
        "command": "adopt",
        "adoption": {"findings": [{"log": name} | asdict(finding) for name, finding in findings]},
        "texts": [line for name, finding in findings for line in (name, f"  {finding}")],
        "questions": [],
        "next": next_step("adopt order", path, folders[0]),
    }


def _texts(identified: Identified) -> list[str]:
    """Return log by log what was assumed and found, each once."""
    heads = list(dict.fromkeys(where for where, _ in (*identified.notes, *identified.findings)))
    lines = []
    for head in heads:
        lines.append(head)
        lines += [f"  {note}" for where, note in identified.notes if where == head]
        lines += [f"  {finding}" for where, finding in identified.findings if where == head]
    return lines


def read_answers(given: list[str]) -> Known:
    """Read `KEY=VALUE` and TOML files of answers; what stands last holds.

    Raises
    ------
    InputError
        No such file, no TOML, or a key that is not asked for.
    """
    answers: dict[str, object] = {}
    for text in given:
        key, equals, value = text.partition("=")
        if not equals:
            answers |= _answers_of_file(Path(text))
            continue
        try:
            answers[key.strip()] = tomllib.loads(f"value = {value}")["value"]
        except tomllib.TOMLDecodeError:
            answers[key.strip()] = value.strip()
    return Known.read(answers)


def _answers_of_file(path: Path) -> dict[str, object]:
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InputError(
            f"--known {path}: {error}. Give KEY=VALUE, or a TOML file of keys and values"
        ) from None


def open_questions(identified: Identified, answers: Known, with_spec: bool) -> list[dict[str, str]]:
    """Return what no log can tell and a fit needs, three questions at most."""
    questions = []
    if any(
        finding.question == ORDER_OF_COLUMNS and finding.p is not None and finding.p > CERTAIN
        for _, finding in identified.findings
    ):
        questions.append(
            {
                "question": "How do the columns hold the axes of a chip?",
                "answer": "--known axes=chip (x1, y1, z1, x2, …) or axes=axis (x1, x2, …)",
            }
        )
    if not identified.all_presses.labelled:
        questions.append(
            {
                "question": "Which face and place does each row press? Presses cannot be told from rest.",
                "answer": "a log with such columns; --known columns=face,place,level,chips names them",
            }
        )
        return questions
    if identified.kind == "level" and answers.step_mm is None:
        questions.append(
            {
                "question": "How much deeper does the tip go from one level to the next?",
                "answer": "--known step_mm=1.0 (mm)",
            }
        )
    if identified.orders and answers.pitch_mm is None:
        questions.append(
            {
                "question": "How far apart were the places that were pressed?",
                "answer": "--known pitch_mm=[10,12] (10 mm from row to row, 12 mm within a row)",
            }
        )
    if not with_spec:
        questions.append(
            {
                "question": "Which body, sensors and magnets has the object? A fit starts from them.",
                "answer": "--spec my_object.toml (instobj new writes one)",
            }
        )
    return questions[:_MOST_QUESTIONS]


def _document(identified: Identified) -> dict[str, Any]:
    return {
        "logs": [str(path) for path in identified.paths],
        "notes": [{"log": where, "note": note} for where, note in identified.notes],
        "findings": [{"log": where} | asdict(finding) for where, finding in identified.findings],
        "label": identified.kind,
        "chips": identified.presses[0].change.shape[1],
        "presses": [len(table) if table.labelled else 0 for table in identified.presses],
        "chips_of_face": {
            str(face): [chip + 1 for chip in chips]
            for face, chips in identified.chips_of_face.items()
        },
        "orders_of_places": [
            {
                "log": identified.paths[log].name,
                "face": face,
                "order": order.name,
                "places": order.place.tolist(),
                "grid": order.grid.tolist(),
                "rank_correlation": [round(float(value), 3) for value in order.rank_correlation],
                "null_median": round(float(sorted(order.null)[len(order.null) // 2]), 3),
                "p": order.p,
            }
            for (log, face), order in identified.orders.items()
        ],
    }
