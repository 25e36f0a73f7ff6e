"""Where the two public gripper recordings lie, which are not part of the project."""

import os
from pathlib import Path

FOLDER = Path(
    os.environ.get("INSTOBJ_DATA")
    or Path(__file__).parents[3].parent / "shared" / "data" / "inst-obj"
)
NAMES = ("1probe.csv", "2probe.csv")
