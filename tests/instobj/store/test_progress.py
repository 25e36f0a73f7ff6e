"""Progress in a log: a line stays a line, however long it is."""

import io

from rich.console import Console

from instobj.store.progress import ProgressLine


def test_a_long_step_is_one_line_in_a_log():
    written = io.StringIO()
    progress = ProgressLine(Console(file=written, width=80, highlight=False))
    with progress.stage("mechanics: response on a coarser mesh"):
        progress.step("assembling, factoring and condensing the matrix of all loads")
    (line,) = written.getvalue().splitlines()
    assert line.endswith("all loads (0 s)")
