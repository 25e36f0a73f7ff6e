"""Time limit of a whole search: mechanics, trials and all fidelity levels of one call."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from math import ceil
from types import FrameType

from design.errors import InputError

TRIALS_SHARE = 0.4
"""Share of the search's time, for mechanics and trials: measured, leaders and finalists took 15 of 25
minutes."""
_PAGE_SHARE = 0.06
"""Share of the whole time, for the page and its pictures."""
_CHAINS = 2
"""The start and a finalist."""
_LONG_STEPS = 3
"""Steps after the trials that take about as long as mechanics of the lowest level, each with contact at every
location: the second level of the start and of a leader, and the chain of a finalist. Measured on one box
alone (60 × 45 × 40 mm): mechanics 133 s, second level 115 s, chain 140 to 180 s."""
_QUICKER = 2.0
"""Than estimated, at most: estimates hold within half to twice."""
FIRST_LOOK_S = 10.0
"""Time of the generations of the specification's own layout, where other trials follow, and of any trial at
least."""
_TRIAL_SHARE = 0.9
"""Share of the time after which a trial is given up: the rest is for reading its mechanics."""
_SHORTEST_S = 1e-3
"""Time of a timer, at least: 0 would switch it off."""


class TimeSpent(BaseException):
    """Beyond the reach of handlers of errors, as an interrupt by the user is."""


@dataclass(frozen=True)
class TimeLimit:
    """`seconds` from now on, the last of which are for the page."""

    seconds: float
    started: float = field(default_factory=lambda: time.monotonic())

    @property
    def searching_s(self) -> float:
        """Until the page."""
        return (1 - _PAGE_SHARE) * self.seconds

    @property
    def left_s(self) -> float:
        """Until the page."""
        return self.started + self.searching_s - time.monotonic()

    def left_of(self, share: float) -> float:
        """Seconds that are left of this share of the search's time."""
        return self.left_s - (1 - share) * self.searching_s

    @property
    def left(self) -> str:
        return f"{max(self.left_s, 0):.0f} of {self.searching_s:.0f} s left until the page"

    @property
    def plan(self) -> str:
        """Return how the time is shared out, in words."""
        return (
            f"search.seconds = {self.seconds:g}: search until {round(TRIALS_SHARE * self.searching_s)} s; "
            f"check the best until {round(self.searching_s)} s; then write the page"
        )

    def holds_trials(self, lowest_s: float) -> bool:
        """Return whether mechanics that are estimated to take `lowest_s` leave time for trials."""
        return lowest_s < TRIALS_SHARE * self.searching_s

    def enough_s(self, lowest_s: float, chain_s: float) -> float:
        """Return the time to ask for, rounded up to 100 s: mechanics in the trials' share, and chains
        twice as long as estimated."""
        whole_s = lowest_s + _CHAINS * chain_s
        needed_s = max(lowest_s / TRIALS_SHARE, 2 * whole_s) / (1 - _PAGE_SHARE)
        return 100 * ceil(needed_s / 100)

    def measured_s(self, mechanics_s: float) -> float:
        """Return the time to ask for once mechanics are stored that took `mechanics_s`: the steps after the
        trials fit into what trials leave. Rounded up to 100 s, at least this limit's own."""
        needed_s = _LONG_STEPS * mechanics_s / self._checking_s(1.0)
        return max(100.0 * ceil(needed_s / 100), self.seconds)

    def measured_plan(self, mechanics_s: float) -> str:
        """Return that the time left is likely too short, by the time that mechanics took, and which will do;
        nothing where it holds."""
        needed_s = _LONG_STEPS * mechanics_s
        if needed_s <= min(self.left_s, self._checking_s(self.seconds)):
            return ""
        return (
            f"mechanics took {mechanics_s:.0f} s; what follows the trials takes about {_LONG_STEPS} times as "
            f"long. search.seconds = {self.seconds:g} is likely to end before a result. What is made is "
            "kept: stop now (Ctrl-C) or when it ends, and go on with --resume "
            f"--set search.seconds={self.measured_s(mechanics_s):g}"
        )

    def _checking_s(self, seconds: float) -> float:
        """Return the part of a whole time that trials and page leave."""
        return (1 - TRIALS_SHARE) * (1 - _PAGE_SHARE) * seconds

    def mechanics_plan(self, lowest_s: float, chain_s: float) -> str:
        """Return what of the time mechanics will take, in words; `lowest_s` 0 where those are stored.

        Raises
        ------
        InputError
            The search would end without a result, were they twice as quick as estimated.
        """
        if not lowest_s:
            return "mechanics of the lowest fidelity level are stored"
        text = (
            "mechanics of the lowest fidelity level are not stored: about "
            f"{_describe_seconds(lowest_s)} of one free core, half to twice as long"
        )
        whole_s = lowest_s + _CHAINS * chain_s
        if max(lowest_s / TRIALS_SHARE, 2 * whole_s) <= (1 - _PAGE_SHARE) * self.seconds:
            return text
        give = f"give --set search.seconds={self.enough_s(lowest_s, chain_s):g}"
        if whole_s > _QUICKER * self.searching_s:
            raise InputError(
                f"search.seconds = {self.seconds:g} ends before a search has a result: {text}, and "
                f"{_CHAINS} × {_describe_seconds(chain_s)} for the chain of the start and "
                "of a finalist, twice as long beside other programs. Instead "
                f"{give}"
            )
        holds = (
            "not even the mechanics" if whole_s > self.searching_s else "mechanics, but few trials"
        )
        return (
            f"{text}. search.seconds = {self.seconds:g} is likely to hold {holds}: {give}. What was "
            "made is kept, and --resume goes on from there"
        )

    @contextmanager
    def enforced(
        self,
        first_look: Callable[[], str] = lambda: "",
        enough_s: Callable[[], float] = lambda: 0.0,
    ) -> Iterator[None]:
        """Break off what runs in here when the time is spent; `first_look` then keeps the best so far, and
        says where and what else is kept.

        The error asks for `enough_s`, what was advised by then, unless more was given; else for twice the
        time.

        Work in compiled code ends first: a factorization of the default mesh takes seconds. Work that
        can be left out catches `TimeSpent`, once. On systems without interval timers (Windows) nothing
        is broken off.

        Raises
        ------
        InputError
            The time was spent.
        """
        if not hasattr(signal, "setitimer"):
            yield
            return
        previous_handler = signal.signal(signal.SIGALRM, _raise_alarm)
        try:
            signal.setitimer(signal.ITIMER_REAL, max(self.left_s, _SHORTEST_S))
            yield
            signal.setitimer(signal.ITIMER_REAL, 0)
        except TimeSpent:
            advised_s = enough_s()
            again_s = advised_s if advised_s >= self.seconds else 2 * self.seconds
            raise InputError(
                f"the time of this search, search.seconds = {self.seconds:g}, was spent before there "
                f"was a result.{first_look()} Go on with --resume --set search.seconds={again_s:g}, "
                "all other options as before"
            ) from None
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, previous_handler)


def trial_ends(questions: int, at_once: int, left_s: float, most_s: float) -> list[float]:
    """Return when answers to that number of questions shall be there, as `time.time()`.

    As many as `at_once` are answered side by side.

    They share `left_s`, what is left to all trials, evenly; each has `FIRST_LOOK_S` at least, and ends before
    it is given up after `most_s`.
    """
    turns = [1 + index // at_once for index in range(questions)]
    each_s = min(max(left_s / max(turns), FIRST_LOOK_S), _TRIAL_SHARE * most_s)
    now = time.time()
    return [now + turn * each_s for turn in turns]


def _describe_seconds(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 100 else f"{seconds / 60:.0f} min"


def _raise_alarm(number: int, frame: FrameType | None) -> None:
    raise TimeSpent
