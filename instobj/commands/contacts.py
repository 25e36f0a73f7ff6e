"""Contacts of the whole object in a file or on a board's port, by inversion of the forward model."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from design.errors import InputError
from design.tables import write_table
from estimator.deploy.live_contacts import LiveContacts
from estimator.frames.dataset import FrameSet
from estimator.inversion.condition import Condition, object_condition
from estimator.inversion.inversion import Inversion
from estimator.inversion.model.forward import NONE
from estimator.inversion.readings import ContactSets
from estimator.inversion.slip import median_slip_mm
from estimator.inversion.storage import load_inversion
from estimator.signals.nuisances import AMBIENT_FIELD
from instobj.commands.next_step import next_step
from instobj.commands.readings import (
    LiveFrame,
    Stream,
    Zeroing,
    is_data_set,
    is_unexplained,
    live_frames,
    prediction_path,
    recorded_frames,
    recorded_stream,
    unexplained_text,
    zeroed_data_set,
)
from instobj.robot import foxglove_channels, new_mcap_file
from instobj.store.progress import ProgressLine
from instobj.store.publish import file_rows

FIELD = ("field_x_ut", "field_y_ut", "field_z_ut", "field_sigma_ut")
"""Change of a uniform field since the zero, in the object's frame, and its standard deviation."""
_STEP = 50
"""Frames between two words of progress."""
COLUMNS: tuple[str, ...] = (
    *("frame", "time_s", "contacts", "odds", "next_contacts", "next_odds", "p_value", "explained"),
    *("chip_out", *FIELD, "contact", "face", "x_mm", "y_mm", "position_radius_mm", "force_n"),
    *("force_halfwidth_n", "tangential_x_n", "tangential_y_n", "tangential_sigma_n"),
    *("kind", "tilt_x_deg", "tilt_y_deg", "size_x_mm", "size_y_mm", "size_halfwidth_mm"),
)


def contacts_in_file(model_path: Path, path: Path, out: Path, zeroing: Zeroing) -> dict[str, Any]:
    """Read every frame of a file; writes `out/runs/<name>/contacts.csv`, one row per contact.

    `run_name` gives the name. Where `out` is an MCAP file, frames go there too
    (`instobj.robot.foxglove_channels`), and the table to its folder.

    Frames of a data set are read one by one, with the next best answer; those of a recording are
    zeroed and tracked like a board's. A data set with labels is judged too.

    Raises
    ------
    InputError
        A bad model or file, readings of another object, or no zero in the whole file.
    """
    inversion = load_inversion(model_path)
    mcap = new_mcap_file(out, path.stem)
    target = prediction_path("contacts.csv", path, mcap.parent if mcap else out)
    judged: list[dict[str, Any]] = []
    texts: list[str] = []
    if is_data_set(path):
        number, time_s, best, second, judged, slip_mm = _read_data_set(inversion, path, zeroing)
        unread, chips = 0, sorted(set(best.chip_out.tolist()) - {NONE})
        condition = object_condition(
            float(np.mean(~best.explained)),
            slip_mm=slip_mm,
            chips_out=[inversion.chip_name(chip) for chip in chips],
        )
    else:
        stream = recorded_stream(path)
        number, time_s, best, unread, condition = _read_recording(inversion, stream, zeroing)
        second, texts = None, stream.texts
        if stream.loaded is not None:
            texts.append(
                f"{path.name} has labels: `instobj recordings {path} --spec SPEC.toml` makes a data set "
                "of it, whose contacts `predict` judges against them"
            )
    rows = _rows(inversion, number, time_s, best, second)
    write_table(target, list(COLUMNS), ([row[name] for name in COLUMNS] for row in rows))
    if mcap is not None:
        if not np.isfinite(time_s).all():
            raise InputError(f"{path} has no stamps, which {mcap} needs. Leave --out {mcap} out")
        with foxglove_channels(mcap, inversion.model.spec) as send:
            for row in range(len(best)):
                send(_document(inversion, number[row], time_s[row], best.select(np.array([row]))))
    summary = {
        "frames": len(best),
        "frames that lack a reading": unread,
        "frames with contact": int((best.number > 0).sum()),
        "most contacts": int(best.number.max(initial=0)),
        "largest total force N": round(float(np.nansum(best.force_n, axis=1).max(initial=0)), 3),
        "frames with jaws": int(best.jaws.sum()),
        "frames that no contact explains": int((~best.explained).sum()),
        "frames without a chip that was not believed": int((best.chip_out != NONE).sum()),
        "condition of the object": str(condition),
    }
    unexplained = int((~best.explained).sum())
    texts = [*texts, *unexplained_text(path, unexplained, len(best))]
    go_on = next_step("predict contacts", model_path, path, out=target.parents[2])
    if is_unexplained(unexplained, len(best)):
        go_on = next_step("predict contacts unexplained")
    if best.jaws.any():
        texts.append(
            f"{int(best.jaws.sum())} frames are read as flat jaws. Size and force of a jaw that covers a "
            "part of a face are uncertain together: take the half-widths with them"
        )
    tables = {f"{path.name}, {model_path.name}": [summary]}
    files = [target] if mcap is None else [target, mcap]
    if judged:
        tables["against the labels, means over frames"] = judged
    return {
        "command": "predict",
        "texts": texts,
        "tables": tables,
        "files": file_rows(files),
        "next": go_on,
    }


