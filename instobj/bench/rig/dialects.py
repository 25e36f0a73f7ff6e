"""Dialects of machines, as a table: how each is asked, stopped, homed, and what its limits are."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from design.errors import InputError
from instobj.bench.rig.grbl_lines import RECEIVE_BYTES, GrblSpeech, grbl_travel
from instobj.bench.rig.marlin_lines import MARK, MarlinSpeech, marlin_travel
from instobj.bench.rig.replies import Travel

Speech = GrblSpeech | MarlinSpeech
"""Bytes of a machine to replies, and lines in Grbl's words to its bytes; `status` asks its state."""


@dataclass(frozen=True)
class Dialect:
    """Words of a kind of machine.

    `hold` stops it at once, `reset` empties its buffers and is answered by a greeting. It answers
    `queries` with its limits, and `travel` judges them. `room_bytes` of lines are held by it and emptied
    by `reset`; 0: it would carry them out after a stop, so it gets one line at a time. `boot_s`: its
    time to start.
    """

    speech: Callable[[], Speech]
    baud: int
    hold: bytes
    reset: bytes
    queries: tuple[str, ...]
    home: tuple[str, ...]
    travel: Callable[[Mapping[str, float]], Travel]
    room_bytes: int
    boot_s: float


DIALECTS = {
    "grbl": Dialect(
        GrblSpeech, 115_200, b"!", b"\x18", ("$$",), ("$H",), grbl_travel, RECEIVE_BYTES, 5.0
    ),
    "marlin": Dialect(
        MarlinSpeech, 115_200, b"M410\n", b"N0 M110 N0*125\nM118 E1 " + MARK + b"\n",
        ("M115", "M211", "M119"), ("G21", "G90", "M84S0", "G28Z", "G28XY"), marlin_travel, 0, 20.0,
    ),
}  # fmt: skip
"""grblHAL speaks as Grbl, with more axes in its reports and another greeting. `M84S0`: motors stay on; after
two minutes Marlin would let a tip that is up sink."""
_REFUSED = {
    "octoprint": "OctoPrint's HTTP interface answers before a line is done, hands on the machine's reports "
    "twice a second at most, lets others send lines, and a stop would wait for a network: no bound would "
    "hold within a frame. Disconnect the machine in OctoPrint, and run this on the computer that its USB is "
    "on, with --machine marlin"
}


def dialect_named(name: str) -> Dialect:
    """Return the dialect of that name.

    Raises
    ------
    InputError
        No such dialect, or one that cannot be stopped safely.
    """
    if name not in DIALECTS:
        why = _REFUSED.get(name, f"Choose {', '.join(DIALECTS)} or poses")
        raise InputError(f"--machine {name!r} is not known. {why}")
    return DIALECTS[name]
