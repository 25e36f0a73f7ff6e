"""The `instobj` command: thin, typed, and quick to start (heavy imports inside the commands)."""

from __future__ import annotations

import json
import signal
import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from design.errors import InputError

app = typer.Typer(
    name="instobj",
    help="Design, simulate and calibrate instrumented objects that feel how they are grasped.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)

Specs = Annotated[
    list[Path], typer.Argument(help="Specification files (TOML).", show_default=False)
]
Sources = Annotated[
    list[Path],
    typer.Argument(help="Specifications (TOML) or data sets (NetCDF).", show_default=False),
]
Out = Annotated[Path, typer.Option(help="Folder that gets cad_out/ and runs/.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON document on stdout.")]
Overrides = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="KEY=VALUE", help="Override, e.g. shell.thickness_mm=9."),
]
AsBuilt = Annotated[
    Path | None,
    typer.Option(help="What was measured on the built object, else SPEC.as_built.toml."),
]
_HERE = Path()


@app.command()
def new(name: Annotated[str, typer.Argument(help="Name of the object.")], out: Out = _HERE) -> None:
    """Write a commented specification to start from: NAME.toml."""
    from instobj.commands import new_specification

    typer.echo(f"wrote {new_specification(name, out)}")


@app.command()
def check(specs: Specs, as_json: AsJson = False, overrides: Overrides = None) -> None:
    """Validate specifications: keys, bounds, whether everything fits, and sensors at rest."""
    from instobj.commands import check_specifications

    _show(check_specifications(specs, overrides or []), as_json)


@app.command()
def build(
    specs: Specs, out: Out = _HERE, as_json: AsJson = False, overrides: Overrides = None
) -> None:
    """Solids, casting mould and probes as STL and STEP, with a manifest."""
    _chain(specs, ("build",), out, as_json, overrides)


@app.command()
def mesh(
    specs: Specs, out: Out = _HERE, as_json: AsJson = False, overrides: Overrides = None
) -> None:
    """Tetrahedra of the sealed body with every magnet resolved; quality reported."""
    _chain(specs, ("mesh",), out, as_json, overrides)


@app.command()
def simulate(
    specs: Specs,
    out: Out = _HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
    as_built: AsBuilt = None,
) -> None:
    """Mechanics of every press, and the signals that all sensors give."""
    _chain(specs, ("signals",), out, as_json, _with_as_built(overrides, as_built))


@app.command()
def compliance(
    specs: Specs, out: Out = _HERE, as_json: AsJson = False, overrides: Overrides = None
) -> None:
    """Map of travel per newton over all faces, with the magnets and without them."""
    _chain(specs, ("compliance",), out, as_json, overrides)


@app.command()
def score(
    specs: Specs,
    hull: Annotated[
        str | None, typer.Option(help="δ by covariance, monte-carlo (any N) or exact (N ≤ 100).")
    ] = None,
    hull_frames: Annotated[int | None, typer.Option(help="N of the convex hull.")] = None,
    shear: Annotated[
        bool, typer.Option("--shear", help="Bounds of (x, y, F, Fx, Fy) as well.")
    ] = False,
    out: Out = _HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
    as_built: AsBuilt = None,
) -> None:
    """Sensitivity, Cramér–Rao bounds and maps of every contact place."""
    chosen = {"score.hull": hull, "score.hull_frames": hull_frames}
    more = [f"{key}={value}" for key, value in chosen.items() if value is not None]
    stages = ("scores", "shear_scores") if shear else ("scores",)
    _chain(specs, stages, out, as_json, [*_with_as_built(overrides, as_built), *more])


@app.command()
def identify(
    specs: Specs, out: Out = _HERE, as_json: AsJson = False, overrides: Overrides = None
) -> None:
    """How many contacts at once can be told apart, and with how many sensors."""
    _chain(specs, ("identify",), out, as_json, overrides)


@app.command()
def train(
    sources: Sources, out: Out = _HERE, as_json: AsJson = False, overrides: Overrides = None
) -> None:
    """Train a contact estimator per face, on simulated presses or on a data set."""
    _estimate(sources, ("networks",), out, as_json, overrides)


@app.command()
def evaluate(
    sources: Sources, out: Out = _HERE, as_json: AsJson = False, overrides: Overrides = None
) -> None:
    """The paper's four metrics on held-out presses (trains first where nothing is stored)."""
    _estimate(sources, ("networks", "metrics"), out, as_json, overrides)


