"""Faults of cell, board, machine and order of lines at a rig in memory: the tip never goes where it must not.

The object of the bench follows a law of its own (tests/support/rig_in_memory.py), also stiffer and softer
than the specification; what the rig expects of it is not asked.
"""

import re

import numpy as np
import pytest

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.recordings.boards.lines import encode_header
from instobj.bench.rig.dialects import DIALECTS
from tests.support.rig_in_memory import (
    CHANNELS,
    FRAME_S,
    TOP_MM,
    Bench,
    FollowsForce,
    Silicone,
    at_bench,
)

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


def nobody(_):
    """No load cell says anything."""


def steps_lost(up_mm, met=lambda bench: bench.depth_mm < -2.0):
    """A machine whose tip stays lower (higher: negative) than it reports, once it has pressed."""

    def plant(bench):
        pressed = in_press(bench)

        def lose():
            bench.machine.shift = bench.machine.shift - np.array([0.0, 0.0, up_mm])

        When(bench, lambda: pressed.begun and met(bench), lose)

    return plant


def chip_jumps(begin, counts=400.0):
    """One chip leaves its level for good."""

    def plant(bench):
        when = begin(bench)
        off = np.zeros((3, 3))
        off[1] = counts
        bench.counts = from_then(when, lambda values: values + off)

    return plant


def chip_stuck(bench):
    """One chip says its first reading for ever."""
    first = []

    def counts(values):
        first.append(values[1])
        return np.vstack([values[:1], first[:1], values[2:]])

    bench.counts = counts


def steel_in_the_tip(bench):
    """The chips see it from some millimetres away."""

    def counts(values):
        above_mm = max(-bench.depth_mm, 0.0)
        return values + np.round(900.0 / (1.0 + above_mm) ** 2)

    bench.counts = counts


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


def grblhal_reset(bench):
    grblhal(bench, machine_does(lambda machine: machine.power_on(), in_press))


def stuck_axis(bench):
    """Z does not move up any more: every lift is answered, and the tip stays."""
    lowest = [0.0]

    def act():
        if bench.depth_mm > 1.2:
            lowest[0] = min(lowest[0], bench.machine.position[2])
            bench.machine.position[2] = lowest[0]

    before = bench.act
    bench.act = lambda: (before(), act())


def reset_to_zero(machine):
    """Lost its supply for a moment, and calls where it is zero, unlocked, as some controllers do."""
    machine.power_on()
    machine.state = "Idle"


def lost_at_random(bench):
    """One in eleven bytes that the machine gets."""

    def act():
        coming = bench.machine.bytes_in + 10 + np.arange(4000)
        gone = np.random.default_rng(4).random(4000) < 1 / 11
        bench.machine.drop_in = set(coming[gone].tolist())

    in_press(bench, act)


def no_ok(data):
    return re.sub(rb"ok\r?\n", b"", data)


def position_frozen(bench):
    when, last = in_press(bench), []

    def said(data):
        if when.begun and (b"MPos" in data or b"Count" in data):
            last.append(data)
            return last[0]
        return data

    bench.machine.said = said


def starts_anew_at_the_stop(bench):
    """The reset that a stop asks for takes the machine's supply down: it greets, unlocked, at zero."""
    when = in_press(bench, lambda: bench.machine.refuse.append(2))

    reset = DIALECTS[bench.dialect].reset

    def heard(data):
        if reset in data:
            reset_to_zero(bench.machine)
        return data.replace(reset, b"")

    bench.machine.heard = from_then(when, heard)


def lifting_line_lost(bench):
    """Whatever lifts the tip after a fault in a press never arrives."""
    when = in_press(bench, lambda: bench.machine.refuse.append(2))
    bench.machine.heard = from_then(when, lambda data: b"" if b"G0Z" in data else data)


def deeper_by_a_digit(bench):
    """The second stop of a press arrives as 6 mm deeper."""
    bench.machine.heard = lambda data: re.sub(rb"Z-(20|19\.9\d)(?=\n|F)", b"Z-26", data)


