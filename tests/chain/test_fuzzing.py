"""Damaged files give one error or a sound reading; never a traceback, a hang or another result.

`INSTOBJ_FUZZ_CASES` and `INSTOBJ_FUZZ_SEED` set how many files a target gets, and which.
"""

import json
import os
import signal
import tomllib
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
import tomli_w
import trimesh

import instobj
from design.body.foreign import read_foreign_surface
from design.errors import InstobjError
from estimator.boards.lines import (
    Header,
    LineDecoder,
    Load,
    checksum,
    encode_frame,
    encode_header,
    encode_load,
)
from estimator.frames.dataset import save_frames
from estimator.recordings.table import LARGEST_FORCE_N
from instobj.store.content import stored
from tests.support.made_recordings import gripper_arrays, write_gripper, write_training
from tests.support.mutations import damaged_bytes, damaged_tables, damaged_text

CASES = int(os.environ.get("INSTOBJ_FUZZ_CASES", "200"))
SEED = int(os.environ.get("INSTOBJ_FUZZ_SEED", "1"))
SECONDS = 30.0
ROOT = Path(__file__).parents[2]
CORPUS = Path(__file__).parent / "corpus"


class TookTooLong(Exception):
    """A file that was not read in time."""


@contextmanager
def limited(seconds):
    def stop(*_):
        raise TookTooLong(f"more than {seconds} s")

    previous = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, previous)


def read_specification(path):
    instobj.check(instobj.load_spec(path))


def read_recording(path):
    frames = instobj.read_recording(path).frames
    assert np.all(np.diff(frames.time_s) > 0)
    assert (np.abs(np.nan_to_num(frames.force_n, posinf=1e9, neginf=1e9)) <= LARGEST_FORCE_N).all()


def read_surface(path):
    found = read_foreign_surface(path, "nothing there", seconds=SECONDS - 5)
    assert found.triangles.max() < len(found.vertices_mm)


def read_board(path):
    decoder = LineDecoder()
    for message in decoder.feed(path.read_bytes() + b"\n"):
        assert not isinstance(message, Header) or message.channels


READERS = {
    ".toml": read_specification,
    ".csv": read_recording,
    ".nc": read_recording,
    ".stl": read_surface,
    ".step": read_surface,
    ".board": read_board,
}


def fault_of(path):
    """What reading a file did that no reading may do; None if it was read, or refused in words."""
    try:
        with limited(SECONDS):
            READERS[path.suffix](path)
    except InstobjError as error:
        return None if str(error).strip() else "an error without a word"
    except Exception as error:
        return f"{type(error).__name__}: {str(error)[:200]}"
    return None


def sound_specifications():
    return sorted((ROOT / "examples").glob("*.toml"))


def sound_files(folder, suffix):
    """Sound files of a format, small ones."""
    if suffix == ".board":
        path = folder / "sound.board"
        path.write_bytes(sound_lines())
        return [path]
    if suffix in (".stl", ".step"):
        return [_solid(folder / f"sound{suffix}")]
    arrays = gripper_arrays(presses=2)
    paths = [
        write_gripper(folder / "gripper.csv", arrays),
        write_training(folder / "training.csv", {0: (0,), 1: (54,), 2: (23,)}),
    ]
    if suffix == ".csv":
        return paths
    recording = instobj.read_recording(paths[0])
    save_frames(recording.frames, folder / "frames.nc")
    return [folder / "frames.nc"]


def sound_lines():
    frames = [encode_frame(k, 100 * k, [float(k), -7.5, float("nan")]) for k in range(20)]
    load = encode_load(Load(12, 2, 7.25, 3, ((1.5, -4.5), (0.0, 13.5))))
    return b"".join([encode_header(("F3-X1", "F1-Z2", "F5-Y3")), *frames, load])


def with_checksums(lines):
    """Damaged bodies that the decoder has to read, as their checksums are right."""
    bodies = [line.partition(b"$")[2].rpartition(b"*")[0] for line in lines.split(b"\n")]
    return b"".join(b"$%s*%s\n" % (body, checksum(body).encode()) for body in bodies)


def _solid(path):
    if path.suffix == ".step":
        import cadquery as cq

        cq.exporters.export(cq.Workplane().box(10, 20, 30).edges("|Z").fillet(2), str(path))
    else:
        trimesh.creation.icosphere(2, 15.0).export(path)
    return path


def assert_no_faults(folder, damaged):
    """Of files given as (name, content); those that are faults stay in the folder."""
    faults = []
    for name, content in damaged:
        path = folder / name
        path.write_bytes(content)
        said = fault_of(path)
        if said:
            faults.append(f"{name}: {said}")
        else:
            path.unlink()
    assert not faults, f"{len(faults)} files, kept in {folder}:\n" + "\n".join(faults[:20])


@pytest.mark.slow
@pytest.mark.parametrize("way", ["tables", "text", "bytes"])
def test_damaged_specifications(way, tmp_path):
    rng, sound = np.random.default_rng([SEED, len(way)]), sound_specifications()

    def damaged(case):
        source = sound[rng.integers(len(sound))]
        text = source.read_text("utf-8")
        if way == "tables":
            content = tomli_w.dumps(damaged_tables(tomllib.loads(text), rng)).encode()
        elif way == "text":
            content = damaged_text(text, rng).encode()
        else:
            content = damaged_bytes(source.read_bytes(), rng)
        return f"{source.stem}_{case}.toml", content

    assert_no_faults(tmp_path, map(damaged, range(CASES)))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("suffix", "share"), [(".csv", 1), (".nc", 1), (".board", 1), (".stl", 20), (".step", 20)]
)
def test_damaged_files(suffix, share, tmp_path):
    """`share`: one case in so many, where each takes a process of its own."""
    rng = np.random.default_rng([SEED, ord(suffix[2])])
    contents = [path.read_bytes() for path in sound_files(tmp_path, suffix)]
    as_text = suffix not in (".nc", ".stl")

    def damaged(case):
        content = contents[rng.integers(len(contents))]
        if as_text and rng.random() < 0.5:
            content = damaged_text(content.decode(), rng).encode()
        else:
            content = damaged_bytes(content, rng)
        if suffix == ".board" and rng.random() < 0.7:
            content = with_checksums(content)
        return f"damaged_{case}{suffix}", content

    assert_no_faults(tmp_path, map(damaged, range(CASES // share)))


@pytest.mark.slow
def test_a_damaged_store_gives_the_same_results(tmp_path):
    rng = np.random.default_rng(SEED)
    content = {"table.json": json.dumps({"a": [1.5] * 200}).encode(), "array.bin": rng.bytes(9000)}

    def make(folder):
        for name, data in content.items():
            (folder / name).write_bytes(data)

    for case in range(CASES):
        result = stored(tmp_path, "stage", {"case": case % 7}, make)
        files = sorted(result.folder.iterdir())
        target = files[rng.integers(len(files))]
        target.write_bytes(damaged_bytes(target.read_bytes(), rng))
        again = stored(tmp_path, "stage", {"case": case % 7}, make)
        assert {name: (again.folder / name).read_bytes() for name in content} == content, case


@pytest.mark.parametrize("path", sorted(CORPUS.iterdir()), ids=lambda path: path.name)
def test_files_that_once_were_a_fault(path):
    assert fault_of(path) is None
