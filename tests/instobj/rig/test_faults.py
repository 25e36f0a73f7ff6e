"""Faults of cell, board, machine and order of lines at a rig in memory: the tip never goes where it must not.

The object of the bench follows a law of its own (tests/support/rig_in_memory.py), also stiffer and softer
than the specification; what the rig expects of it is not asked.
"""

import numpy as np
import pytest

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.recordings.boards.lines import encode_header
from tests.support.rig_in_memory import CHANNELS, FRAME_S, TOP_MM, Bench, Silicone, at_bench

SPEC = ObjectSpec(name="cube", contact_grid={"count": [2, 2], "pitch_mm": 12.0})
DEPTHS_MM = (1.0, 2.0)
SETTINGS = {"depths_mm": DEPTHS_MM, "dwell_s": 0.4, "rest_s": 0.7, "full_n": 10.0}
SETTINGS |= {"clearance_mm": 3.0}
LIMIT_N = 10.0 * 4 / 3
ALLOWED_MM = 0.5
OTHER = encode_header([name.replace("F3", "F2") for name in CHANNELS])


class When:
    """Acts once, when something is met for the first time, and from then on says so."""

    def __init__(self, bench, met, act=lambda: None):
        self.bench, self.met, self.act, self.begun = bench, met, act, False
        before = bench.act

        def step():
            before()
            if not self.begun and met():
                self.begun = True
                act()

        bench.act = step


def in_press(bench, act=lambda: None):
    return When(bench, lambda: bench.pressing, act)


def seeking(bench, act=lambda: None):
    """Half a millimetre above the object on its first way down."""
    return When(bench, lambda: -0.6 < bench.depth_mm < -0.1, act)


def stopping(bench, act=lambda: None):
    """While the feed is held near the object."""
    return When(bench, lambda: bench.machine.state == "Hold" and bench.depth_mm > -1, act)


def from_then(when, change):
    """A change of readings that begins then."""

    def changed(value):
        return change(value) if when.begun else value

    return changed


def stuck(value_n=None, begin=None):
    """The cell says the same for ever, of the first moment or from the beginning of a phase."""

    def plant(bench):
        when, last = begin(bench) if begin else None, []

        def cell(force_n):
            if when is not None and not when.begun:
                return force_n
            last.append(force_n if value_n is None else value_n)
            return last[0]

        bench.cell = cell

    return plant


def scaled(factor, begin=None):
    def plant(bench):
        when = begin(bench) if begin else None
        bench.cell = lambda force_n: factor * force_n if when is None or when.begun else force_n

    return plant


def late(seconds):
    """Readings of some time ago, said as if they were new."""

    def plant(bench):
        past = []

        def cell(force_n):
            past.append(force_n)
            return past[max(len(past) - 1 - round(seconds / FRAME_S), 0)]

        bench.cell = cell

    return plant


def says(reading, begin):
    def plant(bench):
        when = begin(bench)
        bench.cell = lambda force_n: reading if when.begun else force_n

    return plant


def dead_noise(bench):
    """A cell whose strain gauge is torn off: noise about a level, no force."""
    bench.cell = lambda _: 0.4 + 0.01 * bench.rng.standard_normal()


def dead_from(begin):
    def plant(bench):
        when = begin(bench)
        bench.cell = from_then(when, lambda _: 0.4 + 0.01 * bench.rng.standard_normal())

    return plant


def drifting(newtons_per_s):
    """A cell that drifts away, as if something touched."""

    def plant(bench):
        bench.cell = lambda force_n: force_n + newtons_per_s * (bench.now - 1000.0)

    return plant


def spike(bench):
    """One reading at the end of an HX711's scale, as cheap boards say now and then."""
    when, said = seeking(bench), []

    def cell(force_n):
        if when.begun and not said:
            said.append(True)
            return 191.0
        return force_n

    bench.cell = cell


def frames_stuck(begin):
    def plant(bench):
        when, last = begin(bench), []

        def counts(values):
            if when.begun:
                last.append(values)
                return last[0]
            return values

        bench.counts = counts

    return plant