STILL, BOARD_STILL = "stands still", "board in a row are the same"
UNCHANGED, UNSEEN = "Its readings did not change", "no chip sees a contact"
SILENT, RESET = "load cell has said nothing", "was reset, or lost its supply.*could NOT be raised"
UNFELT = "the chips see a contact and the load cell says"
UP = "The tip is up"
FAULTS = {
    # what the load cell says
    "cell stuck from the start": (stuck(0.4), STILL),
    "cell stuck on its way down": (stuck(begin=seeking), f"{STILL}|did not change"),
    "cell stuck in a press": (stuck(begin=in_press), STILL),
    "cell dead, with noise": (dead_noise, UNCHANGED),
    "cell dead on its way down": (dead_from(seeking), UNCHANGED),
    "cell dead in a press": (dead_from(in_press), UNFELT),
    "readings times 0.001": (scaled(1e-3), STILL),  # their digits end
    "readings times 0.01": (scaled(1e-2), "N scaled as grams"),
    "readings times 0.1": (scaled(0.1), "kgf read as N"),
    "readings times 10": (scaled(10.0), "N scaled as kg"),
    "readings times 100": (scaled(1e2), "scatter.*mN or grams read as N"),
    "readings times 1000": (scaled(1e3), "scatter.*mN or grams read as N"),
    "sign": (scaled(-1.0), "the sign of the scale is wrong"),
    "sign and a tenth": (scaled(-0.1), "the sign of the scale is wrong"),
    "sign, from a press on": (scaled(-1.0, in_press), UNFELT),
    "a tenth, from a press on": (scaled(0.1, in_press), UNFELT),
    "late by 0.5 s": (late(0.5), UNCHANGED),
    "late by 3 s": (late(3.0), UNCHANGED),
    "NaN on its way down": (says(float("nan"), seeking), UNCHANGED),
    "NaN in a press": (says(float("nan"), in_press), SILENT),
    "silent on its way down": (says(None, seeking), UNCHANGED),
    "silent in a press": (says(None, in_press), SILENT),
    "end of scale once": (spike, "more than the limit"),
    "end of scale in a press": (says(191.0, in_press), "more than the limit"),
    "end of scale of a pull, in a press": (says(-191.0, in_press), "more than the limit"),
    "drift of the cell": (drifting(0.02), "expected"),
    "drift of the cell, down": (drifting(-0.05), "it drifts"),
    # what the board says
    "frames stuck in a press": (frames_stuck(in_press), BOARD_STILL),
    "frames stuck on its way down": (frames_stuck(seeking), BOARD_STILL),
    "board says its last lines for ever": (whole_board_frozen, STILL),
    "chips dead in a press": (chips_dead(in_press), UNSEEN),
    "chips dead from the first way down": (chips_dead(seeking), UNSEEN),
    "header storm": (board_says(40 * encode_header(CHANNELS), in_press), None),
    "headers without frames": (
        board_says(40 * encode_header(CHANNELS), in_press, True),
        "board has said",
    ),
    "headers of other channels": (board_says(OTHER, in_press), "other channels than before"),
    "another header while stopping": (board_says(OTHER, stopping), f"other channels.*{UP}"),
    "garbage without end": (board_says(bytes(range(256)) * 8, in_press, True), "board has said"),
    "half a line without end": (board_says(b"$F,1,2,3", seeking, True), UNCHANGED),
    # what the machine does and says
    "reset in a press": (machine_does(lambda machine: machine.power_on(), in_press), RESET),
    "reset while stopping": (
        machine_does(lambda machine: machine.power_on(), stopping),
        "was reset.*position|was reset.*NOT raised",
    ),
    "reset to zero, unlocked": (machine_does(reset_to_zero, in_press), RESET),
    "reset to zero while stopping": (machine_does(reset_to_zero, stopping), "NOT raised"),
    "alarm in a press": (
        machine_does(lambda machine: machine.alarm(1), in_press),
        "could NOT be raised",
    ),
    "soft limit in a press": (machine_does(lambda machine: machine.alarm(2), in_press), UP),
    "a line refused": (
        machine_does(lambda machine: machine.refuse.append(2), in_press),
        f"error:2.*{UP}",
    ),
    "ok lost in a press": (machine_says(no_ok, in_press), f"lines without answer.*{UP}"),
    "ok lost on its way down": (machine_says(no_ok, seeking), f"lines without answer.*{UP}"),
    "ok late": (lambda bench: setattr(bench.machine, "late_ok_s", 0.6), None),
    "deaf machine": (
        machine_hears(nothing, in_press),
        "machine has said nothing.*not known.*by hand",
    ),
    "silent machine": (
        machine_says(nothing, seeking),
        "machine has said nothing.*not known.*by hand",
    ),
    "characters lost": (lost_at_random, UP),
    "position frozen": (position_frozen, "not known.*by hand"),
    "line fails while stopping": (raising(OSError("gone"), 4, stopping), None),
    "Ctrl-C in a press": (raising(KeyboardInterrupt(), 1, in_press), f"by the user.*{UP}"),
    "Ctrl-C while stopping": (raising(KeyboardInterrupt(), 3, stopping), f"by the user.*{UP}"),
    "grblHAL reset in a press": (grblhal_reset, RESET),
    "a machine that starts anew at the stop": (starts_anew_at_the_stop, "without a move.*by hand"),
    "the lifting line lost": (lifting_line_lost, "was lost.*not known.*by hand"),
    "a digit changed on its way to a press": (deeper_by_a_digit, f"where it was not sent.*{UP}"),
    "an axis stuck": (stuck_axis, "not known.*by hand"),
}


