"""Commands that simulate recordings, and train, judge, export and use estimators."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from design.errors import InputError
from instobj.cli.options import (
    HERE,
    MEASURE,
    AsJson,
    Out,
    Overrides,
    Port,
    Sources,
    Zero,
    port_and_baud,
    show,
    zero_and_frames,
)

app = typer.Typer()

Twin = Annotated[
    Path | None,
    typer.Option(
        help="Specification of the object in a data set: its digital twin, calibrated on the "
        "training presses, adds presses at every contact location."
    ),
]


@app.command(rich_help_panel=MEASURE)
def train(
    sources: Sources,
    twin: Twin = None,
    export: Annotated[
        bool,
        typer.Option(
            "--export",
            help="SOURCES are trained estimators (face_<n>.safetensors) or their folder: write ONNX "
            "files with scaling, units and channel order, beside them or into --out.",
        ),
    ] = False,
    out: Annotated[Path | None, typer.Option(help="Folder for cad_out/ and runs/.")] = None,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Make the contact estimator of a specification or a data set, and judge it on unseen presses.

    Of a specification: tables of the forward model, for contacts on all faces at once. Of a data set, or
    with --set training.model=compact: networks, one per face.
    """
    if export:
        if twin or overrides:
            raise InputError("--export trains nothing: leave out --twin and --set")
        export_trained(sources, out, as_json)
        return
    out = out or HERE
    from instobj.commands.run import run_estimator

    stages = ("networks", "metrics")
    show(run_estimator(sources, stages, out, overrides or [], twin), as_json)


def export_trained(
    models: Annotated[
        list[Path],
        typer.Argument(help="Trained estimators (face_<n>.safetensors), or their folder."),
    ],
    out: Annotated[
        Path | None, typer.Option(help="Folder of the files (default: beside each model).")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Trained estimators as ONNX files with scaling, units and channel order inside."""
    from instobj.commands.predict import export_models

    show(export_models(models, out), as_json)


@app.command(rich_help_panel=MEASURE)
def predict(
    model: Annotated[Path, typer.Argument(help="Exported estimator (.onnx), or contacts.nc.")],
    file: Annotated[
        Path | None, typer.Argument(help="Recording or data set.", show_default=False)
    ] = None,
    port: Port = None,
    zero: Zero = None,
    frames: Annotated[
        int | None, typer.Option(min=1, help="With --port: stop after this many frames.")
    ] = None,
    out: Annotated[
        Path,
        typer.Option(
            help="Folder for runs/; NAME.mcap, or with --port foxglove[:PORT], shows contacts in Foxglove."
        ),
    ] = HERE,
    as_json: AsJson = False,
) -> None:
    """Contacts in a recording, or live from a board (one JSON document per frame)."""
    from estimator.inversion.storage import is_inversion
    from instobj.commands.readings import Zeroing
    from instobj.robot import is_foxglove

    inverts = is_inversion(model)
    if is_foxglove(out) and not inverts and model.exists():
        raise InputError(
            f"{model} reads one face; --out {out} shows contacts of the whole object. Give contacts.nc, "
            "which `instobj train SPEC` writes"
        )
    if inverts:
        from instobj.commands.contacts import contacts_in_file as in_file
        from instobj.commands.contacts import contacts_on_port as on_port
    else:
        from instobj.commands.predict import predict_file as in_file
        from instobj.commands.predict import predict_port as on_port
    board, baud = port_and_baud(port)
    zeroing = Zeroing(*zero_and_frames(zero, 8))
    if (file is None) == (board is None):
        raise InputError("give either a file or --port, the serial port of a board")
    if file is not None and frames is not None:
        raise InputError(
            f"--frames stops reading a --port after {frames} frames; {file} is read whole. Leave it out"
        )
    if file is not None:
        show(in_file(model, file, out, zeroing), as_json)
    elif board is not None:
        lines = on_port(model, board, zeroing, frames, baud)
        if is_foxglove(out):
            from instobj.commands.contacts import shown_in_foxglove

            lines = shown_in_foxglove(lines, model, out)
        for line in lines:
            typer.echo(line)


@app.command(rich_help_panel=MEASURE)
def assess(
    paths: Annotated[
        list[Path],
        typer.Argument(
            metavar="RECORDING...",
            help="Recordings, data sets, or folders of them: one a gripper.",
            show_default=False,
        ),
    ],
    model: Annotated[
        Path | None,
        typer.Option(
            help="Folder that `train` wrote to, or contacts.nc; without it, slip in raw channels.",
            show_default=False,
        ),
    ] = None,
    protocol: Annotated[
        str, typer.Option(help="handling, grasp-strength, pinch, slip or force-tracking.")
    ] = "handling",
    limit: Annotated[
        str | None, typer.Option(metavar="FRUIT|FILE", help="Limit of damage: a fruit, or TOML.")
    ] = None,
    friction: Annotated[
        float, typer.Option(min=0, max=2, help="Friction between gripper and object, assumed.")
    ] = 0.5,
    weight: Annotated[
        float, typer.Option(min=0, max=1000, help="Weight of the object, N; 0 where not known.")
    ] = 0.0,
    spec: Annotated[
        Path | None, typer.Option(help="Specification of the object, for networks alone.")
    ] = None,
    zero: Zero = None,
    out: Out = HERE,
    as_json: AsJson = False,
) -> None:
    """Was it a good grasp: grasps measured from the object's side, grippers ranked."""
    from instobj.commands.assess.command import AssessOptions, assess
    from instobj.commands.assess.raw import assess_raw
    from instobj.commands.readings import Zeroing
    from instobj.robot import is_foxglove

    if model is None:
        read = limit or weight or spec or zero or is_foxglove(out)
        if protocol not in ("handling", "slip") or read:
            raise InputError(
                "without --model only contact slip is judged, from the first frames as rest: --limit, "
                "--weight, --spec, --zero, --out FILE.mcap and other protocols need an estimator. Give "
                "--model FOLDER"
            )
        show(assess_raw(tuple(paths), out), as_json)
        return
    zeroing = Zeroing(*zero_and_frames(zero, 8))
    options = AssessOptions(
        tuple(paths), model, spec, protocol, limit, friction, weight, zeroing, out
    )
    show(assess(options), as_json)
