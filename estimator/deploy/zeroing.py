"""The zero of a stream of readings that follows rest, for exported estimators (no torch).

Signals count as still when they scatter over a few frames no more than from one frame to the next
(von Neumann's ratio; it needs no noise level), over 0.6 s at least: in 8 frames at 200 Hz a slow press
hides below the noise. A still level becomes the zero

- at once, when it reads as less than 15 % of the largest force of a press that ended within the last
  5 s: silicone shows hysteresis of up to 10 %, and a new mounting shifts the rest;
- at once, when the step from the still level before is the whole press turned round, and what is left reads
  as no press, or as one of up to 15 % of its force: then it was let go, however far chips drifted while it
  lasted, as drift has no press's shape;
- at once, when no press explains it, but the zero read from it is one: then the zero was taken
  while something touched;
- by at most 1 count/s, when it reads as no contact: drift.

While contacts are held, a reader that knows drift moves the zero by what it sees of it, at any rate
(`StreamZero.drift`); a reader that knows a slip of the core moves it by that (`StreamZero.move`).

A reader that knows what drift looks like also judges all that was followed in the last ten minutes, in
rest and in holds, when it next follows rest:
where that is a press, and no drift, it grew slowly, and the zero goes back to where it was. Holds of
any force and length are then no rest. Of a file, frames read against a level in a press are read again,
against the rest that showed it (`read_through`). The price: a hold that keeps less than 15 % of the
force of the press before it is taken for rest; so is, by readers without that knowledge, a force that
grows by less than about 0.02 N/s. Measured on the public recording of one probe, which begins within a
press, with models of its own training presses: docs/measured/estimators.md.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple, Protocol, runtime_checkable

import numpy as np
from jaxtyping import Bool, Float

from design.errors import InputError
from estimator.recordings.presses import PAUSE_S

ZeroMode = Literal["rest", "first", "none"]
"""Way that readings are zeroed: by following rest, by the first frames, or not at all."""


class StillReading(NamedTuple):
    """Reading of a still change against rest: probability of contact, force (N), and whether contacts
    or rest explain the change; None where the reader cannot say."""

    contact: float
    force_n: float
    explained: bool | None = None


ReadStill = Callable[[Float[np.ndarray, "channel"], int], StillReading]
"""Reads the mean change of n frames."""
ZERO_FRAMES = 8
STILL_RATIO = 1.3
"""Largest ratio of the variance in a window to half the mean squared step from frame to frame."""
RETURN_SHARE = 0.15
"""Share of the largest force of a press up to which it counts as ended."""
SETTLE_S = 5.0
"""Time after a load from which its press is over; drift is followed over so long at most."""
DRIFT_COUNTS_PER_S = 1.0
"""Rate at which the zero follows still levels of rest, at most."""
LEAST_FORCE_N = 0.3
"""Force below which nothing presses."""
PRESS_FORCE_N = 1.0
"""Force of a press that ends, at least: noise of single frames reads as less. Also the force read from
the change turned round, from which the zero itself was taken in a press."""
LEAST_FRAMES = 5
"""Frames of the stretch that is judged, at least."""
REMEMBERED_S = 600.0
"""Time over which drift that was followed is forgotten."""
_LIKE = 0.7
"""Cosine from which a step between two still levels has a press's shape. Noise and an error of the zero as
large as two thirds of the press leave 0.7."""
_FRAME_S = 0.1
"""Between frames without time stamps."""
_WINDOW_S = 0.6
"""Length of the stretch of frames that is judged."""
_JUDGED_EVERY_S = 0.08
"""Time between two judgements."""


def is_still(window: Float[np.ndarray, "frame channel"]) -> bool:
    """Return whether frames scatter about their mean no more than from one to the next."""
    steps = np.diff(window, axis=0)
    noise = np.maximum(np.mean(steps**2, axis=0) / 2, 1 / 12)
    return bool(np.mean(window.var(axis=0, ddof=1) / noise) <= STILL_RATIO)


def level_of(window: Float[np.ndarray, "frame channel"]) -> Float[np.ndarray, "channel"]:
    """Return the mean without each channel's largest and smallest reading: one may be wrong."""
    if len(window) < LEAST_FRAMES:
        return window.mean(axis=0)
    outer = window.max(axis=0) + window.min(axis=0)
    return (window.sum(axis=0) - outer) / (len(window) - 2)


def is_pause(elapsed_s: float) -> bool:
    """Return whether frames so far apart belong to different stretches; so does time that runs back."""
    return elapsed_s > PAUSE_S or elapsed_s < 0


