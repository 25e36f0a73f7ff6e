"""From firmware to predictions with nothing but simulated hardware, one command per step."""

import csv
import json
import subprocess

import numpy as np
import pytest
from serial import Serial

from design.catalogue.bus_parts import MEGA2560
from design.spec_io import load_spec
from design.wiring.bus_plan import choose_plan
from estimator.recordings.boards.lines import Header, LineDecoder
from estimator.signals.interpolation import counts_at_force, press_traces
from estimator.signals.presses import load_signals, press_signals
from tests.support.avr.board import needs_simulator, running, world
from tests.support.cli import run
from tests.support.mechanics.synthetic_presses import force_n, synthetic_presses
from tests.support.rig_bench import MIDDLE_MM, bench

FACE = 3
SPEC = """name = "walk"
[contact_grid]
count = [4, 4]
pitch_mm = 5.0
[press]
depths_mm = [0.5, 1.0, 1.5, 2.0, 3.0, 4.0]
"""
ONE_FACE = """name = "walk"
[body]
sensed_faces = [3]
[load_cell]
kind = "hx711"
[mesh]
edge_mm = 8.0
surface_edge_mm = 3.0
rim_edge_ratio = 1
envelope_mm = 0.1
[contact_grid]
count = [4, 4]
pitch_mm = 6.0
[press]
depths_mm = [0.5, 1.0, 1.5, 2.0, 3.0]
"""
SINGLE = ("ensemble=1", "history_frames=0", "trees=0", "process=false", "epochs=80")
SETTINGS = [word for setting in SINGLE for word in ("--set", f"training.{setting}")]


def done(*arguments, cwd):
    found = run(*arguments, cwd=cwd)
    assert found.returncode == 0, found.stderr
    return json.loads(found.stdout)


def channels_of_firmware(folder, plan):
    """What the compiled program says of itself in the simulator."""
    subprocess.run(["make", "-s", "-C", folder], check=True)
    decoder = LineDecoder()
    elf = folder / "firmware.elf"
    with (
        running(elf, world(plan, end_ms=60000)) as (port, over),
        Serial(port, timeout=0.05) as link,
    ):
        link.write(b"?")
        while not over.is_set():
            for message in decoder.feed(link.read(4096)):
                if isinstance(message, Header):
                    return message.channels
    raise AssertionError("the firmware named no channels")


class TableObject:
    """Forces and counts of the object's table of presses, at any place and depth."""

    def __init__(self, spec, channels):
        self.signals = press_signals(spec, *synthetic_presses(spec))
        names = [f"F{f}-{a}{s}" for f in range(1, 6) for s in range(1, 4) for a in "XYZ"]
        self.order = [names.index(channel) for channel in channels]
        self.traces = {}

    def law(self, depth_mm, xy):
        return float(force_n(FACE, np.asarray(xy), max(depth_mm, 0.0)))

    def counts(self, force, xy):
        if force <= 0:
            return np.zeros(len(self.order))
        key = tuple(np.round(xy, 2))
        if key not in self.traces:
            x, y = (np.array([float(value)]) for value in key)
            self.traces[key] = press_traces(self.signals, np.array([FACE]), x, y)
        return counts_at_force(self.traces[key], np.array([[force]])).counts[0, 0][self.order]


@pytest.mark.slow
@needs_simulator
def test_an_object_is_taken_from_firmware_to_predictions(tmp_path):
    (tmp_path / "walk.toml").write_text(SPEC)
    spec = load_spec(tmp_path / "walk.toml")
    done("bench", "firmware", "walk.toml", "--board", "mega2560", "--json", cwd=tmp_path)
    plan, _ = choose_plan(spec, MEGA2560)
    channels = channels_of_firmware(tmp_path / "runs/walk/firmware_mega2560", plan)
    thing = TableObject(spec, channels)
    with bench(law=thing.law, counts=thing.counts, channels=channels) as made:
        arguments = ["--port", made.port, "--board-port", made.board_port, "--face", FACE]
        arguments += ["--middle", ",".join(f"{v:g}" for v in MIDDLE_MM), "--yes", "--json"]
        for part in ("depths_mm=1,2,2.5", "speed_mm_s=2", "repeats=2"):
            arguments += ["--plan", part]
        pressed = done("bench", "rig", "walk.toml", *arguments, cwd=tmp_path)
    assert pressed["presses"] == 32 + 5
    assert np.ptp(pressed["reference_n"]) < 0.3
    done("recordings", "walk.nc", "--spec", "walk.toml", "--json", cwd=tmp_path)
    done("train", "runs/walk/frames.nc", *SETTINGS, "--json", cwd=tmp_path)
    done("train", "--export", f"runs/walk/face_{FACE}.safetensors", "--json", cwd=tmp_path)
    done("predict", f"runs/walk/face_{FACE}.onnx", "walk.nc", "--json", cwd=tmp_path)
    require_right_predictions(tmp_path)