ALIKE = {
    *("cell stuck on its way down", "readings times 0.01", "readings times 10", "sign and a tenth"),
    *("readings times 100", "a tenth, from a press on", "late by 3 s", "NaN in a press"),
    *("silent on its way down", "drift of the cell, down", "frames stuck on its way down"),
    *("chips dead from the first way down", "headers without frames", "half a line without end"),
    *("reset to zero, unlocked", "reset to zero while stopping", "ok lost on its way down"),
    *("another header while stopping", "line fails while stopping", "soft limit in a press"),
}
"""Faults that others among them take the same way: they are left to the slow tests."""
OF_THE_MACHINE = {
    *("reset while stopping", "alarm in a press", "a line refused", "ok lost in a press"),
    *("deaf machine", "silent machine", "position frozen", "Ctrl-C in a press"),
    *("Ctrl-C while stopping", "grblHAL reset in a press", "an axis stuck"),
    *("a machine that starts anew at the stop", "a digit changed on its way to a press"),
}
"""Faults that a rig takes the same way with a load cell and without: quick with one alone."""


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
    up = bench.depth_mm <= -2.0
    assert ("tip is up" in error) <= up, error
    assert "Traceback" not in error


def slow_where_alike(names, alike=ALIKE):
    return [pytest.param(name, marks=pytest.mark.slow) if name in alike else name for name in names]


@pytest.mark.parametrize("name", slow_where_alike(FAULTS))
def test_no_fault_drives_the_tip_into_the_object(tmp_path, name):
    plant, words = FAULTS[name]
    bench = Bench()
    plant(bench)
    error, done = ended(bench, tmp_path)
    require_unharmed(bench)
    if words is None:
        assert error is None
        assert len(done) == 2
    else:
        require_told(bench, error)
        assert re.search(words, error), error


AT_MARLIN = {
    name: FAULTS[name][1]
    for name in (
        "end of scale in a press",
        *("another header while stopping", "reset in a press", "reset to zero, unlocked"),
        *("reset while stopping", "reset to zero while stopping", "alarm in a press", "ok late"),
        *("deaf machine", "silent machine", "position frozen", "line fails while stopping"),
        *("Ctrl-C in a press", "Ctrl-C while stopping", "the lifting line lost"),
        *("ok lost in a press", "ok lost on its way down"),
    )
} | {
    "a line refused": f"checksum mismatch.*{UP}",
    "a digit changed on its way to a press": f"checksum mismatch.*{UP}",
    "characters lost": UP,
    "a machine that starts anew at the stop": "was reset, or lost its supply.*by hand",
}
"""Faults of sensors that are as with a Grbl, and those of the machine in Marlin's words."""


