"""Damaged files give one error or a sound reading; never a traceback, a hang or another result.

`INSTOBJ_FUZZ_CASES` and `INSTOBJ_FUZZ_SEED` set how many files a target gets, and which.
"""

import dataclasses
import gc
import hashlib
import itertools
import os
import signal
import sys
import tomllib
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
import tomli_w
import trimesh

import instobj
from design import netcdf
from design.body import foreign
from design.errors import InstobjError
from estimator.frames.dataset import FrameSet, load_frames, save_frames
from estimator.recordings.boards.lines import (
    Header,
    LineDecoder,
    Load,
    checksum,
    encode_frame,
    encode_header,
    encode_load,
)
from estimator.recordings.formats.files import read_table
from estimator.recordings.formats.netcdf import write_generic_netcdf
from estimator.recordings.table import LARGEST_FORCE_N
from instobj.commands.readings import is_data_set
from tests.support.foreign_hdf5 import sealed
from tests.support.forked_reader import forking, said_in_fork
from tests.support.mutations import damaged_bytes, damaged_tables, damaged_text
from tests.support.recordings.generic_csv import write_generic_csv
from tests.support.recordings.made_recordings import gripper_arrays, write_gripper, write_training

CASES = int(os.environ.get("INSTOBJ_FUZZ_CASES", "200"))
SEED = int(os.environ.get("INSTOBJ_FUZZ_SEED", "1"))
SECONDS = 30.0
"""Of processor time that a file may take, and a tenth of the time by the clock: the machine may be
busy with other things."""
ROOT = Path(__file__).parents[2]
CORPUS = Path(__file__).parent / "corpus"
SURFACES = (".stl", ".obj", ".ply", ".off", ".step")
BINARY = (".nc", ".stl", ".ply")
LIBRARIES_OF_C = (".nc",)
"""Formats read by them in this process: where they loop, no limit set in Python ends it."""


@pytest.fixture(autouse=True)
def short_first_reading(monkeypatch):
    monkeypatch.setattr(netcdf, "FIRST_READING_S", 2.5)


class TookTooLong(Exception):
    """A file that was not read in time."""


@contextmanager
def limited(seconds):
    def stop(*_):
        raise TookTooLong(f"more than {seconds} s")

    timers = {signal.SIGPROF: signal.ITIMER_PROF, signal.SIGALRM: signal.ITIMER_REAL}
    previous = {which: signal.signal(which, stop) for which in timers}
    signal.setitimer(signal.ITIMER_PROF, seconds)
    signal.setitimer(signal.ITIMER_REAL, 10 * seconds)
    try:
        yield
    finally:
        for which, timer in timers.items():
            signal.setitimer(timer, 0)
            signal.signal(which, previous[which])


@contextmanager
def left_behind():
    """What is printed as a traceback after an error was handled: by objects that are deleted."""
    found, previous = [], sys.unraisablehook
    sys.unraisablehook = lambda one: found.append(f"{one.exc_type.__name__}: {one.exc_value}")
    try:
        yield found
    finally:
        sys.unraisablehook = previous


def read_specification(path):
    instobj.check(instobj.load_spec(path))


def read_recording(path):
    """As the commands do that take recordings and data sets."""
    frames = load_frames(path) if is_data_set(path) else instobj.read_recording(path).frames
    assert np.all(np.diff(frames.time_s) > 0)
    assert (np.abs(np.nan_to_num(frames.force_n, posinf=1e9, neginf=1e9)) <= LARGEST_FORCE_N).all()
    return frames


def read_surface(path):
    found = foreign.read_foreign_surface(path, "nothing there", seconds=SECONDS - 5)
    assert found.triangles.max() < len(found.vertices_mm)
    return found


def read_board(path):
    decoder = LineDecoder()
    for message in decoder.feed(path.read_bytes() + b"\n"):
        assert not isinstance(message, Header) or message.channels


READERS = {
    ".toml": read_specification,
    ".csv": read_recording,
    ".nc": read_recording,
    **dict.fromkeys(SURFACES, read_surface),
    ".board": read_board,
}


def fault_of(path, sound=None):
    """What reading a file did that no reading may do; None if it was read, or refused in words.

    `sound`: digests of arrays; a file that is read must hold those of one of them.
    """
    if path.suffix in LIBRARIES_OF_C:
        return said_in_fork(lambda: _said_of(path, sound), 2 * SECONDS)
    return _said_of(path, sound)


