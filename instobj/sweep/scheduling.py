"""Tasks of a sweep carried out: one after the other here, or by the workers of Dask distributed."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.errors import InputError
from design.processes import machine_memory_gib
from instobj.sweep.tasks import StageTask, work

if TYPE_CHECKING:
    from distributed import Client

Say = Callable[[str], None]
Done = dict[str, dict[str, Any]]
"""By the task's key: the key of its result in the store, or the error."""
MEMORY = "instobj_gib"
"""What workers of a sweep offer and stages ask for, as one of Dask's resources."""
_RETRIES = 3
_MOST_SILENT_S = 5.0
_ANSWER_S = 10.0
_ONE_THREAD = {"OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


def run_here(tasks: Mapping[str, StageTask], root: Path, say: Say) -> Done:
    """One task after the other in this process."""
    done: Done = {}
    progress = _Progress(len(tasks), say)
    for key, task in tasks.items():
        done[key] = work(task.content, [done[need] for need in task.needs], str(root))
        progress.finished(task, done[key])
    return done


def run_on_dask(
    tasks: Mapping[str, StageTask], root: Path, say: Say, workers: int, scheduler: str | None
) -> Done:
    """Tasks on `workers` local processes, or on the workers of the scheduler at an address.

    A stage of a worker that was lost is made again, elsewhere. Workers must see the store at the
    same path; each has one thread. A stage waits for a worker with the memory that it takes: those
    of a scheduler say what they have by `--resources "instobj_gib=16"`, or are not asked.

    Raises
    ------
    InputError
        Dask is not installed, the scheduler does not answer, or no worker has the memory.
    """
    progress = _Progress(len(tasks), say)
    with _client(workers, scheduler) as client:
        from distributed import as_completed

        counted = _require_memory(client, tasks)
        futures: dict[str, Any] = {}
        for key, task in tasks.items():
            futures[key] = client.submit(
                work,
                task.content,
                [futures[need] for need in task.needs],
                str(root),
                key=f"{task.stage}-{key[:16]}",
                resources={MEMORY: task.gib} if counted and task.gib else None,
                retries=_RETRIES,
            )
        names = {future.key: key for key, future in futures.items()}
        done: Done = {}
        for future in as_completed(futures.values()):
            key = names[future.key]
            done[key] = _outcome(future)
            progress.finished(tasks[key], done[key])
    return done


def _outcome(future: Any) -> dict[str, Any]:
    """Of a finished future; of one whose workers all died, why."""
    error = future.exception()
    if error is None:
        return future.result()
    return {"key": "", "error": f"{future.key}: {error}"}


@contextmanager
def _client(workers: int, scheduler: str | None) -> Iterator[Client]:
    try:
        from distributed import Client, LocalCluster
    except ImportError:
        raise InputError(
            "several workers need Dask, which is not installed. Install instobj[dask], or leave "
            "--workers and --scheduler out"
        ) from None
    if scheduler is not None:
        try:
            client = Client(scheduler, timeout=_ANSWER_S)
        except (OSError, ValueError) as error:
            raise InputError(
                f"no Dask scheduler answers at {scheduler} ({error}). Start one with `dask scheduler`"
            ) from None
        with client:
            yield client
        return
    have = machine_memory_gib()
    with (
        LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            host="127.0.0.1",
            dashboard_address=None,  # pyright: ignore[reportArgumentType]: its own documented way
            env=_ONE_THREAD,
            memory_limit=0,
            silence_logs=50,
            resources={MEMORY: have / workers} if have else None,
        ) as cluster,
        Client(cluster) as client,
    ):
        yield client


def _require_memory(client: Client, tasks: Mapping[str, StageTask]) -> bool:
    """Whether workers say what memory they have; refuse a task that none could ever take."""
    found = client.scheduler_info(n_workers=-1)["workers"].values()
    if not found:
        raise InputError("the scheduler has no workers. Start some with `dask worker ADDRESS`")
    offers = [worker["resources"].get(MEMORY) for worker in found]
    if None in offers:
        return False
    largest = max(tasks.values(), key=lambda task: task.gib)
    if largest.gib > max(offers):
        raise InputError(
            f"the stage {largest.stage} of {largest.spec.name} needs about {largest.gib:.3g} GiB of "
            f"memory; each worker has {max(offers):.3g}. Use fewer workers, or larger machines"
        )
    return True


class _Progress:
    """Says how far a sweep is, at most every few seconds, and each failure."""

    def __init__(self, count: int, say: Say) -> None:
        self._count, self._say = count, say
        self._began = self._said = time.monotonic()
        self._finished = 0

    def finished(self, task: StageTask, outcome: dict[str, Any]) -> None:
        self._finished += 1
        if outcome["error"]:
            self._say(f"{task.spec.name}: {outcome['error']}")
        now = time.monotonic()
        if now - self._said < _MOST_SILENT_S and self._finished < self._count:
            return
        self._said = now
        left = (now - self._began) / self._finished * (self._count - self._finished)
        self._say(f"{self._finished} of {self._count} stages, about {left:.0f} s left")
