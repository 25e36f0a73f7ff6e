"""`import instobj`: names that load when they are used, their examples, and what they give."""

import ast
import doctest
import inspect
from dataclasses import replace
from operator import attrgetter
from pathlib import Path

import magpylib
import numpy as np
import pytest

import instobj
from design.errors import InputError
from design.layout.places.positions import magnet_layout
from design.spec.object import ObjectSpec
from estimator.frames.dataset import save_frames
from estimator.inversion.storage import save_inversion
from instobj.store import readers
from tests.support.mechanics.inverted import inverted
from tests.support.objects.tiny_cube import lend_mechanics, tiny_cube

INIT = Path(instobj.__file__)
TINY = tiny_cube()


def test_every_public_name_is_there_and_listed():
    assert 15 <= len(instobj.__all__) <= 30
    assert set(instobj.__all__) <= set(dir(instobj))
    for name in instobj.__all__:
        assert getattr(instobj, name).__name__.split(".")[-1] == name


def test_type_checkers_and_the_interpreter_find_a_name_in_the_same_module():
    tree = ast.parse(INIT.read_text(encoding="utf-8"))
    block = next(node for node in tree.body if isinstance(node, ast.If))
    seen = {(one.module, alias.name) for one in block.body for alias in one.names}
    assert seen == {(module, name) for name, module in instobj.HOME_OF.items()}
    assert sorted(instobj.HOME_OF) == sorted(instobj.__all__)


def test_a_name_that_is_not_there_is_an_attribute_error():
    with pytest.raises(AttributeError, match="has no attribute 'load_specification'"):
        instobj.load_specification  # noqa: B018


@pytest.fixture(scope="module")
def place(tmp_path_factory):
    """A working folder with a store, and the data set that the examples read."""
    folder = tmp_path_factory.mktemp("examples")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setenv("INSTOBJ_STORE", str(folder / "store"))
        lend_mechanics(folder / "store")
        save_frames(instobj.Run(TINY).frames, "frames.nc")
        save_inversion(inverted(), "contacts.nc")
        yield folder


def documented():
    """Dotted names below `instobj` whose documentation is this library's own."""
    things = {name: getattr(instobj, name) for name in instobj.__all__}
    modules = {name: thing for name, thing in things.items() if inspect.ismodule(thing)}
    own = [n for n, thing in things.items() if getattr(thing, "__module__", "")[:8] == "instobj."]
    return own + [f"{name}.{one}" for name, module in modules.items() for one in module.__all__]


@pytest.mark.parametrize("name", documented())
def test_the_example_of_a_name_gives_what_it_says(name, place):
    thing = attrgetter(name)(instobj)
    doc = inspect.getdoc(thing) or ""
    returned = [] if inspect.isclass(thing) else ["Returns"]
    for heading in ("Parameters", *returned, "Raises", "Examples"):
        assert f"\n{heading}\n---" in doc, f"{name} has no section {heading}"
    tests = doctest.DocTestFinder(recurse=False).find(thing, name, globs={})
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    for one in tests:
        runner.run(one)
    assert runner.summarize(verbose=False).failed == 0