@pytest.mark.parametrize("name", slow_where_alike(AT_MARLIN, ALIKE | {"position frozen"}))
def test_no_fault_drives_a_tip_on_marlin_into_the_object(tmp_path, name):
    bench = Bench(dialect="marlin")
    FAULTS[name][0](bench)
    error, done = ended(bench, tmp_path)
    require_unharmed(bench)
    assert not bench.machine.overflowed
    if AT_MARLIN[name] is None:
        assert error is None
        assert len(done) == 2
    else:
        require_told(bench, error)
        assert re.search(AT_MARLIN[name], error), error


@pytest.mark.parametrize("dialect", DIALECTS)
def test_a_stop_ends_the_stroke_and_what_waits_behind_it(tmp_path, dialect):
    """The second stop of the press, 2 mm deep, waits behind the first when the force is beyond the limit."""
    bench = Bench(dialect=dialect)
    FAULTS["end of scale in a press"][0](bench)
    ended(bench, tmp_path)
    assert 1.2 < max(bench.depths) < 1.6


def test_motors_of_a_marlin_stay_on_after_a_stop(tmp_path):
    bench = Bench(dialect="marlin")
    FAULTS["end of scale in a press"][0](bench)
    ended(bench, tmp_path)
    assert bench.machine.off_after_s == 0


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"emergency_parser": False}, "built without EMERGENCY_PARSER"),
        ({"soft": "OFF"}, "soft limits are off"),
        ({"switches": ("x_min", "y_min", "z_min")}, "homes downwards"),
        ({"switches": ("x_max", "y_max", "z_max", "z_probe")}, "homes downwards"),
    ],
)
def test_a_marlin_that_cannot_be_stopped_or_would_home_onto_the_object_is_refused(
    tmp_path, wrong, words
):
    bench = Bench(dialect="marlin", **wrong)
    error, _ = ended(bench, tmp_path)
    assert re.search(words, error), error
    assert bench.machine.lines == []
    assert bench.depth_mm == pytest.approx(-18.0)


BY_TRAVEL = {
    name: FAULTS[name][1]
    for name in (
        *("frames stuck in a press", "frames stuck on its way down", "chips dead in a press"),
        *("chips dead from the first way down", "header storm", "headers without frames"),
        *("headers of other channels", "another header while stopping", "garbage without end"),
        *("reset in a press", "reset while stopping", "reset to zero, unlocked"),
        *("reset to zero while stopping", "alarm in a press", "soft limit in a press"),
        *("a line refused", "ok lost in a press", "ok lost on its way down", "ok late"),
        *("deaf machine", "silent machine", "characters lost", "position frozen"),
        *("line fails while stopping", "Ctrl-C in a press", "Ctrl-C while stopping"),
        *("grblHAL reset in a press", "a machine that starts anew at the stop"),
        *("the lifting line lost", "an axis stuck", "a digit changed on its way to a press"),
    )
} | {
    "board says its last lines for ever": BOARD_STILL,
    "half a line without end": "board has said nothing",
}
"""Faults without a load cell that are as with one, and those that only the cell's line told."""
CLEAR, BACK = "mm above the surface. Has the machine lost steps", "the chips still see a contact"
WITHOUT_CELL = {
    "steps lost upwards": (steps_lost(1.6), f"{CLEAR}.*{UP}"),
    "steps lost downwards": (steps_lost(-3.0), f"no chip sees a contact.*{UP}"),
    "the only chip stuck that sees a place": (chip_stuck, "no chip sees a contact"),
    "a chip jumps on its way down": (chip_jumps(seeking), f"{BACK}.*{UP}"),
    "a chip jumps in a press": (chip_jumps(in_press), f"{BACK}.*{UP}"),
    "steel in the tip": (steel_in_the_tip, "steel|above where --middle"),
    "a load cell after all": (lambda bench: setattr(bench, "cell", lambda n: n), "sends forces"),
}


