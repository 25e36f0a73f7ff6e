"""A press rig in memory: a machine, a board, a load cell and an object, in simulated time.

Nothing waits: the rig's own clock is this bench, and time passes when it naps. The object knows nothing of
what the rig expects of it: a layered contact of its own, and chips that read dipoles which sink under
the tip. Faults are functions that change what a line says, or act as the run goes.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from estimator.recordings.boards.lines import Load, encode_frame, encode_header, encode_load
from instobj.bench.rig.checked_plan import check_plan
from instobj.bench.rig.clock import Clock
from instobj.bench.rig.dialects import DIALECTS
from instobj.bench.rig.journal import new_journal
from instobj.bench.rig.load_lines import NumberLines
from instobj.bench.rig.machine import MachineLink
from instobj.bench.rig.mounting import Mounting
from instobj.bench.rig.plan import PressSettings, press_plan
from instobj.bench.rig.run import carry_out, make_ready, new_station
from tests.support.grbl_simulator import GrblSimulator
from tests.support.marlin_simulator import MarlinSimulator

FRAME_S, STEP_S = 0.1, 0.01
MIDDLE_MM, TOP_MM = np.array([-150.0, -100.0]), -18.0
CHANNELS = tuple(f"F3-{axis}{sensor}" for sensor in (1, 2, 3) for axis in "XYZ")
COUNTS_PER_MT = 820.0


class Silicone:
    """A layer of 8 mm under a 5 mm sphere: Hertz, stiffer by (1 + 0.6 depth/layer)², and softer outwards.
    Four magnets 2.5 mm under the surface sink with the tip; three chips lie 9 mm under it."""

    MAGNETS = np.array([[x, y, -2.5] for x in (-6.0, 6.0) for y in (-6.0, 6.0)])
    CHIPS = np.array([[0.0, 8.6, -10.0], [-7.4, -4.3, -10.0], [7.4, -4.3, -10.0]])
    MOMENT_MT_MM3 = 600.0
    SINKING_POWER = 1.0

    def __init__(self, stiffer=1.0):
        self.stiffer = stiffer

    def force_n(self, depth_mm, xy_mm):
        depth = max(depth_mm, 0.0)
        aside = 1 - 0.0008 * float(xy_mm[0] ** 2 + xy_mm[1] ** 2)
        return self.stiffer * aside * 1.7 * depth**1.5 * (1 + 0.6 * depth / 8) ** 2

    def field_mt(self, depth_mm, xy_mm):
        """(chip, 3): of dipoles along z that sink less the farther they are from the tip."""
        aside = np.linalg.norm(self.MAGNETS[:, :2] - xy_mm, axis=1)
        magnets = self.MAGNETS.copy()
        sinking = 0.7 * max(depth_mm, 0.0) ** self.SINKING_POWER
        magnets[:, 2] -= sinking * np.exp(-((aside / 7.0) ** 2))
        off = self.CHIPS[:, None] - magnets
        r = np.linalg.norm(off, axis=-1, keepdims=True)
        dipoles = 3 * off * off[..., 2:] / r**5 - np.array([0, 0, 1]) / r**3
        return self.MOMENT_MT_MM3 * dipoles.sum(axis=1)


class FollowsForce(Silicone):
    """Magnets sink as the force grows, as in the finite elements of the chain."""

    SINKING_POWER = 1.5


class OnLine:
    """A machine as a line that never waits; `heard` and `said` change what passes. Where its tip is stays
    when it loses its supply: only what it reports starts anew."""

    def __init__(self, **settings):
        self.shift = np.zeros(3)
        super().__init__(**settings)
        self.heard = self.said = lambda data: data

    @property
    def real_mm(self):
        return self.position + self.shift

    def power_on(self):
        real = getattr(self, "position", np.zeros(3)) + self.shift
        super().power_on()
        self.shift = real - self.position

    def _home(self, *words):
        done = super()._home(*words)
        if done and self.state == "Idle":
            self.shift = np.zeros(3)
        return done

    def read(self, _size):
        return self.said(self.give())

    def write(self, data):
        self.take(self.heard(data))
        return len(data)


class Grbl(OnLine, GrblSimulator):
    pass


class Marlin(OnLine, MarlinSimulator):
    pass


MACHINES = {"grbl": Grbl, "marlin": Marlin}


class Bench(Clock):
    """Everything; `cell` changes a reading (N, None: says nothing), `board` the bytes of a frame, `act` is
    called at every step of time."""

    def __init__(
        self, silicone=None, seed=0, noise_n=0.01, numbers=False, dialect="grbl", **settings
    ):
        self.silicone, self.rng = silicone or Silicone(), np.random.default_rng(seed)
        self.dialect, self.machine = dialect, MACHINES[dialect](**settings)
        self.noise_n, self.numbers = noise_n, numbers
        self.now, self.frames = 1000.0, 0
        self.cell = lambda force_n: force_n
        self.counts = lambda counts: counts
        self.board = lambda data: data
        self.act = lambda: None
        self.header_due, self.stamps_late_ms = True, 0
        self.waiting, self.cell_waiting = bytearray(), bytearray()
        self.depths, self.forces = [], []

    def now_s(self):
        return self.now

    def epoch_s(self):
        return 1.7e9 + self.now

    def nap(self, seconds):
        """A step of time at least: machine, object, board."""
        self.now += max(seconds, STEP_S)
        self.machine.advance(STEP_S)
        depth, xy = self.depth_mm, self.xy_mm
        self.depths.append(depth)
        self.forces.append(self.silicone.force_n(depth, xy))
        self.act()
        if self.now - 1000.0 >= (self.frames + 1) * FRAME_S:
            self._frame(depth, xy)

    @property
    def xy_mm(self):
        return self.machine.real_mm[:2] - MIDDLE_MM

    @property
    def depth_mm(self):
        return TOP_MM - float(self.machine.real_mm[2])

    @property
    def pressing(self):
        """Deep in a press, after touching off."""
        return self.depth_mm > 1.2

    def _frame(self, depth, xy):
        ms = round(1000 * (self.now - 1000.0))
        reading = self.cell(
            self.silicone.force_n(depth, xy) + 0.4 + self.noise_n * self.rng.standard_normal()
        )
        load = b""
        if reading is not None and self.numbers:
            self.cell_waiting += f"{reading:.5f}\n".encode()
        elif reading is not None:
            load = encode_load(Load(max(ms - self.stamps_late_ms, 0), 1, reading, None, ()))
        noise = self.rng.standard_normal((3, 3)) * np.array([22.0, 22.0, 11.0])
        counts = self.counts(np.round(COUNTS_PER_MT * self.silicone.field_mt(depth, xy) + noise))
        header = encode_header(CHANNELS) if self.header_due or self.frames % 50 == 0 else b""
        self.header_due = False
        frame = b"" if counts is None else encode_frame(self.frames, ms, counts.ravel().tolist())
        self.waiting += self.board(header + load + frame)
        self.frames += 1

    def chunks(self) -> Iterator[bytes]:
        """Of the board; at most 4 kB at a time."""
        while True:
            data, self.waiting = bytes(self.waiting[:4096]), self.waiting[4096:]
            yield data

    def loads(self) -> Iterator[list[float]]:
        """Of a load cell on its own port."""
        lines = NumberLines(1.0)
        while True:
            data, self.cell_waiting = bytes(self.cell_waiting), bytearray()
            yield lines.feed(data)


@contextmanager
def at_bench(
    bench,
    spec,
    settings,
    folder: Path,
    middle_z_mm=TOP_MM,
    presses=1,
    by_travel=False,
    reference_every=0,
):
    """Station and a call that carries out a plan of presses; `by_travel` without a load cell."""
    plan = press_plan(spec, 3, PressSettings(**settings), 1, 1, reference_every, presses)
    mounting = Mounting((*MIDDLE_MM.tolist(), middle_z_mm), 0.0)
    recording = folder / "run.csv"
    journal = new_journal(recording, plan, mounting)
    link = MachineLink(bench.machine, "machine", clock=bench, dialect=DIALECTS[bench.dialect])
    loads = bench.loads() if bench.numbers else None
    station = new_station(
        link, bench.chunks(), loads, spec, plan.settings.limit_n, by_travel=by_travel
    )

    def go():
        make_ready(station)
        check_plan(spec, journal, station.machine, by_travel)
        carry_out(station, spec, journal, recording, lambda _: None)

    yield station, go, journal
