"""The recording that viewers of `instobj bench live` switch on and off."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass, field
from typing import Any

from design.errors import InstobjError
from estimator.recordings.boards.growing import GrowingRecording
from estimator.recordings.boards.lines import Frame
from instobj.bench.collect.labelled_frames import Collection, take_frame


@dataclass
class Recorder:
    """The recording that viewers switch on and off; rows are those of `collect`."""

    state: Collection
    open: ExitStack = field(default_factory=ExitStack)
    growing: GrowingRecording | None = None
    rows: int = 0
    message: str = ""

    def switch(self, on: bool) -> None:
        """Begin or pause; what cannot be written is reported, and the page goes on."""
        self.open.close()
        self.rows += self.growing.rows_added if self.growing else 0
        self.growing, self.message = None, ""
        if not on or not self.state.channels:
            return
        try:
            self.growing = self.open.enter_context(self.state.recording())
        except InstobjError as error:
            self.message = f"not recording: {error}"

    def take(self, frame: Frame, time_s: float) -> None:
        """Append a frame where one is open."""
        if self.growing is None:
            return
        try:
            take_frame(frame, time_s, self.state, self.growing)
        except InstobjError as error:
            self.switch(False)
            self.message = f"recording ended: {error}"

    def news(self) -> dict[str, Any]:
        """For the page."""
        added = self.growing.rows_added if self.growing else 0
        return {
            "on": self.growing is not None,
            "file": str(self.state.options.csv_path),
            "rows": self.rows + added,
            "unlabelled": self.state.unlabelled,
        }
