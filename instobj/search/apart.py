"""Work in a separate process: it can be given up after a time, and its crash is an answer too."""

from __future__ import annotations

import multiprocessing
import signal
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass, field
from multiprocessing.process import BaseProcess
from typing import Any

from design.errors import InputError
from instobj.store.progress import NEWS_EVERY_S

_CLOSING_S = 5.0


@dataclass(frozen=True)
class Scored:
    """What became of a trial: its polished variables, values to minimise and scores.

    `broken_mm` is 0 where every limit is kept; `misfit` says what else does not fit, or nothing;
    `scorings` are the layouts that were scored for it.
    """

    params: dict[str, Any]
    values: tuple[float, ...]
    scores: dict[str, float]
    broken_mm: float
    misfit: str
    scorings: int

    @property
    def feasible(self) -> bool:
        return self.broken_mm == 0 and not self.misfit


class GivenUp(Exception):
    """The work took too long, crashed or failed; says which."""


@dataclass
class Apart:
    """`prepare(argument)` gives the function that answers questions, over there.

    The process starts with the first question, and anew after one that was given up.
    """

    prepare: Callable[[Any], Callable[[Any], Any]]
    argument: Any
    _process: BaseProcess | None = field(default=None, init=False)
    _connection: Any = field(default=None, init=False)

    def ask(self, question: Any, seconds: float) -> Any:
        """The answer.

        Raises
        ------
        GivenUp
            No answer in that time, the process died, or an unforeseen error.
        InputError
            What the work itself refused.
        """
        connection = self._connected()
        try:
            connection.send(question)
            if not connection.poll(seconds):
                self.close()
                raise GivenUp(f"no result after {seconds:g} s")
            kind, answer = connection.recv()
        except (EOFError, BrokenPipeError, ConnectionResetError):
            code = self._exit_code()
            self.close()
            raise GivenUp(f"the process that worked on it died (exit code {code})") from None
        if kind == "refused":
            raise InputError(answer)
        if kind == "failed":
            raise GivenUp(answer)
        return answer

    def close(self) -> None:
        """End the process; the next question starts another."""
        process, connection = self._process, self._connection
        self._process = self._connection = None
        if connection is not None:
            connection.close()
        if process is not None:
            process.kill()
            process.join(_CLOSING_S)

    def _connected(self) -> Any:
        if self._connection is None:
            here, there = multiprocessing.Pipe()
            spawn = multiprocessing.get_context("spawn")
            self._process = spawn.Process(
                target=_serve, args=(there, self.prepare, self.argument), daemon=True
            )
            self._process.start()
            there.close()
            self._connection = here
        return self._connection

    def _exit_code(self) -> int | None:
        if self._process is None:
            return None
        self._process.join(_CLOSING_S)
        return self._process.exitcode


@contextmanager
def side_by_side(
    prepare: Callable[[Any], Callable[[Any], Any]],
    argument: Any,
    count: int,
    waiting: Callable[[int], None] = lambda questions: None,
) -> Iterator[Callable[[Sequence[Any], float], list[Any]]]:
    """A function that answers lists of questions by `count` processes, each with its share of a list.

    It raises as `Apart.ask`, once every process has answered or was given up; meanwhile, every few
    seconds, `waiting` gets the number of questions.
    """
    processes = [Apart(prepare, argument) for _ in range(count)]
    threads = ThreadPoolExecutor(count)

    def ask(questions: Sequence[Any], seconds: float) -> list[Any]:
        shares = [list(questions[k::count]) for k in range(min(count, len(questions)))]
        pairs = zip(processes, shares, strict=False)
        jobs = [threads.submit(one.ask, share, seconds) for one, share in pairs]
        while wait(jobs, NEWS_EVERY_S).not_done:
            waiting(len(questions))
        answers = [job.result() for job in jobs]
        return [answers[k % count][k // count] for k in range(len(questions))]

    try:
        yield ask
    finally:
        for one in processes:  # threads that still wait for an answer end with their process
            one.close()
        threads.shutdown()


def _serve(connection: Any, prepare: Callable[[Any], Any], argument: Any) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the terminal interrupts both; that side decides
    answer = None
    while True:
        try:
            question = connection.recv()
        except (EOFError, OSError):
            return
        try:
            answer = answer or prepare(argument)
            reply = ("answer", answer(question))
        except InputError as error:
            reply = ("refused", str(error))
        except Exception as error:
            reply = ("failed", f"{type(error).__name__}: {error}")
        try:
            connection.send(reply)
        except OSError:
            return
