"""Commands of the bench: boards, machines and built objects, `instobj bench …`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from design.errors import InputError
from instobj.bench.rig import cli as rig_cli
from instobj.cli.options import (
    HERE,
    AsJson,
    LoadPort,
    Out,
    Overrides,
    Places,
    Port,
    Replay,
    Seconds,
    Spec,
    Zero,
    port_and_baud,
    replayed_file,
    show,
    zero_and_frames,
)

app = typer.Typer(help="Boards, machines and built objects.", no_args_is_help=True)
app.add_typer(rig_cli.app)


@app.command()
def collect(
    out: Annotated[
        Path,
        typer.Argument(
            metavar="OUT", help="Recording: OUT.csv grows, OUT.nc is written at the end."
        ),
    ],
    port: Port = None,
    replay: Replay = None,
    load_port: LoadPort = None,
    place: Places = None,
    zero: Annotated[
        int,
        typer.Option(
            min=0, help="Frames of the baseline, taken at the start with nothing touching."
        ),
    ] = 20,
    stop: Annotated[
        str | None,
        typer.Option(
            metavar="FRAMES|TIME", help="Stop after so many frames, 100, or seconds, 10s."
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Collect labelled frames from a board (or a replay) into a recording to calibrate with."""
    from instobj.bench.collect.command import collect as collect_frames
    from instobj.bench.collect.options import CollectOptions

    serial_port, baud = port_and_baud(port)
    file, speed = replayed_file(replay)
    frames, seconds = _end_of(stop)
    options = CollectOptions(
        out, serial_port, file, load_port, baud, speed, tuple(place or ()),
        zero_frames=zero, seconds=seconds, frames=frames,
    )  # fmt: skip
    show(collect_frames(options), as_json)


