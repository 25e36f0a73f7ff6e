"""Reader of foreign surfaces that forks for each file: the imports of `design.solids.foreign` once.

A process of its own for each file takes 1 to 1.6 s of imports, a fork 10 ms. Limits of time and
memory, exit codes and messages are those of `design.processes.run_child`.
"""

import json
import os
import subprocess
import sys
import time
import traceback
from contextlib import contextmanager
from pathlib import Path

from design import processes
from design.solids import foreign


@contextmanager
def forking(sound):
    """A stand-in for `run_child`, warmed up with a sound file that is read once."""
    server = subprocess.Popen(
        [sys.executable, "-m", "tests.support.forked_reader", str(sound)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )

    def run_child(arguments, folder, seconds, memory_gib=None):
        *_, source, target = arguments
        said = Path(folder) / "said"
        request = [source, target, str(said), seconds, memory_gib]
        server.stdin.write(json.dumps(request) + "\n")
        server.stdin.flush()
        code = json.loads(server.stdout.readline())
        if code is None:
            raise processes.ChildTooSlow(f"it did not end within {seconds:g} s")
        if code:
            text = said.read_text(errors="replace")
            raise processes.ChildFailed(processes.reason_of(code, text, memory_gib))

    try:
        yield run_child
    finally:
        server.stdin.close()
        server.wait()


def said_in_fork(work, seconds):
    """The text that `work` returns, or None. A loop in C, which no signal of Python ends, is a text."""
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        try:
            os.write(writing, (work() or "").encode()[:9999])
            os._exit(0)
        finally:
            os._exit(1)
    os.close(writing)
    code = _code(child, seconds)
    with os.fdopen(reading) as said:
        text = said.read()
    if code is None:
        return f"it did not end within {seconds:g} s"
    return f"exit code {code}" if code else text or None


def serve(sound):
    """Answer each request, a line of JSON, with the exit code of a fork; null if it took too long."""
    foreign.main(sound, os.devnull)
    for line in sys.stdin:
        source, target, said, seconds, memory_gib = json.loads(line)
        child = os.fork()
        if not child:
            _read(source, target, said)
        processes.limit_memory(child, memory_gib)
        print(json.dumps(_code(child, seconds)), flush=True)


def _read(source, target, said):
    code = 1
    try:
        sys.stdin.close()
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        os.dup2(os.open(said, os.O_WRONLY | os.O_CREAT), 2)
        code = foreign.main(source, target)
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stderr.flush()
        os._exit(code)


def _code(child, seconds):
    late = time.monotonic() + seconds
    while True:
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            return os.waitstatus_to_exitcode(status)
        if time.monotonic() > late:
            os.kill(child, 9)
            os.waitpid(child, 0)
            return None
        time.sleep(0.002)


if __name__ == "__main__":
    serve(sys.argv[1])
