"""Workers that make stages: this process, processes of this machine, or those of a Dask scheduler."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.errors import InputError
from design.processes import ONE_THREAD, machine_memory_gib
from instobj.stages.tasks import StageTask, work
from instobj.store.content import StoredResult
from instobj.store.progress import NEWS_EVERY_S, ProgressLine

if TYPE_CHECKING:
    from distributed import Client

Say = Callable[[str], None]
Done = dict[str, dict[str, Any]]
"""Outcomes by the task's key: the key of its result in the store, or the error."""
MEMORY = "instobj_gib"
"""Memory that workers offer and stages ask for, as one of Dask's resources."""
_RETRIES = 3
_BETWEEN_LOOKS_S = 0.05
ANSWER_S = 10.0
_LEAN = {
    "distributed.nanny.pre-spawn-environ": ONE_THREAD
    | {"MALLOC_ARENA_MAX": "1", "MALLOC_MMAP_MAX_": "0", "MALLOC_TRIM_THRESHOLD_": str(2**33)},
    "distributed.worker.profile.enabled": False,
}
"""Processes keep memory that is freed, which Dask has glibc give back at once, and so do threads of glibc
of their own accord, where tasks run: all share the first thread's. Nobody reads the profiles that Dask
samples. Two processes take a fifth less time for a sweep of paper's cubes."""


@contextmanager
def open_workers(
    count: int = 1, scheduler: str | None = None, progress: ProgressLine | None = None
) -> Iterator[Workers]:
    """This process; or `count` processes of this machine, or the workers of the scheduler at an address.

    `progress` shows the steps of stages made in this process, and which stages others are at.

    Raises
    ------
    InputError
        Dask is not installed, or the scheduler does not answer.
    """
    if count == 1 and scheduler is None:
        yield Here(progress)
        return
    with _client(count, scheduler) as client:
        yield OnDask(client, progress)


@dataclass(frozen=True)
class Here:
    """One task after the other in this process."""

    progress: ProgressLine | None = None

    @property
    def count(self) -> int:
        """Return how many tasks are worked on at a time."""
        return 1

    def make(
        self,
        tasks: Mapping[str, StageTask],
        root: Path,
        say: Say,
        enough: Callable[[], bool] = lambda: False,
    ) -> Done:
        """Make every task once, after the tasks that it needs, in the store at `root`.

        Once `enough`, no further task is begun; those are not among what is done.
        """
        done: Done = {}
        known_results: dict[str, StoredResult] = {}
        counted = WorkersProgress(len(tasks), say)
        for key, task in tasks.items():
            if enough():
                break
            outcomes_before = [done[need] for need in task.needs]
            done[key] = work(task.content, outcomes_before, str(root), self.progress, known_results)
            counted.finished(task, done[key])
        return done


@dataclass(frozen=True)
class OnDask:
    """The workers of a Dask scheduler.

    A stage of a worker that was lost is made again, elsewhere. Workers must see the store at the
    same path; each has one thread. A stage waits for a worker with the memory that it takes: those
    of a scheduler say what they have by `--resources "instobj_gib=16"`, or are not asked.
    """

    client: Client
    progress: ProgressLine | None = None

    @property
    def count(self) -> int:
        return max(1, len(self.client.scheduler_info(n_workers=-1)["workers"]))

    def make(
        self,
        tasks: Mapping[str, StageTask],
        root: Path,
        say: Say,
        enough: Callable[[], bool] = lambda: False,
    ) -> Done:
        """Make tasks as `Here.make` does.

        Raises
        ------
        InputError
            The scheduler has no workers, or none with the memory that a task takes.
        """
        if not tasks:
            return {}
        progress = WorkersProgress(len(tasks), say)
        counted = _require_memory(self.client, tasks)
        futures: dict[str, Any] = {}
        for place, (key, task) in enumerate(tasks.items()):
            futures[key] = self.client.submit(
                work,
                task.content,
                [futures[need] for need in task.needs],
                str(root),
                key=f"{task.stage}-{key[:16]}",
                resources={MEMORY: task.gib} if counted and task.gib else None,
                retries=_RETRIES,
                priority=-place,
            )
        names = {future.key: key for key, future in futures.items()}
        done: Done = {}
        step = self.progress.step if self.progress else say
        for future in self._finished(futures, lambda count: progress.waiting(count, step)):
            key = names[future.key]
            if future.cancelled():
                continue
            done[key] = _outcome(future)
            progress.finished(tasks[key], done[key])
            if enough():
                self.client.cancel([f for key, f in futures.items() if key not in done])
        return done

    def _finished(
        self, futures: Mapping[str, Any], waiting: Callable[[list[str]], None]
    ) -> Iterator[Any]:
        """Futures as they finish; meanwhile, every few seconds, the keys of those at work."""
        from distributed import as_completed

        completed, heard = as_completed(futures.values()), time.monotonic()
        while not completed.is_empty():
            if completed.has_ready():
                yield next(completed)
                heard = time.monotonic()
            elif time.monotonic() - heard > NEWS_EVERY_S:
                at_work: Any = self.client.processing()
                waiting([str(key) for keys in at_work.values() for key in keys])
                heard = time.monotonic()
            else:
                time.sleep(_BETWEEN_LOOKS_S)