def contacts_on_port(
    model_path: Path, port: str, zeroing: Zeroing, count: int | None, baud: int = 115_200
) -> Iterator[str]:
    """One JSON document per frame from a board, `count` of them or without end.

    Raises
    ------
    InputError
        A bad model or port, or readings of another object.
    """
    inversion = load_inversion(model_path)
    reader = LiveContacts(inversion, *zeroing.raw_settings)
    reader.warm_up()
    frames = islice(live_frames(reader, inversion.channels, port, baud), count)
    return (
        json.dumps(contacts_of(inversion, frame) | {"condition": str(reader.condition())})
        for frame in frames
    )


def contacts_of(inversion: Inversion, frame: LiveFrame) -> dict[str, Any]:
    """Return a board's frame as `instobj predict --port` prints it."""
    return _document(inversion, frame.number, frame.time_s, frame.reading) | frame.line


def shown_in_foxglove(documents: Iterable[str], model_path: Path, out: Path) -> Iterator[str]:
    """Yield the documents of `contacts_on_port`, each shown in Foxglove (`instobj.robot`)."""
    with foxglove_channels(out, load_inversion(model_path).model.spec) as send:
        for document in documents:
            send(json.loads(document))
            yield document


def _read_data_set(
    inversion: Inversion, path: Path, zeroing: Zeroing
) -> tuple[np.ndarray, np.ndarray, ContactSets, ContactSets, list[dict[str, Any]], float]:
    from estimator.frames.windows import all_counts
    from estimator.metrics.contacts import rows_beside_bound

    frames = zeroed_data_set(path, zeroing)
    require_read_sensors(inversion, frames, path)
    progress = ProgressLine()
    with progress.stage(f"contacts in {path}"):
        best, second = inversion.read(
            all_counts(frames),
            progress=lambda done: progress.step(f"frame {done} of {len(frames)}"),
        )
    judged, valid = [], np.flatnonzero(frames.valid)
    if np.any(frames.contact_face[valid] > 0):
        judged = rows_beside_bound(inversion, frames.select(valid), best.select(valid))
    slip_mm = median_slip_mm(inversion, all_counts(frames)[~best.explained])
    return np.arange(len(frames)), frames.time_s, best, second, judged, slip_mm


def require_read_sensors(inversion: Inversion, frames: FrameSet, path: Path) -> None:
    """Raise InputError where frames have other faces or sensors than the estimator reads."""
    faces = inversion.model.signals.faces.tolist()
    sensors = inversion.model.channels // (3 * len(faces))
    got = frames.faces.tolist(), frames.signal_counts.shape[2]
    if got != (faces, sensors):
        raise InputError(
            f"{path} has {got[1]} sensors on faces {got[0]}; the estimator reads {sensors} on faces "
            f"{faces}. Give the data set of the object that it was made for"
        )