@dataclass
class RestZero:
    """The zero after each frame of raw counts (channel,), None before the first still frames.

    Attributes
    ----------
    frames : least length of the window that must be still, and that gives the zero; it lasts 0.6 s or more
    read : how the estimator reads a constant change
    read_drift : the same for all that was followed lately, with drift as a disturbance; None where the
        reader does not know drift
    rested_s : when a level was last taken for rest; a level that is given, with the first frame
    starts : how many levels were taken at once, not followed
    from_press : the last of them showed that the one before it was taken in a press

    Raises
    ------
    InputError
        Fewer than five frames, among which stillness does not show.
    """

    frames: int
    read: ReadStill
    read_drift: ReadStill | None = None
    level: Float[np.ndarray, "channel"] | None = None
    rested_s: float = -math.inf
    starts: int = 0
    from_press: bool = False
    window: deque[tuple[float, np.ndarray]] = field(default_factory=deque)
    now_s: float = 0.0
    _judged_s: float = -math.inf
    loaded_s: float = -math.inf
    largest_n: float = 0.0
    _followed: np.ndarray = field(default_factory=lambda: np.zeros(1))
    _held: np.ndarray | None = None
    _press_n: float = 0.0
    _press: np.ndarray = field(default_factory=lambda: np.zeros(1))

    def __post_init__(self) -> None:
        if self.frames < LEAST_FRAMES:
            raise InputError(
                f"a zero that follows rest needs {LEAST_FRAMES} frames or more; got {self.frames}. "
                "Give more frames (--zero rest:20), or take --zero first"
            )

    def update(self, raw: Float[np.ndarray, "channel"], time_s: float = math.nan) -> None:
        """Take one frame and its time (s), if known."""
        elapsed_s = self.pass_by(raw, time_s)
        since_s = self.now_s - self._judged_s
        if since_s >= _JUDGED_EVERY_S:
            self._judge(elapsed_s if math.isinf(since_s) else since_s)
            self._judged_s = self.now_s

    def pass_by(self, raw: Float[np.ndarray, "channel"], time_s: float = math.nan) -> float:
        """Take a frame into the window alone, for readers that leave frames out; s since the last one."""
        now_s = self.now_s + _FRAME_S if math.isnan(time_s) else time_s
        elapsed_s, self.now_s = now_s - self.now_s, now_s
        if self.level is not None and math.isinf(self.rested_s):
            self.rested_s = now_s
        if is_pause(elapsed_s):
            self.window.clear()
            self._held = None
            self.loaded_s = min(self.loaded_s, now_s)
            self._judged_s = -math.inf
        self.window.append((now_s, raw))
        while len(self.window) > self.frames and self._spans(1):
            self.window.popleft()
        return elapsed_s

    def _spans(self, first: int) -> bool:
        """Return whether the window lasts long enough from that frame on."""
        return self.now_s - self.window[first][0] >= _WINDOW_S

    def _judge(self, elapsed_s: float) -> None:
        if self.level is not None:
            self.note_force(self.read(self.window[-1][1] - self.level, 1).force_n)
        level = self.still_level()
        if level is not None:
            self.consider(level, max(0.0, elapsed_s))

    def still_level(self) -> Float[np.ndarray, "channel"] | None:
        """Return the mean of the last frames; None where they are too few, or not still."""
        if len(self.window) < self.frames or not self._spans(0):
            return None
        window = np.array([raw for _, raw in self.window])
        return level_of(window) if is_still(window) else None

    def note_force(self, force_n: float) -> None:
        if self.now_s - self.loaded_s > SETTLE_S:
            self.largest_n = 0.0
        if force_n > max(LEAST_FORCE_N, RETURN_SHARE * self.largest_n):
            self.loaded_s = self.now_s
            self.largest_n = max(self.largest_n, force_n)

    def consider(self, level: Float[np.ndarray, "channel"], elapsed_s: float) -> None:
        """Move the zero to, or towards, a still level that is rest."""
        if self.level is None:
            self.start(level)
            return
        change = level - self.level
        still = self.read(change, len(self.window))
        pressed = still.contact >= 0.5 and still.explained is not False
        # the step to a press elsewhere is like the press that it replaces: cosine 0.7 of equal ones
        replaced = pressed and still.force_n > RETURN_SHARE * self._press_n
        let_go, self._held = not replaced and self._is_let_go(level), level
        if pressed and still.force_n > self._press_n:
            self._press_n, self._press = still.force_n, change
        if let_go:
            self.start(level)
            self.largest_n = 0.0
        elif not still.explained and self._is_from_press(change, still.force_n):
            self.start(level)
            self.largest_n, self.from_press = 0.0, True
        elif still.explained is False:
            return  # a magnet near by, or a wrong chip: neither rest nor a press
        elif self.largest_n >= PRESS_FORCE_N and still.force_n <= RETURN_SHARE * self.largest_n:
            # A window that a press begins in reads as less than the press: it is no return.
            if not self.window or self.loaded_s < self.window[0][0]:
                self.start(level)
        elif still.contact < 0.5 or still.force_n < LEAST_FORCE_N:
            self._follow(change, elapsed_s)

    def _is_let_go(self, level: Float[np.ndarray, "channel"]) -> bool:
        """Return whether the step from the still level before is all that pressed, turned round."""
        if self._held is None or self._press_n < PRESS_FORCE_N:
            return False
        step = self._held - level
        # cosine of the angle between both: a press that goes on, and drift, are not like it
        if step @ self._press < _LIKE * math.sqrt((step @ step) * (self._press @ self._press)):
            return False
        # what a reader has come to believe of magnets and chips while all drifted is no matter here
        return self.read(step, len(self.window)).force_n >= (1 - RETURN_SHARE) * self._press_n

    def _is_from_press(self, change: Float[np.ndarray, "channel"], force_n: float) -> bool:
        """Return whether the zero reads as a press, seen from a level of that force."""
        turned = self.read(-change, len(self.window))
        return turned.explained is not False and turned.force_n > max(PRESS_FORCE_N, 2 * force_n)

    def start(self, level: Float[np.ndarray, "channel"]) -> None:
        """Take a level for the zero, with nothing followed yet."""
        self.level, self._followed, self.rested_s = level, np.zeros(len(level)), self.now_s
        self.starts, self.from_press = self.starts + 1, False
        self._held, self._press_n = None, 0.0

    def _follow(self, change: Float[np.ndarray, "channel"], elapsed_s: float) -> None:
        """Go towards a level that is rest; back, where all that was followed lately is a press."""
        assert self.level is not None
        most = DRIFT_COUNTS_PER_S * min(elapsed_s, SETTLE_S)
        step = np.clip(change, -most, most)
        followed = self._remembered(min(elapsed_s, SETTLE_S)) + step
        if self.read_drift is not None:
            drift = self.read_drift(followed, len(self.window))
            if drift.contact >= 0.5 and drift.force_n >= LEAST_FORCE_N:
                self.level = self.level - self._followed
                self._followed = np.zeros(len(change))
                return
        self.level, self._followed, self.rested_s = self.level + step, followed, self.now_s

    def drift(self, change: Float[np.ndarray, "channel"], elapsed_s: float) -> None:
        """Move the zero by what drifted in that time while contacts were held: it counts as followed."""
        if self.level is not None:
            self.level, self._followed = self.level + change, self._remembered(elapsed_s) + change

    def _remembered(self, elapsed_s: float) -> np.ndarray:
        """Return what was followed lately and is not yet forgotten."""
        return math.exp(-elapsed_s / REMEMBERED_S) * self._followed


