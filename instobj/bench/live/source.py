"""Source of `instobj bench live`: a board, a recording, a data set, or a simulated object of its own."""

from __future__ import annotations

import secrets
from collections.abc import Generator
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from design.errors import InputError
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.calibration.resting import channel_names
from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.recordings.boards.link import replay_chunks, require_port
from estimator.recordings.table import LEAST_FACES, RawTable
from instobj.bench.collect.options import CollectOptions, open_source
from instobj.bench.live.scene import live_scene
from instobj.commands.readings import Zeroing, is_data_set, zeroed_data_set
from instobj.stages.run import Run
from instobj.store.progress import ProgressLine
from instobj.store.readers import INVERSION, PRESSES
from instobj.viewer.served import is_loopback

_DEMO = Path(__file__).parent / "demo.toml"
_KEY = "disc: place to 90 %; arrow: force, 1.6 mm per N"
_LABELLED = "; green cross: where the load cells say"
_TRUE = (
    "; green cross: truth. Simulated: paper's cube on a coarse mesh, drawn within its tolerances"
)


@dataclass(frozen=True)
class LiveOptions:
    """Options of the command line; `readings` names where they come from and goes to.

    Attributes
    ----------
    address, page_port : that the page is served on
    record : whether to record from the beginning
    seconds : how long; None until Ctrl-C
    """

    spec: Path | None
    readings: CollectOptions
    model: Path | None = None
    demo: bool = False
    zeroing: Zeroing = field(default_factory=Zeroing)
    overrides: tuple[str, ...] = ()
    address: str = "127.0.0.1"
    page_port: int = 8765
    record: bool = False
    seconds: float | None = None

    @property
    def token(self) -> str:
        """Return what a browser must know where others reach the page; empty on the loopback."""
        return "" if is_loopback(self.address) else secrets.token_urlsafe(16)


@dataclass(frozen=True)
class LiveSource:
    """An object, its scene, the lines of its board, and the estimator that reads them."""

    spec: ObjectSpec
    scene: bytes
    name: str
    chunks: Generator[bytes]
    readings: CollectOptions
    model: Path | None
    zeroing: Zeroing


def live_source(options: LiveOptions, progress: ProgressLine) -> LiveSource:
    """Everything that is needed before the first line; parts are built where none are stored.

    Raises
    ------
    InputError
        Not exactly one source, no specification or model, or a file that is neither recording nor
        data set.
    """
    given = options.readings
    sources = sum((options.demo, given.port is not None, given.replay is not None))
    if sources != 1:
        raise InputError(
            f"give one of --port, --replay and --demo: where the readings come from; got {sources}"
        )
    if options.demo:
        return _demo_source(options, progress)
    if options.spec is None:
        raise InputError(
            "give the specification of the object that is read: instobj bench live SPEC …"
        )
    spec = load_spec(options.spec, list(options.overrides))
    if options.model is not None and not options.model.is_file():
        raise InputError(f"no model at {options.model}. `instobj train SPEC` makes one")
    for port in filter(None, (given.port, given.load_port)):
        require_port(port, given.baud)
    chunks, readings, zeroing = _opened(given, options.zeroing)
    scene = live_scene(spec, Run(spec, progress).require("build").folder, _KEY + _LABELLED)
    return LiveSource(spec, scene, readings.source, chunks, readings, options.model, zeroing)


def _opened(
    readings: CollectOptions, zeroing: Zeroing
) -> tuple[Generator[bytes], CollectOptions, Zeroing]:
    """Lines, and options with `cells` and `tips`; data sets are zeroed already."""
    if readings.replay is None or not is_data_set(readings.replay):
        return *open_source(readings), zeroing
    table = data_set_table(zeroed_data_set(readings.replay, zeroing))
    filled = replace(readings, cells=readings.cells or table.face.shape[1], tips=readings.tips or 1)
    return replay_chunks(table, readings.speed), filled, replace(zeroing, mode="none")


def data_set_table(frames: FrameSet) -> RawTable:
    """A data set as a recording: changes as counts, every contact as a load cell with one tip."""
    faces = max(LEAST_FACES, int(frames.faces.max()))
    counts = np.full((len(frames), faces, frames.signal_counts.shape[2], 3), np.nan)
    counts[:, frames.faces - 1] = frames.signal_counts
    return RawTable(
        kind="generic",
        time_s=frames.time_s,
        force_n=np.nan_to_num(frames.force_n[..., 2]),
        counts=counts,
        face=frames.contact_face,
        tip_xy_mm=frames.contact_xy_mm[:, :, None],
        case=frames.session_id,
        declared_rest=np.all(frames.contact_face == NO_FACE, axis=1),
        grid_x_mm=frames.grid_x_mm,
        grid_y_mm=frames.grid_y_mm,
        duplicate_columns=(),
        digest="",
    )


def _demo_source(options: LiveOptions, progress: ProgressLine) -> LiveSource:
    """An object that is simulated here and now; its mechanics are stored for the next time."""
    from instobj.bench.live.demo import CELLS, hand_chunks, simulated_hand

    spec = load_spec(options.spec or _DEMO, list(options.overrides))
    run = Run(spec, progress)
    if options.spec is None:
        progress.say("making the demo's object; the next start takes seconds")
    build, inversion = run.require("build").folder, run.require("inversion").folder
    with progress.stage("demo: a hand grasps a simulated object"):
        hand = simulated_hand(spec, *PRESSES.read(run.require("presses").folder))
    chunks = hand_chunks(hand, channel_names(spec), spec.seed)
    readings = replace(options.readings, cells=CELLS, tips=1)
    model = options.model or INVERSION.path(inversion)
    scene = live_scene(spec, build, _KEY + _TRUE)
    return LiveSource(spec, scene, "simulated object", chunks, readings, model, Zeroing())