SLOW_MARLIN = [
    pytest.param(name, marks=pytest.mark.slow) if name == "marlin" else name for name in DIALECTS
]


@pytest.mark.parametrize("dialect", SLOW_MARLIN)
@pytest.mark.parametrize(
    "name", [*slow_where_alike(BY_TRAVEL, ALIKE | OF_THE_MACHINE), *WITHOUT_CELL]
)
def test_no_fault_drives_the_tip_into_the_object_without_a_load_cell(tmp_path, name, dialect):
    """Nothing but the chips and the stated surface bounds the travel then."""
    plant, words = WITHOUT_CELL.get(name) or (FAULTS[name][0], BY_TRAVEL[name])
    if dialect == "marlin":
        words = AT_MARLIN.get(name, words)
        if name in ("soft limit in a press", "grblHAL reset in a press"):
            pytest.skip("is of Grbl")
    bench = Bench(FollowsForce(), dialect=dialect)
    bench.cell = nobody
    plant(bench)
    error, done = ended(bench, tmp_path, by_travel=True)
    require_unharmed(bench)
    if words is None:
        assert error is None
        assert len(done) == 2
    else:
        require_told(bench, error)
        assert re.search(words, error), error


FAST = SETTINGS | {"speed_mm_s": 4.0, "strokes": 3, "pause_s": 0.6, "depths_mm": DEPTHS_MM[1:]}


@pytest.mark.slow
@pytest.mark.parametrize("stiffer", [0.6, 1.0, 1.6, 2.4])
@pytest.mark.parametrize("settings", [SETTINGS, FAST])
@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.parametrize("name", FAULTS)
def test_no_fault_harms_other_objects_at_other_speeds(tmp_path, name, dialect, settings, stiffer):
    bench = Bench(Silicone(stiffer), seed=1, dialect=dialect)
    FAULTS[name][0](bench)
    error, _ = ended(bench, tmp_path, settings)
    require_unharmed(bench)
    if error is not None:
        require_told(bench, error)


@pytest.mark.slow
@pytest.mark.parametrize("stiffer", [0.6, 1.8])
@pytest.mark.parametrize("settings", [SETTINGS, FAST])
@pytest.mark.parametrize("name", [*BY_TRAVEL, *WITHOUT_CELL])
def test_no_fault_harms_other_objects_without_a_load_cell(tmp_path, name, settings, stiffer):
    """Up to the stiffest silicone of the specification: its law says 10 N at 2 mm, the object gives 9.8 N."""
    bench = Bench(FollowsForce(stiffer), seed=1)
    bench.cell = nobody
    (WITHOUT_CELL.get(name) or FAULTS[name])[0](bench)
    error, _ = ended(bench, tmp_path, settings, by_travel=True)
    require_unharmed(bench)
    if error is not None:
        require_told(bench, error)


@pytest.mark.parametrize(
    ("stiffer", "numbers", "kind"),
    [
        (0.5, False, lambda _: None), (1.5, True, lambda _: None), (0.5, True, four_axes),
        (1.5, False, grblhal), (0.5, False, "marlin"), (1.5, True, "marlin"),
    ],
)  # fmt: skip
def test_a_sound_rig_does_its_plan(tmp_path, stiffer, numbers, kind):
    dialect, kind = ("marlin", FAULTS["ok late"][0]) if kind == "marlin" else ("grbl", kind)
    bench = Bench(Silicone(stiffer), numbers=numbers, dialect=dialect)
    kind(bench)
    error, done = ended(bench, tmp_path)
    assert error is None
    assert len(done) == 2
    assert max(bench.depths) == pytest.approx(DEPTHS_MM[-1], abs=0.1)
    require_unharmed(bench)
    assert bench.depth_mm <= -2.0


