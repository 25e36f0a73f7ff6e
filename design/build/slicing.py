"""Time and filament of printed parts, by PrusaSlicer where it is installed."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from design.spec.fabrication import PrinterSpec

SLICER = "prusa-slicer"
"""Name of its program."""
_LONGEST_S = 300.0
"""Time after which a part is given up; parts of examples take two seconds."""
_IN_MINUTES = {"d": 1440.0, "h": 60.0, "m": 1.0, "s": 1 / 60}


@dataclass(frozen=True)
class PrintJob:
    """One piece of a part as it is printed by the slicer's own speeds: time (min) and filament (g)."""

    minutes: float
    filament_g: float


def has_slicer() -> bool:
    """Return whether PrusaSlicer is on the path."""
    return shutil.which(SLICER) is not None


def print_job(part: Path, printer: PrinterSpec) -> PrintJob | None:
    """Slice a part's 3MF for a printer; None where the slicer refuses it, as one that leaves its bed.

    Supports and brim count. Speeds are those of the slicer's default profile: another printer may take
    half or twice the time.
    """
    wide, deep, _ = printer.bed_mm
    bed = f"0x0,{wide:g}x0,{wide:g}x{deep:g},0x{deep:g}"
    with tempfile.TemporaryDirectory() as folder:
        code = Path(folder) / "part.gcode"
        command = [SLICER, "--export-gcode", "--bed-shape", bed, "-o", str(code), str(part)]
        try:
            subprocess.run(command, capture_output=True, timeout=_LONGEST_S, check=True)
        except (subprocess.SubprocessError, OSError):
            return None
        text = code.read_text("utf-8", errors="replace") if code.is_file() else ""
    time = re.search(r"^; estimated printing time \(normal mode\) = (.+)$", text, re.M)
    volume = re.search(r"^; filament used \[cm3\] = ([\d.]+)$", text, re.M)
    if time is None or volume is None:
        return None
    spans = re.findall(r"(\d+)([dhms])", time[1])
    minutes = sum(float(number) * _IN_MINUTES[unit] for number, unit in spans)
    return PrintJob(minutes, float(volume[1]) * printer.preset.density_g_per_cm3)