def require_right_predictions(folder):
    """Forces within a tenth of the largest, places within the pitch, in the median of the pressed frames."""
    (path,) = folder.glob("**/*prediction*.csv")
    with path.open() as file:
        told = list(csv.DictReader(file))
    with (folder / "walk.csv").open() as file:
        true = list(csv.DictReader(file))
    rows = [(one, true[int(one["frame"])]) for one in told]
    pressed = [(a, b) for a, b in rows if float(b["cell1_force_n"]) > 2]
    assert len(pressed) > 200
    off_n = [abs(float(a["force_n"]) - float(b["cell1_force_n"])) for a, b in pressed]
    assert np.median(off_n) < 0.1 * max(float(b["cell1_force_n"]) for _, b in pressed)
    off_mm = [
        np.hypot(
            float(a["x_mm"]) - float(b["cell1_x1_mm"]), float(a["y_mm"]) - float(b["cell1_y1_mm"])
        )
        for a, b in pressed
        if a["x_mm"]
    ]
    assert len(off_mm) > 0.8 * len(pressed)
    assert np.median(off_mm) < 5.0


class MeshedObject:
    """Forces and counts of the object's own simulated presses, 10 % stiffer."""

    def __init__(self, spec, signals):
        self.signals, self.traces = signals, {}
        self.depths_mm = np.r_[0.0, spec.press.depths_mm]

    def at(self, xy):
        key = tuple(np.clip(np.round(xy, 1), -11.0, 11.0))
        if key not in self.traces:
            x, y = (np.array([float(value)]) for value in key)
            self.traces[key] = press_traces(self.signals, np.array([FACE]), x, y)
        return self.traces[key]

    def law(self, depth_mm, xy):
        known_n = np.r_[0.0, np.ravel(self.at(xy).force_n[0])][: len(self.depths_mm)]
        return 1.1 * float(np.interp(max(depth_mm, 0.0), self.depths_mm, known_n))

    def counts(self, force, xy):
        if force <= 0:
            return np.zeros(9)
        return counts_at_force(self.at(xy), np.array([[force]])).counts[0, 0].ravel()


@pytest.mark.slow
def test_a_recording_of_the_rig_is_validated_and_trains_with_the_twin(tmp_path):
    """An object that senses one face, whose recording has room for the channels of five."""
    (tmp_path / "walk.toml").write_text(ONE_FACE)
    spec = load_spec(tmp_path / "walk.toml")
    done("run", "walk.toml", "--to", "presses", "--json", cwd=tmp_path)
    thing = MeshedObject(spec, load_signals(tmp_path / "runs/walk/lattice_signals.nc"))
    channels = [f"F{FACE}-{axis}{sensor}" for sensor in (1, 2, 3) for axis in "XYZ"]
    with bench(law=thing.law, counts=thing.counts, channels=channels) as made:
        arguments = ["--port", made.port, "--board-port", made.board_port, "--face", FACE]
        arguments += ["--middle", ",".join(f"{v:g}" for v in MIDDLE_MM), "--yes", "--json"]
        done(
            "bench",
            "rig",
            "walk.toml",
            *arguments,
            "--plan",
            "depths_mm=1,2",
            "--plan",
            "speed_mm_s=2",
            cwd=tmp_path,
        )
    told = done("recordings", "walk.nc", "--spec", "walk.toml", "--json", cwd=tmp_path)
    assert told["reports"][0]["faults"] == []
    found = done("validate", "walk.toml", "walk.nc", "--json", cwd=tmp_path)["validation"]
    face = found["agreement"][0]
    assert (face["what"], face["cases"]) == ("face 3", 16)
    assert face["cosine"]["value"] > 0.99
    assert face["size_ratio"] == pytest.approx(1.0, abs=0.05)
    twin = ["--twin", "walk.toml", *SETTINGS, "--json"]
    trained = done("train", "runs/walk/frames.nc", *twin, cwd=tmp_path)
    tables = trained["objects"][0]["summary"]
    ((row,),) = (rows for name, rows in tables.items() if name.startswith("calibrated twin"))
    assert row["places"] >= 8, "those of the presses that are not held out"
    assert row["helps"].startswith("yes: the object is as drawn")
    assert row["modulus over design"] == pytest.approx(1.0, abs=0.05)