@pytest.mark.parametrize(
    ("off_mm", "words"),
    [(8.0, "touched at Z.* above where --middle"), (-8.0, "below where --middle")],
)
def test_a_surface_that_is_not_where_it_was_said_is_refused(tmp_path, off_mm, words):
    """The tip touches 8 mm too early, or 8 mm too low nothing is there."""
    bench = Bench()
    error, _ = ended(bench, tmp_path, middle_z_mm=TOP_MM - off_mm)
    assert re.search(words, error), error
    assert UP in error
    require_unharmed(bench)


@pytest.mark.parametrize("off_mm", [-0.5, 2.0])
def test_a_height_that_is_a_little_wrong_is_corrected(tmp_path, off_mm):
    bench = Bench()
    error, done = ended(bench, tmp_path, middle_z_mm=TOP_MM - off_mm)
    assert error is None
    assert len(done) == 2
    assert max(bench.depths) == pytest.approx(DEPTHS_MM[-1], abs=0.1)


def test_the_limit_holds_on_a_stiff_object_whose_witnesses_both_die(tmp_path):
    """Nothing tells the force any more: the bound follows from the stiffness that was measured before."""
    bench = Bench(Silicone(2.6))
    dead_from(in_press)(bench)
    chips_dead(in_press)(bench)
    ended(bench, tmp_path, SETTINGS | {"depths_mm": (1.5, 2.5)})
    assert bench.silicone.force_n(2.5, np.zeros(2)) > 1.5 * LIMIT_N
    assert max(bench.forces) < LIMIT_N


def test_a_board_that_says_old_forces_is_told_before_they_are_believed(tmp_path):
    bench = Bench()
    bench.stamps_late_ms = 700
    error, _ = ended(bench, tmp_path)
    assert "0.6 s older than the frames beside them" in error
    require_unharmed(bench)


def test_the_way_on_ends_where_nobody_speaks(tmp_path):
    """A deep fast press: 1.5 s of silence would be 6 mm."""
    bench = Bench()
    says(None, in_press)(bench)
    settings = SETTINGS | {"depths_mm": (3.2,), "speed_mm_s": 4.0, "full_n": 16.0}
    error, _ = ended(bench, tmp_path, settings)
    assert "for 1 mm of the way down" in error
    assert max(bench.depths) < 2.9


def test_a_late_cell_is_told_by_the_chips_where_the_surface_is_higher_than_stated(tmp_path):
    """The end of the way down lies 3 mm in the object then."""
    bench = Bench()
    late(0.7)(bench)
    error, _ = ended(bench, tmp_path, middle_z_mm=TOP_MM - 2.0)
    assert UNFELT in error
    require_unharmed(bench)


def test_an_object_that_gives_way_ends_the_steps(tmp_path):
    """It is felt at first, and then slides away under the tip."""
    bench = Bench()
    force_n = bench.silicone.force_n
    bench.silicone.force_n = lambda depth_mm, xy_mm: min(force_n(depth_mm, xy_mm), 0.35)
    error, _ = ended(bench, tmp_path)
    assert "Or does the object move?" in error
    require_unharmed(bench)


def test_numbers_of_a_cell_on_its_own_line_are_checked_too(tmp_path):
    bench = Bench(numbers=True)
    bench.cell = lambda force_n: 1e-3 * force_n
    error, _ = ended(bench, tmp_path)
    assert "kN read as N" in error
    require_unharmed(bench)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"depths_mm": (4.0,)}, "about 29 N are expected there.*depths_mm below"),
        ({"depths_mm": (9.0,), "full_n": 400.0}, "depths_mm below 7.6"),  # the shell is 8 mm thick
    ],
)
def test_depths_that_the_specification_does_not_bear_are_refused(tmp_path, settings, words):
    bench = Bench()
    with (
        at_bench(bench, SPEC, SETTINGS | settings, tmp_path) as (_, go, _journal),
        pytest.raises(InputError, match=words),
    ):
        go()
    assert bench.machine.lines == []
