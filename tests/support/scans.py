"""Public scans of the YCB set beside the checkout, which tests skip where they are not."""

from pathlib import Path

YCB = Path(__file__).parents[2].parent / "shared" / "data" / "ycb"
