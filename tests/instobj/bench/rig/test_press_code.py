"""G-code of presses on the simulated machine, which is left alone at any moment."""

import numpy as np
import pytest

from design.errors import InputError
from instobj.bench.rig.grbl_lines import RECEIVE_BYTES
from instobj.bench.rig.machine import MachineLink
from instobj.bench.rig.plan import PressSettings
from instobj.bench.rig.press_code import press_code
from tests.support.grbl_simulator import GrblSimulator

SURFACE_MM, SAFE_MM, STEP_S = -20.0, -15.0, 0.02
STROKES = PressSettings((3.0,), strokes=5, dwell_s=0.3, stroke_speed_mm_s=2.0)


class Wire:
    """A machine's serial line that can be out."""

    def __init__(self, machine):
        self.machine, self.out = machine, False

    def read(self, size):
        return b"" if self.out else self.machine.give()

    def write(self, data):
        if not self.out:
            self.machine.take(data)
        return len(data)


def heights(settings, out_s=np.inf):
    """Heights (mm) of the tip at every step of a press whose wire is out after some time."""
    machine = GrblSimulator(_22=0)
    machine.position[2] = SAFE_MM
    wire = Wire(machine)
    link = MachineLink(wire, "machine", trusted=True, floor_mm=SURFACE_MM - 3.0)
    machine.give()
    for part in press_code(settings, SURFACE_MM, SAFE_MM, RECEIVE_BYTES):
        link.send_whole(part)
    found = []
    while machine.now < settings.seconds:
        wire.out = machine.now >= out_s
        link.poll()
        machine.advance(STEP_S)
        found.append(machine.position[2])
    assert not machine.overflowed
    return np.array(found)


def test_strokes_follow_each_other_without_a_gap():
    found = heights(STROKES)
    assert found.min() == pytest.approx(SURFACE_MM - 3.0)
    assert found[-1] == SAFE_MM
    down = found < SURFACE_MM
    assert np.sum(down[1:] & ~down[:-1]) == 5
    between = np.flatnonzero(np.isclose(found, SURFACE_MM + STROKES.lift_mm))
    pauses = np.split(between, np.flatnonzero(np.diff(between) > 1) + 1)
    pauses = [one for one in pauses if len(one) > 1]
    assert len(pauses) == 4
    assert all(abs(len(one) * STEP_S - STROKES.pause_s) < 0.1 for one in pauses)


@pytest.mark.parametrize("out_s", np.arange(0.0, 24.0, 1.3))
def test_left_alone_at_any_moment_the_machine_ends_with_the_tip_clear(out_s):
    assert heights(STROKES, out_s)[-1] >= SURFACE_MM + STROKES.lift_mm - 1e-9


def test_every_stroke_is_one_part_and_ends_clear_of_the_surface():
    parts = press_code(PressSettings((1.5, 3.0), strokes=6), -112.345, -107.0, RECEIVE_BYTES)
    assert len(parts) == 6
    assert all(sum(len(line) + 1 for line in part) <= 127 for part in parts)
    assert all(part[-2:] == ["G53G0Z-111.84", "G4P1"] for part in parts[:-1])
    assert parts[-1][-1] == "G53G0Z-107"


def test_a_press_and_its_retraction_fit_into_the_machine_or_are_refused():
    (part,) = press_code(PressSettings((1.0, 2.0, 3.0, 4.0)), -112.345, -107.345, RECEIVE_BYTES)
    assert sum(len(line) + 1 for line in part) <= 127
    with pytest.raises(InputError, match="Give fewer depths_mm"):
        press_code(PressSettings((1.0, 1.5, 2.0, 2.5, 3.0, 4.0)), -112.345, -107.345, RECEIVE_BYTES)


@pytest.mark.parametrize("wrong", [{"strokes": 0}, {"strokes": 2, "lift_mm": 9.0}])
def test_strokes_that_cannot_be_done_are_refused(wrong):
    with pytest.raises(InputError, match=r"(strokes=|clearance)"):
        PressSettings((1.0,), **wrong)