Workers = Here | OnDask
"""Workers that carry tasks out."""


def _outcome(future: Any) -> dict[str, Any]:
    """Outcome of a finished future; of one whose workers all died, why."""
    error = future.exception()
    if error is None:
        return future.result()
    return {"key": "", "error": f"{future.key}: {error}"}


@contextmanager
def _client(workers: int, scheduler: str | None) -> Iterator[Client]:
    from dask import config
    from distributed import Client, LocalCluster

    if scheduler is not None:
        try:
            client = Client(scheduler, timeout=ANSWER_S)
        except (OSError, ValueError) as error:
            raise InputError(
                f"no Dask scheduler answers at {scheduler} ({error}). Start one with `dask scheduler`"
            ) from None
        with client:
            yield client
        return
    have = machine_memory_gib()
    with (
        config.set(_LEAN),
        LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            host="127.0.0.1",
            dashboard_address=None,  # pyright: ignore[reportArgumentType]: its own documented way
            memory_limit=0,
            silence_logs=50,
            resources={MEMORY: have / workers} if have else None,
        ) as cluster,
        Client(cluster) as client,
    ):
        yield client


def _require_memory(client: Client, tasks: Mapping[str, StageTask]) -> bool:
    """Return whether workers say what memory they have; refuse a task that none could ever take."""
    workers = client.scheduler_info(n_workers=-1)["workers"].values()
    if not workers:
        raise InputError("the scheduler has no workers. Start some with `dask worker ADDRESS`")
    offers = [worker["resources"].get(MEMORY) for worker in workers]
    if None in offers:
        return False
    largest = max(tasks.values(), key=lambda task: task.gib)
    if largest.gib > max(offers):
        raise InputError(
            f"the stage {largest.stage} of {largest.spec.name} needs about {largest.gib:.3g} GiB of "
            f"memory; each worker has {max(offers):.3g}. Use fewer workers, or larger machines"
        )
    return True


_QUIET_SHARE = 0.5
"""Share of the time since the start that passes between two lines on how far a run is."""


class WorkersProgress:
    """Says how many stages are made, ever more seldom, and each failure."""

    def __init__(self, count: int, say: Say) -> None:
        self._count, self._say = count, say
        self._began = self._said = time.monotonic()
        self._finished = 0

    def waiting(self, at_work: Sequence[str], step: Say) -> None:
        """Tell which stages are being made, counted by their kind."""
        kinds = Counter(key.rsplit("-", 1)[0] for key in at_work)
        names = ", ".join(f"{kind} × {n}" if n > 1 else kind for kind, n in kinds.items())
        step(f"{self._finished} of {self._count} stages; at work or next: {names or 'nothing yet'}")

    def finished(self, task: StageTask, outcome: dict[str, Any]) -> None:
        self._finished += 1
        if outcome["error"]:
            self._say(f"{task.spec.name}: {outcome['error']}")
        now = time.monotonic()
        # after half of the time so far: a run of any length says some ten times how far it is
        quiet_s = max(NEWS_EVERY_S, _QUIET_SHARE * (now - self._began))
        if now - self._said < quiet_s and self._finished < self._count:
            return
        self._said = now
        seconds_left = (now - self._began) / self._finished * (self._count - self._finished)
        self._say(f"{self._finished} of {self._count} stages, about {seconds_left:.0f} s left")