@dataclass
class StreamZero:
    """The zero of a stream in any mode: following rest, from `level` on if given, the mean of the first
    frames, or none."""

    mode: ZeroMode
    frames: int
    read: ReadStill
    read_drift: ReadStill | None = None
    level: Float[np.ndarray, "channel"] | None = None
    _rest: RestZero | None = None
    _zeroed_s: float = math.nan
    _now_s: float = math.nan
    _resting: list[np.ndarray] = field(default_factory=list)

    def __post_init__(self) -> None:
        if self.mode == "rest":
            self._rest = RestZero(self.frames, self.read, self.read_drift, self.level)

    def update(
        self, raw: Float[np.ndarray, "channel"], time_s: float
    ) -> Float[np.ndarray, "channel"] | None:
        """Take in a frame of raw counts and return the zero; None while there is none."""
        if self.mode == "none":
            return np.zeros(len(raw))
        if self._rest is not None:
            self._rest.update(raw, time_s)
            self.level = self._rest.level
            return self.level
        self._now_s = time_s
        if len(self._resting) < self.frames:
            self._resting.append(raw)
            self._zeroed_s = time_s
            return None
        self.level = level_of(np.array(self._resting))
        return self.level

    def move(self, change: Float[np.ndarray, "channel"]) -> bool:
        """Move a zero that follows rest by what rest has changed at once; False where it does not follow."""
        if self._rest is None or self._rest.level is None:
            return False
        self._rest.start(self._rest.level + change)
        self._rest.largest_n = 0.0  # forces read from what changed were of no press
        self.level = self._rest.level
        return True

    def drift(self, change: Float[np.ndarray, "channel"], elapsed_s: float) -> None:
        """Move a zero that follows rest by what channels drifted in that time while contacts were held."""
        if self._rest is not None:
            self._rest.drift(change, elapsed_s)
            self.level = self._rest.level

    def still_change(self, since_s: float) -> tuple[Float[np.ndarray, "channel"], int] | None:
        """Return the mean change of the window against a zero that follows rest, and its number of frames;
        None unless it is still and began within this time."""
        if self._rest is None or self.level is None:
            return None
        window, now_s = self._rest.window, self._rest.now_s
        if not window or window[0][0] < now_s - since_s:
            return None
        level = self._rest.still_level()
        return None if level is None else (level - self.level, len(window))

    @property
    def starts(self) -> int:
        """Return how many levels of rest were taken at once."""
        return self._rest.starts if self._rest else int(len(self._resting) == self.frames)

    @property
    def from_press(self) -> bool:
        """Return whether the last of these showed that the one before was taken in a press."""
        return self._rest is not None and self._rest.from_press

    @property
    def age_s(self) -> float:
        """Return the time since rest was last seen; 0 without a zero of its own, or without stamps."""
        if self._rest is not None:
            age = self._rest.now_s - self._rest.rested_s
        else:
            age = self._now_s - self._zeroed_s
        return age if math.isfinite(age) else 0.0

    def pass_by(self, raw: Float[np.ndarray, "channel"], time_s: float) -> None:
        """Take a frame that is not read itself; a zero that follows rest sees it."""
        if self._rest is not None:
            self._rest.pass_by(raw, time_s)


