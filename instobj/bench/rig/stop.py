"""Stop of a machine with its tip lifted, by nothing but its own serial line.

Boards and load cells are neither heard nor parsed here: whatever they say, the tip comes up.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from instobj.bench.rig.machine import MachineFault, MachineLink
from instobj.bench.rig.replies import Alarm, State

ARRIVED_MM = 0.03
"""Reports have three digits and steps of machines are finer; a lost character changes tenths at least."""
_AGAIN_S = 0.3
_STATE_S = 0.05
_PATIENCE_S = 5.0
_MOVE_S = 60.0
"""Longest time of the lift: the longest axis at the slowest speed that such machines have."""
_TRIES, _TRYING_S = 20, 20.0
"""A line in which every eleventh character is lost comes whole now and then."""
_STILL = 4
"""Reports `Idle` at one place in a row after which nothing moves, where a hold leaves no state `Hold`."""
_NAP_S = 0.001
"""Pause of a wait: the link is asked that often."""
_BY_HAND = (
    "Where the tip is is not known. Press the emergency stop, turn the machine off, and turn its Z axis up "
    "by hand (or jog it up while you watch); then --resume homes it, upwards first"
)


def lift(link: MachineLink, safe_mm: float) -> tuple[float, bool]:
    """Stop the feed, forget all lines, lift the tip to the safe height; returns the height (mm) at which
    it was stopped, and whether Ctrl-C came meanwhile (it must not end this).

    Tried again where characters are lost: the safe height is whole millimetres, so that a lost digit
    leads upwards, and nothing lower than it is sent.

    Raises
    ------
    MachineFault
        The machine has lost its position, does not answer, or does not report that the tip is up.
    """
    link.trusted, interrupted = False, False
    give_up_s, alarm = link.clock.now_s() + _TRYING_S, link.alarm
    why = "it does not answer"
    for _ in range(_TRIES):
        try:
            stopped_mm = _lifted(link, safe_mm, alarm)
        except KeyboardInterrupt:
            interrupted = True
        except Exception as error:  # whatever it is, the tip must come up
            why = str(error)
        else:
            link.trusted = True
            return stopped_mm, interrupted
        alarm = link.alarm or alarm
        if link.lost or not _is_known_after(alarm) or link.clock.now_s() > give_up_s:
            break
    link.lost = True
    raise MachineFault(f"{why}. {_BY_HAND}")


def _is_known_after(alarm: Alarm | None) -> bool:
    return alarm is None or alarm.keeps_position


def halt(link: MachineLink, patience_s: float = _PATIENCE_S) -> State | None:
    """Hold the feed and empty the machine's buffers; its state before the reset that does it.

    Raises
    ------
    MachineFault
        It does not answer.
    """
    link.trusted = False
    still = _Still(link)
    _asked(link, link.hold, still.held, patience_s)
    last_state, greeted = link.state, link.greetings
    _asked(link, link.reset, lambda: link.greetings > greeted)
    link.alarm, wanted_states = None, link.states + 2
    _asked(link, link.ask, lambda: link.states >= wanted_states)
    return last_state


def _lifted(link: MachineLink, safe_mm: float, alarm: Alarm | None) -> float:
    last_state = halt(link)
    state = link.state
    if state is None or last_state is None or link.lost:
        raise MachineFault(f"{link.where} was reset, or lost its supply")
    if state.name == "Alarm" and alarm is not None and alarm.keeps_position:
        link.send("$X")
    elif state.name == "Alarm":
        why = "locked" if alarm is None else alarm.why
        link.lost = True
        raise MachineFault(f"{link.where} is in an alarm ({why}) and cannot lift the tip")
    # A controller that starts anew calls the place where it is zero: an upward move from there leads down.
    if not np.allclose(state.position_mm, last_state.position_mm, rtol=0, atol=ARRIVED_MM):
        link.lost = True
        raise MachineFault(
            f"{link.where} reports {state.position_mm} after {last_state.position_mm} without a move"
        )
    link.send(f"G53G0Z{safe_mm:g}")
    _wait_until_up(link, safe_mm)
    link.forget()
    return state.position_mm[2]


def _wait_until_up(link: MachineLink, safe_mm: float) -> None:
    """Wait for the machine's own reports: an `ok` may be lost, and says only that a line was read."""
    still = _Still(link)

    def up() -> bool:
        state = link.state
        is_up = state is not None and abs(state.position_mm[2] - safe_mm) < ARRIVED_MM
        if still.idle() and not is_up:
            raise MachineFault(f"{link.where}: the line that lifts the tip was lost")
        return is_up and still.idle()

    _asked(link, link.ask, up, _MOVE_S)


class _Still:
    """Judge of a machine that stands still, by reports that are new since this was made."""

    def __init__(self, link: MachineLink) -> None:
        self.link, self._first = link, link.states + 2
        self._seen, self._equal, self._last = link.states, 0, None

    def held(self) -> bool:
        """After a hold: held, in an alarm, or idle for long enough."""
        state = self.link.state
        if state is None or self.link.states < self._first:
            return False
        return state.held or state.name == "Alarm" or self.idle()

    def idle(self) -> bool:
        """Idle at one place in several reports."""
        state = self.link.state
        if state is not None and self.link.states > self._seen:
            same = state.name == "Idle" and state == self._last
            self._equal, self._last = self._equal + 1 if same else 0, state
            self._seen = self.link.states
        return self._equal >= _STILL


def _asked(
    link: MachineLink,
    ask: Callable[[], None],
    met: Callable[[], bool],
    patience_s: float = _PATIENCE_S,
) -> None:
    """Ask until it is met, again and again: characters may be lost. Its state is asked for more often."""
    asked_s, state_s, began_s = -np.inf, -np.inf, link.clock.now_s()
    while not met():
        now_s = link.clock.now_s()
        if now_s - began_s > patience_s:
            raise MachineFault(f"{link.where} gave no answer within {patience_s:g} s")
        if now_s - asked_s > _AGAIN_S:
            asked_s = now_s
            ask()
        if now_s - state_s > _STATE_S:
            state_s = now_s
            link.ask()
        link.poll()
        link.clock.nap(_NAP_S)
