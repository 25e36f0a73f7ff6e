"""G-code of presses, in parts that the machine holds as a whole.

Each part ends with the tip clear of the object: a machine that holds the whole part raises the tip even
if nobody speaks to it any more.
"""

from __future__ import annotations

from design.errors import InputError
from instobj.bench.rig.plan import PressSettings


def press_code(
    settings: PressSettings, surface_mm: float, safe_mm: float, room_bytes: int
) -> list[list[str]]:
    """Lines of a press, in parts to be sent as a whole: one part per stroke. The last one ends at the
    safe height (mm), the others `lift_mm` above the surface.

    Raises
    ------
    InputError
        A part does not fit into the machine's buffer (0: it gets a line at a time).
    """
    settings_of_press, near = settings, f"G53G0Z{_mm(surface_mm + settings.approach_mm)}"
    away = f"G53G0Z{_mm(safe_mm)}"
    first = [near, *_stops(settings_of_press, surface_mm, settings_of_press.speed_mm_s)]
    if settings_of_press.strokes == 1:
        parts = [[*first, f"G53Z{_mm(surface_mm)}", away]]
    else:
        again = _stops(settings_of_press, surface_mm, settings_of_press.stroke_speed_mm_s)
        clear = [
            f"G53G0Z{_mm(surface_mm + settings_of_press.lift_mm)}",
            f"G4P{settings_of_press.pause_s:g}",
        ]
        parts = [
            [*first, *clear],
            *[[*again, *clear]] * (settings_of_press.strokes - 2),
            [*again, away],
        ]
    used = max(sum(len(line) + 1 for line in part) for part in parts)
    if room_bytes and used > room_bytes:
        raise InputError(
            f"a press with {len(settings_of_press.depths_mm)} stops takes {used} characters, and the machine "
            f"holds {room_bytes}: the tip would stay down if the cable came out. Give fewer depths_mm"
        )
    return parts


def _stops(settings: PressSettings, surface_mm: float, speed_mm_s: float) -> list[str]:
    """Motion mode and feed hold for the lines that follow."""
    lines, mode, feed = [], "G1", f"F{60 * speed_mm_s:g}"
    for depth_mm in settings.depths_mm:
        lines.append(f"G53{mode}Z{_mm(surface_mm - depth_mm)}{feed}")
        mode = feed = ""
        if settings.dwell_s > 0:
            lines.append(f"G4P{settings.dwell_s:g}")
    return lines


def _mm(value: float) -> str:
    return f"{value:.2f}".rstrip("0").rstrip(".")
