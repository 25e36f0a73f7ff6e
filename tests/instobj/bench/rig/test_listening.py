"""Silence on a busy computer: told of what was listened to, not of a program that was kept waiting."""

from types import SimpleNamespace

import pytest

from design.spec.object import ObjectSpec
from instobj.bench.rig import cycle
from instobj.bench.rig.clock import Clock
from instobj.bench.rig.machine import MachineFault, MachineLink, until
from instobj.bench.rig.run import new_station
from instobj.bench.rig.station import Silence

LOST_S = 3.0


class HandClock(Clock):
    """Time that passes by hand; each nap of a tick lasts a tenth of a second."""

    def __init__(self):
        self.now = 1000.0

    def now_s(self):
        return self.now

    def nap(self, seconds):
        self.now += 0.1


@pytest.fixture
def clock():
    return HandClock()


def silent_station(clock):
    """A machine that answers nothing, no board and no load cell; what it says is given by hand."""
    said = []
    line = SimpleNamespace(read=lambda _: said.pop() if said else b"", write=len)
    link = MachineLink(line, "machine", clock=clock)
    nothing = iter(lambda: b"", None)
    made = new_station(link, nothing, None, ObjectSpec(name="cube"), 5.0, LOST_S)
    made.machine.trusted = True
    return made, said


def ticked(made, clock, apart_s):
    """A hundred ticks."""
    for _ in range(100):
        clock.now += apart_s
        made.tick()


def test_a_program_that_was_kept_waiting_does_not_call_the_machine_silent(clock):
    made, said = silent_station(clock)
    made.expect()
    made.tick()
    clock.now += 60.0
    made.tick()
    said.append(b"<Idle|MPos:0.000,0.000,0.000|FS:0,0>\r\n")
    made.tick()  # it answers once it is asked; boards and load cells speak unasked
    heard_s = clock.now
    with pytest.raises(Silence, match="has said nothing for 3 s"):
        ticked(made, clock, 0.0)
    assert clock.now - heard_s == pytest.approx(LOST_S, abs=0.9)


def test_some_slow_ticks_are_enough_to_tell_silence(clock):
    made, _ = silent_station(clock)
    made.expect()
    began_s = clock.now
    with pytest.raises(Silence):
        ticked(made, clock, 30.0)
    assert 4 <= round((clock.now - began_s) / 30) <= 6


@pytest.mark.parametrize(("board_rate", "told_s"), [(1.0, 1.0), (0.25, 4.0), (0.0, 5.0)])
def test_lines_without_answer_are_told_after_a_second_of_listening(clock, board_rate, told_s):
    """Neither a time in which the program is kept waiting counts nor one in which the board's clock is
    slow; where that stands still, five seconds are enough."""
    made, _ = silent_station(clock)
    began_s = clock.now

    def tick():
        clock.now += 30.0 if clock.now == began_s else 0.05
        made.frame_ms = round(1000 * board_rate * (clock.now - began_s - 29.95))

    made.tick = tick
    made.machine.state = SimpleNamespace(name="Idle")
    made.machine.send("G0")
    with pytest.raises(MachineFault, match="1 lines without answer"):
        cycle.settle(made)
    assert clock.now - began_s - 29.95 == pytest.approx(told_s, abs=0.3)


def test_patience_is_of_listening_too(clock):
    met, link = iter([False] * 3 + [True]), silent_station(clock)[0].machine
    until(
        link,
        lambda: clock.nap(setattr(clock, "now", clock.now + 50.0)),
        lambda: next(met),
        "it",
        60.0,
    )
    with pytest.raises(MachineFault, match="it did not come within 2 s"):
        until(link, lambda: clock.nap(0.0), lambda: False, "it", 2.0)
    assert clock.now == pytest.approx(1152.1, abs=0.6)