@runtime_checkable
class Zeroed(Protocol):
    """A reader with a zero of its own, which can be taken again or set."""

    @property
    def level(self) -> StreamZero: ...

    def rezero(self, level: Float[np.ndarray, "channel"] | None = None) -> None: ...


def read_through(
    count: int,
    read: Callable[[int], Any],
    reader: Zeroed,
    loaded: Bool[np.ndarray, "frame"] | None = None,
) -> tuple[list[Any], list[str]]:
    """Return what `read` finds in each frame of a file, and what is to be said of its zero.

    Frames read against a level that proves to be a press are read again, against the level of rest that
    showed it. Where load cells tell (`loaded`) that something pressed, no first level is taken.
    """
    results: list[Any] = []
    spans: list[
        tuple[int, np.ndarray]
    ] = []  # first frame and level of each zero that was taken at once
    corrected, starts, refused, texts = -1, 0, False, list[str]()
    while len(results) < count:
        number = len(results)
        results.append(read(number))
        zero = reader.level
        if zero.starts == starts or zero.level is None:
            continue
        pressed = loaded is not None and loaded[max(0, number + 1 - zero.frames) : number + 1].all()
        if not spans and corrected < 0 and pressed and zero.mode == "rest":
            refused, _ = True, results.pop()
            reader.rezero()
        elif (zero.from_press or (refused and not spans)) and number > corrected:
            begun = _taken_back(spans, zero.level, zero.read)
            texts.append(_not_at_rest_text(begun, number))
            results, corrected, starts, refused = results[:begun], number, 0, False
            spans.append((begun, zero.level))
            reader.rezero(zero.level)
        else:
            if pressed and zero.mode == "first":
                texts.append("load cells tell that something pressed in the first frames: no rest")
            spans.append((number if spans else 0, zero.level))
            starts = zero.starts
    if refused:
        texts.append("no still frames are at rest: in all of them a load cell is pressed")
    return results, texts


def _taken_back(
    spans: list[tuple[int, np.ndarray]], level: Float[np.ndarray, "channel"], read: ReadStill
) -> int:
    """Remove the last zero, and those before it that read as a press from a level of rest; return the
    frame from which they held."""
    begun = 0
    while spans:
        begun, _ = spans.pop()
        if not spans or not is_press_seen_from(level, spans[-1][1], read):
            break
    return begun


def is_press_seen_from(
    level: Float[np.ndarray, "channel"],
    doubted: Float[np.ndarray, "channel"],
    read: ReadStill,
) -> bool:
    """Return whether the doubted level reads as a press from a level, far more than turned round."""
    forward, back = read(doubted - level, 1), read(level - doubted, 1)
    return forward.explained is not False and forward.force_n > max(PRESS_FORCE_N, 2 * back.force_n)


def _not_at_rest_text(first: int, last: int) -> str:
    where = "the recording does not begin at rest" if first == 0 else f"frame {first} is no rest"
    return (
        f"{where}: frames {first} to {last} are read against the rest that follows them. Record some "
        "frames with nothing touching before the first press"
    )
