"""Draw what a command prints: `python docs/terminal_picture.py docs/pictures/check.png instobj check …`.

The command runs in the working folder at 94 columns. The picture shows it in bold, then its output.
"""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
import textwrap
from pathlib import Path

from matplotlib import get_data_path
from PIL import Image, ImageDraw, ImageFont

COLUMNS, SIZE, MARGIN = 94, 15, 18
"""Characters of a line; height of a letter and white border, pixels."""
_LINE = 1.35
"""Distance of lines over the height of a letter."""


def printed(command: list[str]) -> list[str]:
    """Return the lines that a command prints on a terminal of `COLUMNS`; it must succeed."""
    environment = os.environ | {"COLUMNS": str(COLUMNS), "NO_COLOR": "1"}
    program = [sys.executable, "-m", *command] if command[0] == "instobj" else command
    done = subprocess.run(program, env=environment, capture_output=True, text=True, check=True)
    # paths below the working folder as a reader would write them
    lines = done.stdout.replace(f"{Path.cwd()}/", "").rstrip().splitlines()
    return [part for line in lines for part in _folded(line)]


def _folded(line: str) -> list[str]:
    """Return the rows that a terminal makes of a long line, at blanks and further in for legibility."""
    if len(line) <= COLUMNS:
        return [line]
    return textwrap.wrap(line, COLUMNS, subsequent_indent="      ", drop_whitespace=True)


def draw(path: Path, command: list[str]) -> None:
    """Write the picture of a command and its output."""
    fonts = Path(get_data_path()) / "fonts" / "ttf"
    plain = ImageFont.truetype(fonts / "DejaVuSansMono.ttf", SIZE)
    bold = ImageFont.truetype(fonts / "DejaVuSansMono-Bold.ttf", SIZE)
    lines = [(f"$ {shlex.join(command)}", bold), *((line, plain) for line in printed(command))]
    step = round(_LINE * SIZE)
    width = max(int(font.getlength(text)) for text, font in lines)
    image = Image.new("L", (width + 2 * MARGIN, step * len(lines) + 2 * MARGIN), "white")
    pen = ImageDraw.Draw(image)
    for number, (text, font) in enumerate(lines):
        pen.text((MARGIN, MARGIN + number * step), text, "black", font)
    image.quantize(16).save(path, optimize=True)


if __name__ == "__main__":
    draw(Path(sys.argv[1]), sys.argv[2:])