@app.command()
def firmware(
    spec: Spec,
    board: Annotated[
        str | None,
        typer.Option(
            help="Board that reads the sensors: mega2560, pico, esp32c3, esp32s3; -espnow: wireless "
            "(default: the first that can)."
        ),
    ] = None,
    topology: Annotated[
        str | None,
        typer.Option(
            help="How I²C chips are kept apart, e.g. multiplexers (default: the cheapest)."
        ),
    ] = None,
    cable_mm: Annotated[
        float,
        typer.Option(min=0, max=5000, help="Length of the wires from the object to the board, mm."),
    ] = 200.0,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Plan the sensors' buses on a board and write its firmware."""
    from instobj.bench.firmware.command import write_firmware

    show(write_firmware(spec, board, topology, cable_mm, out, overrides or []), as_json)


@app.command()
def live(
    spec: Annotated[
        Path | None,
        typer.Argument(help="Specification (TOML); --demo brings one.", show_default=False),
    ] = None,
    model: Annotated[
        Path | None,
        typer.Option(help="Estimator, contacts.nc; without it only channels are shown."),
    ] = None,
    port: Port = None,
    replay: Replay = None,
    demo: Annotated[
        bool,
        typer.Option("--demo", help="A simulated object in a hand; no board and no files needed."),
    ] = False,
    record: Annotated[
        Path | None,
        typer.Option(
            metavar="OUT",
            help="Record from the start, as collect does: OUT.csv grows, OUT.nc is written at the end "
            "(default: <name>_live, once the page's button is pressed).",
        ),
    ] = None,
    load_port: LoadPort = None,
    place: Places = None,
    zero: Zero = None,
    page: Annotated[
        str,
        typer.Option(
            metavar="[ADDRESS:]PORT",
            help="Where the page is served: TCP port (0: any free one), and network address; other "
            "machines need the access token that is printed.",
        ),
    ] = "127.0.0.1:8765",
    seconds: Seconds = None,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Contacts, channels and their health on a page in the browser, while a board is read."""
    from instobj.bench.collect.options import CollectOptions
    from instobj.bench.live.command import live as show_live
    from instobj.bench.live.source import LiveOptions
    from instobj.commands.readings import Zeroing

    serial_port, baud = port_and_baud(port)
    file, speed = replayed_file(replay)
    mode, zero_frames = zero_and_frames(zero, 20)
    address, page_port = _served_at(page)
    readings = CollectOptions(
        record or Path(f"{spec.stem if spec else 'demo'}_live"), serial_port, file, load_port, baud,
        speed, tuple(place or ()), zero_frames=zero_frames,
    )  # fmt: skip
    options = LiveOptions(
        spec, readings, model, demo, Zeroing(mode, zero_frames),
        tuple(overrides or ()), address, page_port,
        record is not None, seconds,
    )  # fmt: skip
    show(show_live(options), as_json)


@app.command()
def bringup(
    spec: Spec,
    port: Port = None,
    replay: Annotated[
        Path | None, typer.Option(help="bringup.csv of an earlier bring-up, in place of a board.")
    ] = None,
    simulated: Annotated[
        list[str] | None,
        typer.Option(
            metavar="FAULT",
            help="A simulated object with this fault in place of a board, e.g. swap=F1-S2,F3-S1; none: "
            "without; can be repeated.",
        ),
    ] = None,
    repeat: Annotated[
        list[str] | None,
        typer.Option(help="Step or recording to repeat, e.g. held or 'held F1-S2'."),
    ] = None,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Bring a newly soldered object up, question by question, and write how it was built."""
    from instobj.bench.bringup.command import BringupOptions, bring_up

    serial_port, baud = port_and_baud(port)
    faults = None if simulated is None else tuple(name for name in simulated if name != "none")
    result = bring_up(
        BringupOptions(
            spec,
            out,
            serial_port,
            replay,
            faults,
            tuple(repeat or ()),
            baud,
            tuple(overrides or ()),
        )
    )
    show(result, as_json)
    if not result["passed"]:
        raise typer.Exit(1)


@app.command()
def selftest(
    spec: Spec,
    resting: Annotated[
        Path,
        typer.Argument(help="Recording, or CSV of frames at rest.", show_default=False),
    ],
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Flipped magnets, swapped or dead channels, from the resting signals of a built object."""
    from instobj.commands.recorded.validate import self_test_of

    result = self_test_of(spec, resting, overrides or [])
    show(result, as_json)
    if not result["passed"]:
        raise typer.Exit(1)


@app.command()
def material(
    source: Annotated[
        str,
        typer.Argument(
            help="CSV of a tensile test, name of a silicone, Shore hardness, or a fruit to be like.",
            show_default=False,
        ),
    ],
    out: Out = HERE,
    as_json: AsJson = False,
) -> None:
    """Young's modulus of a silicone with its uncertainty; models fitted to a tensile test; silicone and
    thickness that give way as a fruit does."""
    from instobj.commands.material import describe_material

    show(describe_material(source, out), as_json)


def _end_of(stop: str | None) -> tuple[int | None, float | None]:
    """Frames or seconds after which a recording ends, of `100` or `10s`."""
    if stop is None:
        return None, None
    if stop.isdecimal() and int(stop):
        return int(stop), None
    try:
        seconds = float(stop.removesuffix("s")) if stop.endswith("s") else -1.0
    except ValueError:
        seconds = -1.0
    if not 0 <= seconds < float("inf"):
        raise InputError(f"--stop {stop}: give frames, such as 100, or seconds, such as 10s")
    return None, seconds


def _served_at(page: str) -> tuple[str, int]:
    """Network address and TCP port of `[ADDRESS:]PORT`."""
    address, _, port = page.rpartition(":")
    if not port.isdecimal() or int(port) > 65535:
        raise InputError(
            f"--page {page}: give a TCP port up to 65535, 0 for any free one, behind an address where not "
            "this machine alone is served: 192.168.0.5:8765"
        )
    return address or "127.0.0.1", int(port)
