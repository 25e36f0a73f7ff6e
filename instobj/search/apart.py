"""Work in a separate process: it can be given up after a time, and its crash is an answer too."""

from __future__ import annotations

import multiprocessing
import signal
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass, field
from multiprocessing.process import BaseProcess
from queue import SimpleQueue
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
    waiting: Callable[[int], None] = lambda parts: None,
) -> Iterator[Callable[[Sequence[Sequence[Any]], float], list[Any]]]:
    """A function that answers questions of several parts by `count` processes, each whichever is free next.

    It gives an answer to each, or the error of `Apart.ask` in its place; meanwhile, every few seconds,
    `waiting` gets the number of parts of all questions. Each may take the seconds that it is given.
    """
    processes = [Apart(prepare, argument) for _ in range(count)]
    free: SimpleQueue[Apart] = SimpleQueue()
    for one in processes:
        free.put(one)
    threads = ThreadPoolExecutor(count)

    def answer(question: Sequence[Any], seconds: float) -> Any:
        one = free.get()
        try:
            return one.ask(question, seconds)
        except (GivenUp, InputError) as error:
            return error
        finally:
            free.put(one)

    def ask(questions: Sequence[Sequence[Any]], seconds: float) -> list[Any]:
        jobs = [threads.submit(answer, question, seconds) for question in questions]
        while wait(jobs, NEWS_EVERY_S).not_done:
            waiting(sum(map(len, questions)))
        return [job.result() for job in jobs]

    try:
        yield ask
    finally:
        threads.shutdown(wait=False, cancel_futures=True)
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
