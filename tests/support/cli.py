"""The command line as a user meets it: `run` in this process, `run_apart` in a separate one.

A separate process pays several seconds of imports: only tests of the process itself need it.
"""

import io
import os
import signal
import subprocess
import sys
import warnings
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

import pytest

from instobj.cli import app

ROOT = Path(__file__).parents[2]
CUBE = ROOT / "examples" / "paper_cube.toml"
INTERRUPTED = 130
"""Exit code after Ctrl-C, which ends the tests too."""

Done = subprocess.CompletedProcess[str]


def run(*arguments: str | Path | float, cwd: Path) -> Done:
    """Exit code, output and errors of `instobj arguments…` typed in the folder `cwd`."""
    words = ["instobj", *map(str, arguments)]
    output, errors = (io.TextIOWrapper(io.BytesIO(), "utf-8", write_through=True) for _ in "oe")
    on_interrupt = signal.getsignal(signal.SIGINT)
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(output), redirect_stderr(errors):
        patch.chdir(cwd)
        patch.setenv("COLUMNS", "200")
        patch.setattr(sys, "argv", words)
        patch.setattr(warnings, "formatwarning", warnings.formatwarning)  # put back at the end
        try:
            with pytest.raises(SystemExit) as ended:
                app.main()
        finally:
            signal.signal(signal.SIGINT, on_interrupt)
    if ended.value.code == INTERRUPTED:
        raise KeyboardInterrupt
    return Done(words, ended.value.code or 0, _text(output), _text(errors))


def _text(stream: io.TextIOWrapper) -> str:
    stream.seek(0)
    return stream.read()


def run_apart(*arguments: str | Path | float, cwd: Path) -> Done:
    """The same in a separate process."""
    return subprocess.run(
        [sys.executable, "-m", "instobj", *map(str, arguments)],
        capture_output=True,
        text=True,
        cwd=cwd,
        env=os.environ | {"COLUMNS": "200"},
        check=False,
    )


def assert_one_clear_error(done: Done, *words: str) -> None:
    assert done.returncode == 2
    assert "Traceback" not in done.stderr + done.stdout
    assert done.stderr.count("error:") == 1
    for word in words:
        assert word in done.stderr