def chips_dead(begin):
    """Chips that say noise about their level, whatever happens."""

    def plant(bench):
        when = begin(bench)
        level = np.round(820 * bench.silicone.field_mt(0.0, np.zeros(2)))

        def counts(values):
            noise = np.round(22 * bench.rng.standard_normal((3, 3)))
            return level + noise if when.begun else values

        bench.counts = counts

    return plant


def board_says(data, begin, instead=False):
    """Bytes after every frame, or instead of it."""

    def plant(bench):
        when = begin(bench)
        bench.board = lambda frame: (b"" if instead else frame) + data if when.begun else frame

    return plant


def whole_board_frozen(bench):
    """The board says its last lines over and over."""
    when, last = in_press(bench), []

    def board(data):
        last.append(data)
        return last[0] if when.begun else last.pop()

    bench.board = board


def machine_does(act, begin):
    def plant(bench):
        begin(bench, lambda: act(bench.machine))

    return plant


def machine_hears(change, begin):
    def plant(bench):
        when = begin(bench)
        bench.machine.heard = from_then(when, change)

    return plant


def machine_says(change, begin):
    def plant(bench):
        when = begin(bench)
        bench.machine.said = from_then(when, change)

    return plant


def nothing(_):
    return b""


def raising(error, times, begin):
    """A line that fails some times as it is read."""

    def plant(bench):
        when, count = begin(bench), []

        def said(data):
            if when.begun and len(count) < times:
                count.append(1)
                raise error
            return data

        bench.machine.said = said

    return plant


def four_axes(bench):
    def said(data):
        lines = data.split(b"|FS")
        return b",0.000|FS".join(lines) if len(lines) > 1 else data

    bench.machine.said = said


def grblhal(bench, also=lambda _: None):
    """Its greeting, four axes, and its bits in $22."""
    four_axes(bench)
    axes, bench.machine.settings[22] = bench.machine.said, 9
    bench.machine.said = lambda data: axes(data).replace(b"Grbl 1.1h", b"GrblHAL 1.1f")
    also(bench)


def reset_to_zero(machine):
    """Lost its supply for a moment, and calls where it is zero, unlocked, as some controllers do."""
    from_mm = machine.position.copy()
    machine.power_on()
    machine.state = "Idle"
    machine.shift_mm = from_mm


def lost_at_random(bench):
    """One in eleven bytes that the machine gets."""

    def act():
        coming = bench.machine.bytes_in + 10 + np.arange(4000)
        gone = np.random.default_rng(4).random(4000) < 1 / 11
        bench.machine.drop_in = set(coming[gone].tolist())

    in_press(bench, act)


def no_ok(data):
    return data.replace(b"ok\r\n", b"")


def position_frozen(bench):
    when, last = in_press(bench), []

    def said(data):
        if when.begun and b"MPos" in data:
            last.append(data)
            return last[0]
        return data

    bench.machine.said = said


def other_channels_at_the_stop(bench):
    """Brief A2: another header comes while the tip is raised."""
    machine_does(lambda machine: machine._answer("error:2"), in_press)(bench)
    board_says(OTHER, stopping)(bench)


