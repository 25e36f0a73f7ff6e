"""Sources of a bring-up's answers: a board with its user, a file, a simulated object."""

from __future__ import annotations

import sys
from collections.abc import Generator, Iterator
from dataclasses import dataclass, field, replace
from typing import Protocol

import numpy as np

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.calibration.resting import channel_names
from estimator.recordings.boards.lines import Frame, Header, LineDecoder, Message, Status
from estimator.recordings.boards.link import board_messages
from estimator.signals.hall import LARGEST_COUNT
from instobj.bench.bringup.asking.asked import Question, Recording
from instobj.bench.bringup.journal import Journal
from instobj.bench.bringup.simulated import SimulatedObject
from instobj.bench.collect.options import TypedLines

KEEP, SKIP, QUIT = "k", "s", "q"
_STALE_FRAMES = 2
"""Frames on their way when the user answers."""


class Source(Protocol):
    """Answers questions and records; `None` where a file holds no such recording."""

    def answer(self, question: str, allowed: str) -> str:
        """One of the letters of `allowed`, or nothing for "done as asked"."""
        ...

    def record(self, question: Question) -> Recording | None:
        """The frames that follow."""
        ...


class _Nobody:
    """A user who does as asked and keeps whatever was found."""

    def answer(self, question: str, allowed: str) -> str:
        """Nothing, or to keep what was found."""
        del question
        return KEEP if KEEP in allowed else ""


@dataclass
class FromFile(_Nobody):
    """Recordings of an earlier bring-up; whatever was found is kept as it is."""

    journal: Journal

    def record(self, question: Question) -> Recording | None:
        """That recording, where the file holds it."""
        return self.journal.recordings.get(question.name)


@dataclass
class Simulated(_Nobody):
    """A simulated object whose user does as asked and keeps every fault."""

    made: SimulatedObject

    def record(self, question: Question) -> Recording:
        """Return what the simulated board sends."""
        return self.made.recording(question)


@dataclass
class Board:
    """A board on a port, and a user at the keyboard; the line is read while the user acts."""

    spec: ObjectSpec
    chunks: Generator[bytes]
    port: str
    decoder: LineDecoder = field(default_factory=LineDecoder)
    typed: TypedLines = field(default_factory=TypedLines)
    columns: dict[int, int] = field(default_factory=dict)
    bus_errors: int | None = None
    waiting: list[str] = field(default_factory=list)
    _messages: Iterator[list[Message]] | None = None

    def answer(self, question: str, allowed: str) -> str:
        """Wait for a line; anything that is not allowed is reported and asked again.

        Raises
        ------
        InputError
            The board broke off, or standard input ended before the answer.
        """
        sys.stderr.write(f"{question}\n> ")
        sys.stderr.flush()
        for _ in self._listen():
            self.waiting += self.typed.poll()
            while self.waiting:
                line = self.waiting.pop(0).lower()
                if line == "" or (len(line) == 1 and line in allowed):
                    return line
                letters = ", ".join(allowed)
                sys.stderr.write(f"{line[:40]!r} is no answer. Press Enter, or type {letters}\n> ")
                sys.stderr.flush()
            if self.typed.ended:
                break
        raise InputError("standard input ended before the answer. Repeat the command to go on")

    def record(self, question: Question) -> Recording:
        """The next frames of the board.

        Raises
        ------
        InputError
            The board broke off, names channels of another object, or sends counts beyond 16 bits.
        """
        frames: list[Frame] = []
        damaged, errors = self.decoder.statistics.damaged_lines, self.bus_errors
        for messages in self._listen():
            frames += [message for message in messages if isinstance(message, Frame)]
            if len(frames) >= question.frames + _STALE_FRAMES:
                break
        frames = frames[_STALE_FRAMES : _STALE_FRAMES + question.frames]
        recording = self._recording(question, frames)
        return replace(
            recording,
            damaged_lines=self.decoder.statistics.damaged_lines - damaged,
            bus_errors=None if self.bus_errors is None else self.bus_errors - (errors or 0),
        )

    def _listen(self) -> Iterator[list[Message]]:
        if self._messages is None:
            self._messages = board_messages(self.chunks, self.decoder, self.port)
        for messages in self._messages:
            for message in messages:
                if isinstance(message, Header):
                    self.columns = self._columns(message.channels)
                elif isinstance(message, Status):
                    self.bus_errors = message.bus_errors
            yield messages

    def _columns(self, channels: tuple[str, ...]) -> dict[int, int]:
        """Column of the board → channel of the specification."""
        column_of_name = {name: k for k, name in enumerate(channel_names(self.spec))}
        foreign = [name for name in channels if name not in column_of_name]
        if foreign:
            raise InputError(
                f"{self.port} sends {', '.join(foreign[:4])}, which {self.spec.name} has not: the board "
                "of another object? Connect the right one, or build its firmware anew"
            )
        return {column: column_of_name[name] for column, name in enumerate(channels)}

    def _recording(self, question: Question, frames: list[Frame]) -> Recording:
        counts = np.full((len(frames), len(channel_names(self.spec))), np.nan)
        values = np.array([frame.counts for frame in frames], float)
        counts[:, list(self.columns.values())] = values[:, list(self.columns)]
        if np.nanmax(abs(counts), initial=0.0) > LARGEST_COUNT + 1:
            row, column = np.argwhere(abs(counts) > LARGEST_COUNT + 1)[0]
            raise InputError(
                f"{self.port} sends {counts[row, column]:.0f} counts for "
                f"{channel_names(self.spec)[column]}; chips of 16 bits send ±{LARGEST_COUNT + 1} at most. "
                "Check the board's firmware"
            )
        return Recording(
            question.name,
            counts.reshape(len(frames), -1, 3),
            np.array([frame.sequence for frame in frames]),
            np.array([frame.board_ms for frame in frames]),
        )
