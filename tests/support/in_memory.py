"""Temporary files of tests in memory: those of searches and stores waited for the disk half their time."""

import os
import shutil
import tempfile

FOLDER = "/dev/shm"  # noqa: S108  pytest makes a folder of this user alone in it
ROOM_BYTES = 4_000_000_000
"""More than all tests leave behind at once; containers often have 64 MB, and stay on the disk."""


def install():
    """Of this process and those that it starts, unless the user names a folder."""
    if "TMPDIR" in os.environ or not os.access(FOLDER, os.W_OK):
        return
    if shutil.disk_usage(FOLDER).free > ROOM_BYTES:
        os.environ["TMPDIR"] = tempfile.tempdir = FOLDER