@app.command()
def report(
    specs: Specs,
    out: Out = _HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
    as_built: AsBuilt = None,
) -> None:
    """One self-contained report.html: go or no-go, tables, figures and provenance."""
    _chain(specs, ("report",), out, as_json, _with_as_built(overrides, as_built))


@app.command()
def run(
    specs: Specs,
    out: Out = _HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
    as_built: AsBuilt = None,
) -> None:
    """The whole chain, stage by stage; stored results are reused."""
    _chain(specs, ("report",), out, as_json, _with_as_built(overrides, as_built))


@app.command()
def recordings(
    files: Annotated[list[Path], typer.Argument(help="Recordings (CSV).", show_default=False)],
    out: Out = _HERE,
    as_json: AsJson = False,
) -> None:
    """Read recordings, find and correct their faults, and write a data set to train on."""
    from instobj.commands import read_recordings

    _show(read_recordings(files, out), as_json)


@app.command()
def material(
    source: Annotated[
        str,
        typer.Argument(help="CSV of a tensile test, a name, or a hardness.", show_default=False),
    ],
    out: Out = _HERE,
    as_json: AsJson = False,
) -> None:
    """Young's modulus of a silicone with its spread; solids fitted to a tensile test."""
    from instobj.material import describe_material

    _show(describe_material(source, out), as_json)


@app.command()
def robustness(
    specs: Specs,
    out: Out = _HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
    as_built: AsBuilt = None,
) -> None:
    """What the spread of assembly, material and surroundings does, ranked."""
    from instobj.robustness import robustness_of

    _show(robustness_of(specs, out, _with_as_built(overrides, as_built)), as_json)


@app.command()
def selftest(
    spec: Annotated[Path, typer.Argument(help="Specification (TOML).", show_default=False)],
    resting: Annotated[
        Path,
        typer.Argument(help="Recording, or CSV of frames at rest.", show_default=False),
    ],
    as_json: AsJson = False,
    overrides: Overrides = None,
    as_built: AsBuilt = None,
) -> None:
    """Flipped magnets, swapped or dead channels, from the resting signals of a built object."""
    from instobj.hardware import self_test_of

    result = self_test_of(spec, resting, _with_as_built(overrides, as_built))
    _show(result, as_json)
    if not result["passed"]:
        raise typer.Exit(1)


@app.command()
def validate(
    spec: Annotated[Path, typer.Argument(help="Specification (TOML).", show_default=False)],
    recordings: Annotated[list[Path], typer.Argument(help="Recordings (CSV).", show_default=False)],
    exchanges: Annotated[
        int, typer.Option(min=1, help="Exchanges of places for the null of the calibration.")
    ] = 19,
    out: Out = _HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
    as_built: AsBuilt = None,
) -> None:
    """Predicted against recorded presses, every figure beside its permutation null."""
    from instobj.hardware import validate_on

    given = _with_as_built(overrides, as_built)
    _show(validate_on(spec, recordings, exchanges, out, given), as_json)