def _read_recording(
    inversion: Inversion, stream: Stream, zeroing: Zeroing
) -> tuple[np.ndarray, np.ndarray, ContactSets, int, Condition]:
    reader, progress = LiveContacts(inversion, *zeroing.raw_settings), ProgressLine()

    def step(number: int) -> None:
        if number % _STEP == 0:
            progress.step(f"frame {number} of {len(stream.raw)}")

    with progress.stage(f"contacts in {stream.path}"):
        frames = recorded_frames(reader, inversion.channels, stream, zeroing, step)
    read = [frame for frame in frames if frame[2] is not None]
    numbers, time_s, readings = zip(*read, strict=True)
    unread = len(frames) - len(read)
    best = ContactSets.joined(readings)
    return np.array(numbers), np.array(time_s), best, unread, reader.condition()


def _field_change(inversion: Inversion, best: ContactSets, row: int) -> dict[str, float | str]:
    """Return the columns of `FIELD`; empty cells of an object that is not turned."""
    first = 0
    for nuisance in inversion.disturbances.nuisances:
        if nuisance.name == AMBIENT_FIELD:
            along_axes = slice(first, first + 3)
            sigma = float(best.since_zero_sigma[row, along_axes].max())
            if np.isnan(sigma):  # beside jaws it is not read
                break
            values = (*best.since_zero[row, along_axes].tolist(), sigma)
            return dict(zip(FIELD, (round(value, 2) for value in values), strict=True))
        first += nuisance.columns.shape[1]
    return dict.fromkeys(FIELD, "")


def _rows(
    inversion: Inversion,
    number: np.ndarray,
    time_s: np.ndarray,
    best: ContactSets,
    second: ContactSets | None,
) -> Iterator[dict[str, Any]]:
    """One row per contact; a frame without contact has one row with empty cells."""
    radius, halfwidth = best.position_radius_mm, best.force_halfwidth_n
    for row in range(len(best)):
        shared = {
            "frame": int(number[row]),
            "time_s": round(float(time_s[row]), 6),
            "contacts": int(best.number[row]),
            "odds": round(float(best.odds[row]), 4),
            "next_contacts": "" if second is None else int(second.number[row]),
            "next_odds": "" if second is None else round(float(second.odds[row]), 4),
            "p_value": float(f"{best.p_value[row]:.3g}"),
            "explained": int(best.explained[row]),
            "chip_out": inversion.chip_name(int(best.chip_out[row])),
            **_field_change(inversion, best, row),
        }
        if not best.number[row]:
            yield shared | dict.fromkeys(COLUMNS[9 + len(FIELD) :], "")
        for slot in np.flatnonzero(best.face[row]).tolist():
            values = {
                "x_mm": best.xy_mm[row, slot, 0],
                "y_mm": best.xy_mm[row, slot, 1],
                "position_radius_mm": radius[row, slot],
                "force_n": best.force_n[row, slot],
                "force_halfwidth_n": halfwidth[row, slot],
                "tangential_x_n": best.tangential_n[row, slot, 0],
                "tangential_y_n": best.tangential_n[row, slot, 1],
                "tangential_sigma_n": best.tangential_sigma_n[row, slot].max(),
                "tilt_x_deg": best.tilt_deg[row, slot, 0],
                "tilt_y_deg": best.tilt_deg[row, slot, 1],
                "size_x_mm": best.size_mm[row, slot, 0, 0],
                "size_y_mm": best.size_mm[row, slot, 1, 0],
                "size_halfwidth_mm": best.size_halfwidth_mm[row, slot],
            }
            kind = {"kind": "jaw" if best.jaws[row] else "tip"}
            rounded = {
                name: "" if np.isnan(value) else round(float(value), 3)
                for name, value in values.items()
            }
            yield shared | {"contact": slot + 1, "face": int(best.face[row, slot])} | rounded | kind


def _document(
    inversion: Inversion, number: int, time_s: float, reading: ContactSets
) -> dict[str, Any]:
    rows = list(_rows(inversion, np.array([number]), np.array([time_s]), reading, None))
    of_frame = ("frame", "time_s", "odds", "p_value", "chip_out", *FIELD)
    contacts = [
        {name: row[name] for name in COLUMNS[10 + len(FIELD) :] if row[name] != ""}
        for row in rows
        if row["contacts"]
    ]
    explained = {"explained": bool(rows[0]["explained"])}
    frame = {name: rows[0][name] for name in of_frame if rows[0][name] != ""}
    return frame | explained | {"contacts": contacts}