def _said_of(path, sound):
    with left_behind() as unraised:
        said = _fault_of(path, sound)
        gc.collect(1)
    return said or next(iter(unraised), None)


def _fault_of(path, sound):
    try:
        with limited(SECONDS):
            content = READERS[path.suffix](path)
    except InstobjError as error:
        return None if str(error).strip() else "an error without a word"
    except Exception as error:
        return f"{type(error).__name__}: {str(error)[:200]}"
    return None if sound is None or digest(content) in sound else "another content, without a word"


def digest(frames: FrameSet):
    """Of all arrays; signals of data sets are kept in single precision."""
    arrays = {field.name: getattr(frames, field.name) for field in dataclasses.fields(FrameSet)}
    found = hashlib.sha256()
    for name, values in arrays.items():
        if isinstance(values, np.ndarray):
            found.update(f"{name}{values.shape}".encode() + values.tobytes())
    return found.hexdigest()


def sound_specifications():
    return sorted((ROOT / "examples").glob("*.toml"))


def sound_files(folder, suffix):
    """Sound files of a format, small ones."""
    if suffix == ".board":
        path = folder / "sound.board"
        path.write_bytes(sound_lines())
        return [path]
    if suffix in SURFACES:
        return [_solid(folder / f"sound{suffix}")]
    gripper = write_gripper(folder / "gripper.csv", gripper_arrays(presses=1))
    if suffix == ".csv":
        training = write_training(folder / "training.csv", {0: (0,), 1: (54,), 2: (23,)}, presses=2)
        write_generic_csv(read_table(gripper), folder / "generic.csv")
        return [gripper, training, folder / "generic.csv"]
    write_generic_netcdf(read_table(gripper), folder / "recording.nc")
    save_frames(instobj.read_recording(gripper).frames, folder / "frames.nc")
    return [folder / "recording.nc", folder / "frames.nc"]


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
        trimesh.creation.icosphere(1, 15.0).export(path)
    return path


def assert_no_faults(folder, damaged, sound=None):
    """Of files given as (name, content); those that are faults stay in the folder."""
    faults = []
    for name, content in damaged:
        path = folder / name
        path.write_bytes(content)
        said = fault_of(path, sound)
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


def damaged_files(sound, rng):
    """Endlessly many, each made of one of the sound files."""
    contents, suffix = [path.read_bytes() for path in sound], sound[0].suffix
    for case in itertools.count():
        content = contents[rng.integers(len(contents))]
        if suffix not in BINARY and rng.random() < 0.5:
            content = damaged_text(content.decode(), rng).encode()
        else:
            content = damaged_bytes(content, rng)
        if suffix == ".board" and rng.random() < 0.7:
            content = with_checksums(content)
        if suffix == ".nc" and rng.random() < 0.3:
            content = sealed(content)
        yield f"damaged_{case}{suffix}", content


@pytest.mark.slow
@pytest.mark.parametrize("suffix", [".csv", ".nc", ".board"])
def test_damaged_signals(suffix, tmp_path):
    sound = sound_files(tmp_path, suffix)
    digests = {digest(read_recording(path)) for path in sound} if suffix == ".nc" else None
    damaged = damaged_files(sound, np.random.default_rng([SEED, ord(suffix[2])]))
    assert_no_faults(tmp_path, itertools.islice(damaged, CASES), digests)


@pytest.mark.slow
@pytest.mark.parametrize("suffix", SURFACES)
def test_damaged_surfaces(suffix, tmp_path, monkeypatch):
    """Read in forks of one process; that these read the same shows the sound file."""
    (sound,) = sound_files(tmp_path, suffix)
    alone = read_surface(sound)
    damaged = damaged_files([sound], np.random.default_rng([SEED, *suffix.encode()]))
    with forking(sound) as run_child:
        monkeypatch.setattr(foreign, "run_child", run_child)
        for one, other in zip(alone, read_surface(sound), strict=True):
            np.testing.assert_array_equal(one, other)
        assert_no_faults(tmp_path, itertools.islice(damaged, CASES))


@pytest.mark.parametrize("path", sorted(CORPUS.iterdir()), ids=lambda path: path.name)
def test_files_that_once_were_a_fault(path):
    assert fault_of(path) is None