@app.command()
def press(
    spec: Annotated[Path, typer.Argument(help="Specification (TOML).", show_default=False)],
    xy: Annotated[
        tuple[float, float] | None, typer.Option(help="Place in the face's frame, mm.")
    ] = None,
    face: Annotated[int, typer.Option(help="Sensed face, 1 to 5.")] = 1,
    depth: Annotated[float, typer.Option(help="Depth of the press, mm.")] = 2.0,
    material: Annotated[
        str, typer.Option(help="neo-hookean, yeoh, ogden, or linear: small strain, any indenter.")
    ] = "neo-hookean",
    constants: Annotated[
        str, typer.Option(help="MPa: C1,C2,C3 of yeoh; μ1,α1,μ2,α2,… of ogden.")
    ] = "",
    at: Annotated[
        list[str] | None,
        typer.Option(metavar="FACE:X,Y[,DEPTH]", help="linear: one more place; repeat it."),
    ] = None,
    force: Annotated[
        float | None, typer.Option(help="linear: press each to this force, N.")
    ] = None,
    direction: Annotated[
        tuple[float, float] | None,
        typer.Option(help="linear: path leans towards the face's x and y, degrees."),
    ] = None,
    patch: Annotated[
        tuple[float, float] | None,
        typer.Option(help="linear: uniform pressure instead: radius mm, MPa."),
    ] = None,
    out: Out = _HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Presses of chosen places: one with large deformation beside small strain, or any with --material
    linear, several at once."""
    from instobj.load_places import places_given

    given = [*(overrides or [])]
    if direction is not None:
        given.append(f"indenter.direction_deg=[{direction[0]}, {direction[1]}]")
    places = places_given(face, xy, at or [], depth)
    if material == "linear":
        from instobj.loads import press_loads

        _show_loads(press_loads(spec, places, force, patch, out, given), as_json)
        return
    if xy is None or at or force is not None or patch is not None:
        raise InputError(
            "--at, --force and --patch are for small strain: add --material linear, or give one "
            "place with --xy and --depth"
        )
    from instobj.press import press_specification

    result = press_specification(spec, face, xy, depth, material, constants, out, given)
    _show(result, as_json)
    if result["status"] != "converged":
        typer.echo("Newton's method found no equilibrium any deeper", err=True)
        raise typer.Exit(1)


@app.command()
def grasp(
    spec: Annotated[Path, typer.Argument(help="Specification (TOML).", show_default=False)],
    jaw: Annotated[
        list[str],
        typer.Option(metavar="FACE:X,Y[;X,Y]", help="Tips of one jaw; give it twice."),
    ],
    force: Annotated[float, typer.Option(help="Force of each jaw, N.")],
    out: Out = _HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """A parallel-jaw grasp: forces, travel, what all sensors see, and the error of superposition."""
    from instobj.grasp import grasp_specification

    _show(grasp_specification(spec, jaw, force, out, overrides or []), as_json)


@app.command()
def slip(
    spec: Annotated[Path, typer.Argument(help="Specification (TOML).", show_default=False)],
    shift: Annotated[
        tuple[float, float, float], typer.Option(help="Of the core in the shell, x y z, mm.")
    ] = (0.0, 0.0, 0.0),
    rotation: Annotated[
        tuple[float, float, float], typer.Option(help="Rotation vector about x y z, degrees.")
    ] = (0.0, 0.0, 0.0),
    rim: Annotated[str, typer.Option(help="free, or held on the mounting plate.")] = "free",
    out: Out = _HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """What a core that slipped after calibration costs: resting signals, false places and forces."""
    from instobj.slip import slip_specification

    _show(slip_specification(spec, shift, rotation, rim, out, overrides or []), as_json)


def _show_loads(result: dict[str, Any], as_json: bool) -> None:
    _show(result, as_json)
    if result["status"] == "refused":
        typer.echo("some presses were refused: see above", err=True)
        raise typer.Exit(2)


def _with_as_built(overrides: list[str] | None, as_built: Path | None) -> list[str]:
    given = [] if as_built is None else [f"as_built={json.dumps(str(as_built.absolute()))}"]
    return [*(overrides or []), *given]


def _chain(
    specs: list[Path],
    stages: tuple[str, ...],
    out: Path,
    as_json: bool,
    overrides: list[str] | None,
) -> None:
    from instobj.commands import run_chain

    _show(run_chain(specs, stages, out, overrides or []), as_json)


def _estimate(
    sources: list[Path],
    stages: tuple[str, ...],
    out: Path,
    as_json: bool,
    overrides: list[str] | None,
) -> None:
    from instobj.commands import run_estimator

    _show(run_estimator(sources, stages, out, overrides or []), as_json)


def _show(result: dict[str, Any], as_json: bool) -> None:
    if as_json:
        typer.echo(json.dumps(result, indent=2))
        return
    from instobj.tables import print_result

    print_result(result)


def main() -> None:
    """Entry point: bad input ends with one error message and exit code 2, without a traceback."""
    interrupted = _note_interrupts()
    code = 0
    try:
        code = app(standalone_mode=False)
    except typer.BadParameter as error:
        error.show()
        sys.exit(2)
    except typer.TyperException as error:
        _fail(str(error), 2)
    except InputError as error:
        _fail(str(error), 2)
    except ArithmeticError as error:
        _fail(f"the computation failed: {error}", 2)
    except MemoryError as error:
        _fail(f"out of memory: {error}. Use a larger mesh.edge_mm or mesh.surface_edge_mm", 2)
    except (KeyboardInterrupt, typer.Abort, ImportError):
        if not interrupted:  # an import that Ctrl-C breaks off may raise ImportError instead
            raise
    if interrupted:
        _fail("interrupted. Finished stages are kept: the same command goes on from there", 130)
    sys.exit(code)


def _note_interrupts() -> list[int]:
    """Interrupts received so far, besides raising KeyboardInterrupt as usual."""
    received: list[int] = []

    def note(number: int, frame: object) -> None:
        received.append(number)
        raise KeyboardInterrupt

    signal.signal(signal.SIGINT, note)
    return received


def _fail(message: str, code: int) -> None:
    if "--json" in sys.argv:
        typer.echo(json.dumps({"error": message}))
    typer.echo(f"error: {message}", err=True)
    sys.exit(code)
