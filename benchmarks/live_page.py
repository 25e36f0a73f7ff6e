"""The live page for a minute: pictures per second, their age, and what they cost.

`instobj bench live --demo` and a headless Chromium with WebGL by software run on this machine; the page
measures pictures and ages itself, processor times are the system's. Linux only.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from pathlib import Path

from harness import Result, conclude, machine, option_parser

sys.path.insert(0, str(Path(__file__).parents[1]))
from tests.support.browser import Browser

SIZE = (1280, 800)
WARM_S, MEASURED_S, QUICK_S = 20.0, 60.0, 5.0
_TICKS = os.sysconf("SC_CLK_TCK")


def processor_seconds(root: int) -> dict[str, float]:
    """Processor time of a process and all below it, by what they are."""
    parents, times, names = {}, {}, {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            stat = (folder / "stat").read_text().rpartition(")")[2].split()
            line = (folder / "cmdline").read_bytes().decode(errors="replace")
        except OSError:
            continue
        number = int(folder.name)
        parents[number], times[number] = int(stat[1]), (int(stat[11]) + int(stat[12])) / _TICKS
        kind = re.search(r"--type=([a-z-]+)", line)
        names[number] = kind[1] if kind else "main"
    found: dict[str, float] = {}
    for number, seconds in times.items():
        above = number
        while above not in (root, 0):
            above = parents.get(above, 0)
        if above == root:
            found[names[number]] = found.get(names[number], 0.0) + seconds
    return found


def start_demo() -> tuple[subprocess.Popen[str], str]:
    """The demo, and the address of its page."""
    command = [sys.executable, "-m", "instobj", "bench", "live", "--demo", "--page", "0"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    assert process.stderr is not None
    for line in process.stderr:
        if found := re.search(r"open (http://127\.0\.0\.1:\d+/)", line):
            return process, found[1]
    raise RuntimeError("the demo did not start")


def measured(page: Browser, demo: int, seconds: float) -> Result:
    """Return what the page tells of that time, and processor times in ms per picture."""
    roots = {"server": demo, "browser": page.process.pid}
    before = {name: processor_seconds(root) for name, root in roots.items()}
    drawn = page.ask("instobjLive.figures().objectDrawn")
    page.ask("instobjLive.forget()")
    time.sleep(seconds)
    figures = page.ask("instobjLive.figures()")
    after = {name: processor_seconds(root) for name, root in roots.items()}
    shown = max(1, figures["shown"])
    return figures | {
        "seconds": seconds,
        "drawn_before": drawn,
        "pictures_per_second": round(figures["shown"] / seconds, 2),
        "processor_ms_per_picture": {
            f"{name}, {kind}": round(1000 * (spent - before[name].get(kind, 0.0)) / shown, 2)
            for name, kinds in after.items()
            for kind, spent in kinds.items()
        },
        "load_average": os.getloadavg()[0],
    }


def report(result: Result) -> str:
    """A few lines for each state of the page."""
    lines = []
    for name, one in result["states"].items():
        ages = ", ".join(f"{one['latencyMs'][key]:.0f}" for key in ("p50", "p90", "p99"))
        times = [f"{who} {ms:.1f}" for who, ms in one["processor_ms_per_picture"].items()]
        lines += [
            f"{name}: {one['pictures_per_second']:.0f} pictures/s, ages (median, 90, 99 %) {ages} ms, the "
            f"object drawn {one['objectDrawn'] - one['drawn_before']} times, load {one['load_average']:.1f}",
            f"  processor time, ms a picture: {'; '.join(times)}",
        ]
    return "\n".join(lines)


def turned(page: Browser, demo: int, seconds: float) -> Result:
    """The same while the camera is turned by 0.12 rad every 50 ms."""
    page.ask(
        "window.turning = setInterval(() => document.querySelector('canvas').dispatchEvent("
        "new KeyboardEvent('keydown', { key: 'ArrowLeft', bubbles: true })), 50)"
    )
    found = measured(page, demo, seconds)
    page.ask("clearInterval(window.turning)")
    return found


def main() -> None:
    """Measure with the camera still, and while it is turned."""
    options = option_parser(__doc__ or "").parse_args()
    seconds = QUICK_S if options.quick else MEASURED_S
    process, url = start_demo()
    try:
        with Browser(*SIZE) as page:
            page.send("Page.navigate", url=url)
            page.wait('document.getElementById("instobj-live")?.dataset.ready === "yes"')
            time.sleep(seconds / MEASURED_S * WARM_S)
            states = {
                "still": measured(page, process.pid, seconds),
                "turned": turned(page, process.pid, seconds / 4),
            }
            states["still"]["whole_picture_ms"] = page.ask("instobjLive.pictureMs()")
    finally:
        process.terminate()
        process.communicate()
    result = {"machine": machine(1, ()), "window": SIZE, "states": states}
    conclude("live_page", options, result, report)


if __name__ == "__main__":
    main()
