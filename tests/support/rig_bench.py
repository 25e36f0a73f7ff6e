"""A press rig without hardware: Grbl machine, board and load cell on pseudo-terminals, one object below.

Time runs as fast as the host answers: it asks the machine's state after every frame, and the bench
waits until it was asked for. So the host's own slowness costs no simulated time.
"""

import os
import select
import threading
import time
import tty
from contextlib import contextmanager, suppress

import numpy as np

from estimator.recordings.boards.lines import Load, encode_frame, encode_header, encode_load
from tests.support.grbl_simulator import GrblSimulator

FRAME_S, STEP_S = 0.1, 0.01
_PATIENCE_S = 5.0
MIDDLE_MM, TOP_MM = (-150.0, -100.0), -8.0


def hertz(depth_mm, xy_mm):
    """Force (N) of a 5 mm tip: 2.6 N at 1 mm in the middle, less outwards."""
    return 2.6 * (1 - 0.001 * np.sum(np.square(xy_mm))) * np.maximum(depth_mm, 0.0) ** 1.5


def simple_counts(force_n, xy_mm):
    """Counts of three axes of one sensor that differ by place."""
    x, y = xy_mm
    gains = np.array([30 + x, 20 - y, 60 + 0.1 * x * y])
    return gains * force_n / (1 + 0.01 * force_n)


class Line:
    """One end of a serial line; the other is `name`."""

    def __init__(self):
        self.master, self.slave = os.openpty()
        tty.setraw(self.slave)
        os.set_blocking(self.master, False)
        self.name = os.ttyname(self.slave)

    def read(self):
        with suppress(BlockingIOError, OSError):
            if select.select([self.master], [], [], 0)[0]:
                return os.read(self.master, 4096)
        return b""

    def write(self, data):
        with suppress(BlockingIOError, OSError):
            os.write(self.master, data)

    def close(self):
        os.close(self.master)
        os.close(self.slave)


class Bench:
    def __init__(self, law=hertz, counts=simple_counts, channels=None, seed=0, **settings):
        self.machine = GrblSimulator(**settings)
        self.law, self.counts = law, counts
        self.channels = channels or ("F3-X1", "F3-Y1", "F3-Z1")
        self.lines = {name: Line() for name in ("machine", "board", "load")}
        self.rng = np.random.default_rng(seed)
        self.numbers_on_load_line = self.load_in_bursts = False
        self.readings = []  # of the last frame's time: clock (ms) and force (N)
        self.slope = (0.0, 0.0)
        self.board_silent = self.load_silent = self.machine_silent = False
        self.frames = self.unanswered = 0
        self.forces, self.depths, self.places = [], [], []
        self.plan = lambda bench: None  # called at every frame: plants faults as the run goes
        self.over = threading.Event()

    @property
    def port(self):
        return self.lines["machine"].name

    @property
    def board_port(self):
        return self.lines["board"].name

    @property
    def load_port(self):
        return self.lines["load"].name

    def contact(self):
        """Place under the tip (mm), its depth below the surface (mm), and the force (N)."""
        x, y, z = self.machine.position
        xy = np.array([x, y]) - MIDDLE_MM
        depth = TOP_MM + float(np.dot(self.slope, xy)) - z
        return xy, depth, float(self.law(depth, xy))

    def run(self):
        header = encode_header(self.channels)
        steps = round(FRAME_S / STEP_S)
        while not self.over.is_set():
            for _ in range(steps):
                self._step()
            self._frame(header)
            if self.board_silent or self.machine_silent:
                time.sleep(0.002)
            else:
                self._answered()

    def _step(self):
        line = self.lines["machine"]
        if not self.machine_silent:
            self.machine.take(line.read())
        self.machine.advance(STEP_S)
        data = self.machine.give()
        if not self.machine_silent:
            line.write(data)
        if self.load_in_bursts:
            ms = round(1000 * (FRAME_S * self.frames + STEP_S * (len(self.readings) - 9)))
            noise = 0.01 * self.rng.standard_normal()
            self.readings.append((max(ms, 0), self.contact()[2] + noise))

    def _frame(self, header):
        self.plan(self)
        xy, depth, force = self.contact()
        self.forces.append(force)
        self.depths.append(depth)
        self.places.append(xy)
        ms = round(1000 * FRAME_S * self.frames)
        shown = force + 0.4 + 0.01 * self.rng.standard_normal()
        asked = b"?" in self.lines["board"].read()
        self.lines["load"].read()
        load = encode_load(Load(ms, 1, shown, None, ()))
        if self.load_in_bursts:
            lines = [encode_load(Load(at, 1, force + 0.4, None, ())) for at, force in self.readings]
            load, self.readings = b"".join(lines), []
        if self.numbers_on_load_line:
            load = f"{shown / 9.80665e-3:.2f}\n".encode()
        own = self.numbers_on_load_line
        text = b"" if self.load_silent or own else load
        if own and not self.load_silent:
            self.lines["load"].write(load)
        counts = np.round(
            100 + self.counts(force, xy) + 3 * self.rng.standard_normal(len(self.channels))
        )
        if not self.board_silent:
            start = header if asked or self.frames % 50 == 0 else b""
            self.lines["board"].write(start + text + encode_frame(self.frames, ms, counts.tolist()))
        self.frames += 1

    def _answered(self):
        """Wait for what the host says to the machine: some seconds at most, or nothing where it has been
        silent for three frames. It reads the board at every word, unless it is stopping."""
        line, patience_s = self.lines["machine"], _PATIENCE_S if self.unanswered < 3 else 0.002
        until = time.monotonic() + patience_s
        self.unanswered += 1
        while time.monotonic() < until and not self.over.is_set():
            if data := line.read():
                self.machine.take(data)
                line.write(self.machine.give())
                self.unanswered = 0
                return
            time.sleep(0.0002)


@contextmanager
def bench(**choice):
    """A bench that runs until the context ends."""
    made = Bench(**choice)
    thread = threading.Thread(target=made.run)
    thread.start()
    try:
        yield made
    finally:
        made.over.set()
        thread.join()
        for line in made.lines.values():
            line.close()