FAULTS = {
    # what the load cell says
    "cell stuck from the start": stuck(0.4),
    "cell stuck on its way down": stuck(begin=seeking),
    "cell stuck in a press": stuck(begin=in_press),
    "cell dead, with noise": dead_noise,
    "cell dead on its way down": dead_from(seeking),
    "cell dead in a press": dead_from(in_press),
    **{
        f"readings times {factor:g}": scaled(factor)
        for factor in 10.0 ** np.arange(-3, 4)
        if factor != 1
    },
    "kgf read as N": scaled(1 / 9.80665),
    "sign": scaled(-1.0),
    "sign, from a press on": scaled(-1.0, in_press),
    "a tenth, from a press on": scaled(0.1, in_press),
    "late by 0.5 s": late(0.5),
    "late by 3 s": late(3.0),
    "NaN on its way down": says(float("nan"), seeking),
    "NaN in a press": says(float("nan"), in_press),
    "silent on its way down": says(None, seeking),
    "silent in a press": says(None, in_press),
    "end of scale once": spike,
    "end of scale in a press": says(191.0, in_press),
    "drift of the cell": drifting(0.02),
    "drift of the cell, down": drifting(-0.05),
    # what the board says
    "frames stuck in a press": frames_stuck(in_press),
    "frames stuck on its way down": frames_stuck(seeking),
    "board says its last lines for ever": whole_board_frozen,
    "chips dead in a press": chips_dead(in_press),
    "chips dead from the first way down": chips_dead(seeking),
    "header storm": board_says(40 * encode_header(CHANNELS), in_press),
    "header storm without frames": board_says(40 * encode_header(CHANNELS), in_press, instead=True),
    "headers of other channels": board_says(OTHER, in_press),
    "another header while stopping": other_channels_at_the_stop,
    "garbage without end": board_says(bytes(range(256)) * 8, in_press, instead=True),
    "half a line without end": board_says(b"$F,1,2,3", seeking, instead=True),
    # what the machine does and says
    "reset in a press": machine_does(lambda machine: machine.power_on(), in_press),
    "reset while stopping": machine_does(lambda machine: machine.power_on(), stopping),
    "reset to zero, unlocked": machine_does(reset_to_zero, in_press),
    "alarm in a press": machine_does(lambda machine: machine._alarm(1), in_press),
    "soft limit in a press": machine_does(lambda machine: machine._alarm(2), in_press),
    "a line refused": machine_does(lambda machine: machine.refuse.append(2), in_press),
    "ok lost in a press": machine_says(no_ok, in_press),
    "ok lost on its way down": machine_says(no_ok, seeking),
    "ok late": lambda bench: setattr(bench.machine, "late_ok_s", 0.6),
    "deaf machine": machine_hears(nothing, in_press),
    "silent machine": machine_says(nothing, seeking),
    "characters lost": lost_at_random,
    "position frozen": position_frozen,
    "line fails while stopping": raising(OSError("gone"), 4, stopping),
    "Ctrl-C in a press": raising(KeyboardInterrupt(), 1, in_press),
    "Ctrl-C again and again while stopping": raising(KeyboardInterrupt(), 3, stopping),
    "grblHAL reset in a press": lambda bench: grblhal(
        bench, machine_does(lambda machine: machine.power_on(), in_press)
    ),
}


def ended(bench, folder, settings=SETTINGS, presses=2, **choice):
    """The error that ended a run, None of a whole one, and the presses that were done."""
    with at_bench(bench, SPEC, settings, folder, presses=presses, **choice) as (_, go, journal):
        try:
            go()
        except InputError as error:
            return str(error), journal.finished
    return None, journal.finished


def require_unharmed(bench):
    """Travel within 0.5 mm of the plan's deepest stop, force within one reading's worth of the limit."""
    assert max(bench.depths) <= DEPTHS_MM[-1] + ALLOWED_MM
    steps = round(FRAME_S / 0.01)
    forces = np.array(bench.forces)
    worth_n = np.max(forces[steps:] - forces[:-steps])
    assert forces.max() <= LIMIT_N + worth_n


def require_told(bench, error):
    """`up` is said where the tip is up, and only there."""
    up = bench.machine.position[2] - TOP_MM >= 2.0
    assert ("tip is up" in error) <= up, error
    assert "Traceback" not in error


@pytest.mark.parametrize("stiffer", [1.0, 1.6])
@pytest.mark.parametrize("name", FAULTS)
def test_no_fault_drives_the_tip_into_the_object(tmp_path, name, stiffer):
    bench = Bench(Silicone(stiffer))
    FAULTS[name](bench)
    error, done = ended(bench, tmp_path)
    require_unharmed(bench)
    if error is not None:
        require_told(bench, error)
    assert error is not None or len(done) == 2


@pytest.mark.parametrize("stiffer", [0.5, 1.5])
@pytest.mark.parametrize("numbers", [False, True])
@pytest.mark.parametrize("kind", [lambda _: None, four_axes, grblhal])
def test_a_sound_rig_does_its_plan(tmp_path, stiffer, numbers, kind):
    bench = Bench(Silicone(stiffer), numbers=numbers)
    kind(bench)
    error, done = ended(bench, tmp_path)
    assert error is None
    assert len(done) == 2
    assert max(bench.depths) == pytest.approx(DEPTHS_MM[-1], abs=0.1)
    require_unharmed(bench)
    assert bench.machine.position[2] - TOP_MM >= 2.0
