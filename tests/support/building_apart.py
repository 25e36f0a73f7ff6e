"""Work in a process of its own, so that a crash or a hang in a kernel fails one test and is told.

A signal cannot stop a C++ kernel that hangs, and a crash takes its process along.
"""

from __future__ import annotations

import json
import multiprocessing as mp
import os
import time
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any

Work = Callable[[dict[str, Any]], dict[str, Any]]


class Apart:
    """A worker that answers tables with tables, one after the other."""

    def __init__(self, work: Work) -> None:
        self._work = work
        self._start()

    def _start(self) -> None:
        context = mp.get_context("spawn")
        self._answers, theirs = context.Pipe()
        self._process = context.Process(target=_serve, args=(theirs, self._work), daemon=True)
        self._process.start()
        theirs.close()

    def ask(self, content: dict[str, Any], seconds: float) -> dict[str, Any]:
        """The answer; AssertionError, with what was asked, on a crash, a hang or an exception."""
        text = json.dumps(content)
        try:
            self._answers.send_bytes(text.encode())
            if not self._answers.poll(seconds):
                raise AssertionError(self._given_up(f"no answer within {seconds:g} s", text))
            answer = json.loads(self._answers.recv_bytes())
        except (EOFError, OSError) as error:
            raise AssertionError(self._given_up("the process died", text)) from error
        assert "error" not in answer, f"{answer['error']}: {text}"
        return answer

    def _given_up(self, what: str, text: str) -> str:
        self.close()
        code = self._process.exitcode
        self._start()
        return f"{what} (exit code {code}): {text}"

    def close(self) -> None:
        self._process.kill()
        self._process.join()
        self._answers.close()


def _serve(questions: Connection, work: Work) -> None:
    while True:
        try:
            content = json.loads(questions.recv_bytes())
        except EOFError:
            return
        try:
            answer = work(content)
        except Exception as error:
            answer = {"error": f"{type(error).__name__}: {error}"}
        questions.send_bytes(json.dumps(answer).encode())


def misbehave(content: dict[str, Any]) -> dict[str, Any]:
    """What a kernel may do; only for the tests of this module."""
    if content["do"] == "hang":
        time.sleep(60)
    if content["do"] == "crash":
        os.abort()
    return {"did": content["do"], "raised": 1 / content.get("divide_by", 1)}