@pytest.mark.parametrize(
    "magnets",
    [
        {"diameter_mm": 5.0, "height_mm": 2.0},
        {"shape": "block", "size_mm": (5.0, 3.0), "height_mm": 2.0},
    ],
    ids=["disk", "block"],
)
def test_the_field_of_the_magnets_is_that_of_magpylib(magnets):
    spec = ObjectSpec.model_validate(
        {
            "name": "field",
            "magnets": magnets
            | {"positions_mm": [[2.0, -1.0], [-9.0, 7.0]], "tilt_deg": [[8, -5], [0, 12]]},
        }
    )
    points = np.array([[3.0, -2.0, 5.0], [30.0, 4.0, -6.0], [-1.0, 0.5, 28.0]])
    layout = magnet_layout(spec)
    expected = np.zeros((3, 3))
    for centre, axis, side in zip(layout.centre_mm, layout.axis, layout.side, strict=True):
        turn = np.column_stack([side, np.cross(axis, side), axis])
        edges_mm = (5.0,) if spec.magnets.shape == "disk" else (5.0, 3.0)
        j, height = instobj.field.polarization(1.43, (*edges_mm, 2.0)), 2e-3
        if spec.magnets.shape == "disk":
            source = magpylib.magnet.Cylinder(polarization=(0, 0, j), dimension=(5e-3, height))
        else:
            source = magpylib.magnet.Cuboid(polarization=(0, 0, j), dimension=(5e-3, 3e-3, height))
        expected += (turn @ source.getB((points - centre) @ turn * 1e-3).T).T
    field = instobj.magnet_field(spec, points)
    assert field.dims == ("point", "axis")
    assert field.attrs["units"] == "T"
    np.testing.assert_allclose(field.values, expected, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("points", [[0.0, 0.0, 1.0], [[0.0, 1.0]], [[0.0, 0.0, np.nan]]])
def test_points_of_another_shape_are_refused(points):
    with pytest.raises(InputError, match=r"points_mm must be finite numbers of shape \(point, 3\)"):
        instobj.magnet_field(ObjectSpec(name="cube"), points)


def test_results_have_named_axes_and_units(place):
    run = instobj.Run(TINY)
    bound = run.scores.position_bound_mm
    assert bound.dims == ("face", "place")
    assert bound.shape == (1, 9)
    assert bound.attrs["units"] == "mm"
    at_corner = bound.sel(face=1).where((bound.x_mm == 6.0) & (bound.y_mm == -6.0), drop=True)
    assert at_corner.size == 1
    assert run.presses.motion.dims == ("face", "place", "step", "magnet", "component")
    assert run.presses.sizes["step"] == run.signals.sizes["step"] == 2
    assert run.signals.delta_counts.attrs["units"] == "count"


def test_signals_and_presses_of_a_run_tell_of_the_same_forces(place):
    run = instobj.Run(TINY)
    for x, y in ((-6.0, 0.0), (6.0, -6.0)):
        ours, theirs = (
            data.force_n.values[0, (data.x_mm.values == x) & (data.y_mm.values == y), -1]
            for data in (run.signals, run.presses)
        )
        np.testing.assert_allclose(ours, theirs, rtol=1e-12)


def test_a_face_without_an_estimator_is_told_with_those_that_have_one(place):
    with pytest.raises(InputError, match=r"no estimator of face 3. Give one of the faces \[1\]"):
        instobj.Run(TINY).estimator(face=3)


@pytest.mark.parametrize("specs", [[], [TINY, TINY]], ids=["none", "one name twice"])
def test_objects_to_compare_need_a_name_each(specs):
    with pytest.raises(InputError, match="need a name each"):
        instobj.compare(specs)


@pytest.mark.parametrize("ask", [instobj.check, instobj.Run], ids=["check", "Run"])
def test_an_object_made_in_python_that_does_not_fit_is_refused(ask):
    thick = ObjectSpec.model_validate({"name": "thick", "shell": {"thickness_mm": 30.0}})
    with pytest.raises(instobj.SpecError):
        ask(thick)


def test_a_caller_can_tell_what_went_wrong(tmp_path):
    family = (
        *(instobj.SpecError, instobj.RecordingError, instobj.StoreError, instobj.SolverError),
        instobj.InputError,
    )
    assert all(issubclass(one, instobj.InstobjError) for one in family)
    (tmp_path / "cube.toml").write_text('name = "cube"\nshel = 3\n')
    with pytest.raises(instobj.SpecError, match="shel is not a key"):
        instobj.load_spec(tmp_path / "cube.toml")
    with pytest.raises(instobj.SpecError, match=r"shel is not a key\. Did you mean 'shell'"):
        instobj.ObjectSpec(name="cube", shel=3)
    with pytest.raises(
        instobj.SpecError, match=r"equal to 0\.3 and less than or equal to 200; got -9"
    ):
        instobj.ObjectSpec(name="cube", shell={"thickness_mm": -9})
    (tmp_path / "press.csv").write_text("a,b\n1,2\n")
    with pytest.raises(instobj.RecordingError, match=r"press\.csv"):
        instobj.read_recording(tmp_path / "press.csv")


def test_what_a_notebook_shows_is_short_and_a_path_is_no_data(place):
    frames, run = instobj.load_frames("frames.nc"), instobj.Run(TINY)
    assert repr(frames).startswith(f"FrameSet (simulated): {len(frames)} frames, ")
    assert repr(run) == f"Run of {TINY.name} in {run.root}: nothing asked for yet"
    assert len(repr(frames)) < 300
    with pytest.raises(
        instobj.InputError, match=r"got str\. Read a file with instobj\.read_recording"
    ):
        instobj.fit_estimator("frames.nc", 1)
    with pytest.raises(instobj.InputError, match=r"face 9 .* it has \[1\]\. Choose"):
        instobj.fit_estimator(frames, 9, {"history_frames": 2})


def test_an_estimator_reads_the_same_from_its_file(place):
    frames = instobj.load_frames("frames.nc")
    model = instobj.fit_estimator(frames, 1, {"epochs": 1, "hidden_units": [8]})
    instobj.save_model(model, "mine.safetensors")
    again = instobj.predict(instobj.load_model("mine.safetensors"), frames)
    np.testing.assert_array_equal(again.force_n, instobj.predict(model, frames).force_n)
    with pytest.raises(instobj.SpecError, match=r"epoch is not a key\. Did you mean 'epochs'"):
        instobj.fit_estimator(frames, 1, {"epoch": 1})


def test_a_frame_that_lacks_a_reading_is_read_as_nan_and_the_others_as_before(place):
    frames = instobj.load_frames("frames.nc")
    model = instobj.fit_estimator(frames, 1, {"epochs": 1, "hidden_units": [8]})
    counts = frames.signal_counts.copy()
    counts[5, 0, 0, 2] = np.nan
    sound, found = (
        instobj.predict(model, frames),
        instobj.predict(model, replace(frames, signal_counts=counts)),
    )
    told = np.arange(len(frames)) != 5
    for name, values in vars(found).items():
        assert np.isnan(values[5]).all()
        np.testing.assert_allclose(values[told], getattr(sound, name)[told], rtol=1e-4, atol=1e-5)
    counts[:, 0, 0, 2] = np.nan
    with pytest.raises(instobj.InputError, match=r"channels F1-Z1, .* miss readings"):
        instobj.predict(model, replace(frames, signal_counts=counts))


def test_a_run_leaves_no_file_that_is_not_declared(place):
    """Those of the response operator are declared by the room that writes them, as one folder."""
    instobj.Run(TINY).read(readers.SCORES)
    undeclared = []
    for path in (place / "store").glob("*/*/**/*"):
        stage, _, *name = path.relative_to(place / "store").parts
        files = [file for file in vars(readers).values() if isinstance(file, readers.ResultFile)]
        patterns = [file.name for file in files if file.stage == stage]
        if path.is_file() and not any(Path(*name).match(pattern) for pattern in patterns):
            undeclared.append("/".join((stage, *name)))
    of_the_store = {path for path in undeclared if path.endswith("/stage.json")}
    assert set(undeclared) - of_the_store <= {
        "response/compliance.npy",
        "coarse_response/compliance.npy",
    } | {path for path in undeclared if path.startswith("build/")}
