"""The witness of a test session: it compares, or writes if it is asked to."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from tests.support import typechecks
from tests.support.recorded_results.witness import Witness, read

RECORDING = "INSTOBJ_TESTS_RESULTS"
"""Environment variable: file to which everything that functions return is written."""

CHANGED = "INSTOBJ_TESTS_RESULTS_CHANGED"
"""Environment variable: file to which results are written that are no longer those on record."""

_witness: Witness | None = None


def begins(item: pytest.Item) -> None:
    """From here on calls belong to this test."""
    global _witness
    if _witness is None:
        recording = RECORDING in os.environ
        _witness = Witness({} if recording else read(), recording)
    if _witness.recording and item.nodeid.split("::")[0] not in _witness.records:
        ends()  # what there is, should this run be broken off
    typechecks.witness = _witness if _witness.begins(item.nodeid.split("::")[0]) else None


def compare() -> None:
    """Raise if functions of this test returned something else than what is on record."""
    if _witness is not None and CHANGED not in os.environ:
        _witness.complain()


def ends() -> None:
    if _witness is not None and CHANGED in os.environ:
        Path(os.environ[CHANGED]).write_text(json.dumps(_witness.changed), encoding="utf-8")
    if _witness is not None and _witness.recording:
        Path(os.environ[RECORDING]).write_text(json.dumps(_witness.records), encoding="utf-8")
