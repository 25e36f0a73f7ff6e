"""Work in a separate process: it can be given up after a time, and its crash is an answer too."""

from __future__ import annotations

import multiprocessing
import signal
import threading
import time
from collections.abc import Callable, Iterator, Sequence, Sized
from concurrent.futures import ThreadPoolExecutor, wait
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from functools import lru_cache
from multiprocessing.process import BaseProcess
from typing import Any

from design.errors import InputError
from instobj.stages.workers import OnDask, Workers
from instobj.store.progress import NEWS_EVERY_S

_CLOSING_S = 5.0
"""Time that a worker gets to end by itself."""
Prepare = Callable[[Any], Callable[[Any], Any]]


class WorkerTimeout(Exception):
    """The work took too long, crashed or failed; says which."""


@dataclass
class WorkerProcess:
    """`prepare(argument)` gives the function that answers questions, over there.

    The process starts with the first question, and again after one that was given up.
    """

    prepare: Prepare
    argument: Any
    _process: BaseProcess | None = field(default=None, init=False)
    _connection: Any = field(default=None, init=False)
    _changing: Any = field(default_factory=threading.Lock, init=False)
    """Held while the process starts or ends: another thread may close what this one just starts."""

    def ask(self, question: Any, seconds: float) -> Any:
        """The answer.

        Raises
        ------
        WorkerTimeout
            No answer in that time, the process died, or an unforeseen error.
        InputError
            What the work itself refused.
        """
        connection = self._connected()
        try:
            connection.send(question)
            if not connection.poll(seconds):
                self.close()
                raise WorkerTimeout(f"no result after {seconds:g} s")
            kind, answer = connection.recv()
        except (EOFError, BrokenPipeError, ConnectionResetError):
            code = self._exit_code()
            self.close()
            raise WorkerTimeout(f"the process that worked on it died (exit code {code})") from None
        if kind == "refused":
            raise InputError(answer)
        if kind == "failed":
            raise WorkerTimeout(answer)
        return answer

    def close(self) -> None:
        """End the process; the next question starts another."""
        with self._changing:
            process, connection = self._process, self._connection
            self._process = self._connection = None
        if connection is not None:
            connection.close()
        if process is not None:
            process.kill()
            process.join(_CLOSING_S)

    def _connected(self) -> Any:
        with self._changing:
            if self._connection is None:
                own_end, worker_end = multiprocessing.Pipe()
                spawn = multiprocessing.get_context("spawn")
                self._process = spawn.Process(
                    target=_serve, args=(worker_end, self.prepare, self.argument), daemon=True
                )
                self._process.start()
                worker_end.close()
                self._connection = own_end
            return self._connection

    def _exit_code(self) -> int | None:
        if self._process is None:
            return None
        self._process.join(_CLOSING_S)
        return self._process.exitcode


Ask = Callable[[Sequence[Sized], float], list[Any]]


@contextmanager
def answers(
    prepare: Prepare,
    argument: Any,
    workers: Workers,
    waiting: Callable[[int], None] = lambda parts: None,
) -> Iterator[Ask]:
    """A function that answers questions of several parts, by a separate process or by Dask's workers.

    It gives an answer to each, or in its place `WorkerTimeout` or `InputError`; meanwhile, every few seconds,
    `waiting` gets the number of parts of all questions. Each may take the seconds that it is given, and is
    asked again where its worker was lost.
    """
    if isinstance(workers, OnDask):
        yield lambda questions, seconds: _ClusterQuestions(
            prepare, argument, workers, waiting
        ).answers(questions, seconds)
        return
    process = WorkerProcess(prepare, argument)
    with ThreadPoolExecutor(1) as thread:
        try:
            yield lambda questions, seconds: _answer_in_turn(
                process, thread, questions, seconds, waiting
            )
        finally:
            thread.shutdown(wait=False, cancel_futures=True)
            process.close()  # the thread, where it still waits for an answer, ends with it


def _answer_in_turn(
    process: WorkerProcess,
    thread: ThreadPoolExecutor,
    questions: Sequence[Sized],
    seconds: float,
    waiting: Callable[[int], None],
) -> list[Any]:
    def answer(question: Sized) -> Any:
        try:
            return process.ask(question, seconds)
        except (WorkerTimeout, InputError) as error:
            return error

    jobs = [thread.submit(answer, question) for question in questions]
    while wait(jobs, NEWS_EVERY_S).not_done:
        waiting(sum(map(len, questions)))
    return [job.result() for job in jobs]


@dataclass
class _ClusterQuestions:
    """Questions to Dask's workers, as many at a time as there are."""

    prepare: Prepare
    argument: Any
    workers: OnDask
    waiting: Callable[[int], None]

    def answers(self, questions: Sequence[Sized], seconds: float) -> list[Any]:
        from distributed import wait as wait_for

        answers_by_index: dict[int, Any] = {}
        waiting_questions = dict(enumerate(questions))
        at_work: dict[Any, tuple[int, float]] = {}
        while waiting_questions or at_work:
            while waiting_questions and len(at_work) < self.workers.count:
                index = next(iter(waiting_questions))
                future = self.workers.client.submit(
                    _answered, self.prepare, self.argument, waiting_questions.pop(index), pure=False
                )
                at_work[future] = index, time.monotonic() + seconds
            with suppress(TimeoutError):
                wait_for(list(at_work), timeout=NEWS_EVERY_S, return_when="FIRST_COMPLETED")
            for future, (index, ends) in list(at_work.items()):
                if future.done():
                    answers_by_index[index] = _answer_of(future)
                elif time.monotonic() > ends:
                    self._give_up(future)
                    answers_by_index[index] = WorkerTimeout(f"no result after {seconds:g} s")
                if index in answers_by_index:
                    del at_work[future]
            if at_work:
                self.waiting(sum(map(len, questions)))
        return [answers_by_index[index] for index in range(len(questions))]

    def _give_up(self, future: Any) -> None:
        """End the process that is at it; its nanny starts another."""
        client = self.workers.client
        work_by_address: Any = client.processing()
        client.cancel(future)
        address = [worker for worker, keys in work_by_address.items() if future.key in keys]
        client.restart_workers(address, raise_for_error=False)


def _answered(prepare: Prepare, argument: Any, question: Any) -> Any:
    return _prepared(prepare, argument)(question)


@lru_cache(maxsize=1)
def _prepared(prepare: Prepare, argument: Any) -> Callable[[Any], Any]:
    """Return this process's function: mechanics are read once."""
    return prepare(argument)


def _answer_of(future: Any) -> Any:
    if future.cancelled():
        return WorkerTimeout("it was cancelled")
    error = future.exception()
    if error is None:
        return future.result()
    if isinstance(error, InputError):
        return error
    return WorkerTimeout(f"{type(error).__name__}: {error}")


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
