"""The gallery's scripts run in their quick form, and find what their text says."""

import ast
import runpy
import sys
import tomllib
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
import pytest

from tests.support.objects.tiny_cube import lend_mechanics
from tests.support.pages import ROOT

GALLERY = ROOT / "examples" / "gallery"
SCRIPTS = sorted(GALLERY.glob("[0-9][0-9]_*.py"))
LIBRARIES = {"instobj", "numpy", "matplotlib"}


@pytest.fixture(scope="module")
def store(tmp_path_factory):
    """One store for all scripts, with the small cube's mechanics."""
    folder = tmp_path_factory.mktemp("store")
    lend_mechanics(folder)
    return folder


@pytest.fixture
def run_script(store, monkeypatch):
    """Run a script in its quick form; its variables, once it has drawn something."""

    def run(number: int) -> dict:
        path = next(path for path in SCRIPTS if path.name.startswith(f"{number:02}_"))
        monkeypatch.setenv("INSTOBJ_STORE", str(store))
        monkeypatch.setenv("INSTOBJ_GALLERY", "quick")
        monkeypatch.chdir(GALLERY)
        monkeypatch.setattr(sys, "argv", [str(path)])
        monkeypatch.setattr(plt, "show", lambda: None)
        plt.close("all")
        try:
            variables = runpy.run_path(str(path), run_name="__main__")
            assert plt.get_fignums()
        finally:
            plt.close("all")
        return variables

    return run


def test_there_are_eight_scripts_or_more():
    assert len(SCRIPTS) >= 8


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_a_script_uses_the_public_library_alone(path):
    tree = ast.parse(path.read_text())
    imported = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            imported.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            imported.add(str(node.module))
    tops = {name.partition(".")[0] for name in imported}
    assert tops <= LIBRARIES | set(sys.stdlib_module_names)
    assert not [name for name in imported if name.startswith("instobj.")]


def test_the_small_cube_is_small():
    spec = tomllib.loads((GALLERY / "small_cube.toml").read_text())
    assert spec["mesh"]["edge_mm"] == 8.0
    assert spec["mesh"]["surface_edge_mm"] == 3.0


def test_a_first_object_has_a_bound_at_every_contact_location(run_script):
    found = run_script(1)
    assert found["bound_mm"].shape == (1, len(found["run"].scores.place))
    assert np.all((found["bound_mm"] > 0) & (found["bound_mm"] < 42))


def test_a_fourth_sensor_locates_better(run_script):
    three, four = run_script(2)["bounds_mm"].values()
    assert np.median(four) < np.median(three)
    assert four.max() < three.max()


def test_a_deeper_press_takes_more_force_and_changes_more(run_script):
    found = run_script(3)
    assert np.all(np.diff(found["force_n"]) > 0)
    size = np.linalg.norm(found["own"], axis=(1, 2))
    assert np.all(np.diff(size) > 0)


def test_the_bound_by_hand_ranks_contact_locations_as_the_library_does(run_script):
    """Differences over 3 mm leave a factor at the border; the pattern stays."""
    found = run_script(4)
    logarithms = [np.log(found[name].ravel()) for name in ("by_hand_mm", "library_mm")]
    assert np.corrcoef(logarithms)[0, 1] > 0.75
    assert 0.6 < np.median(found["ratio"]) < 1.4


def test_a_search_scores_every_trial(run_script):
    found = run_script(5)
    assert len(found["found_mm"]) == found["TRIALS"] == 2
    assert np.isfinite(found["found_mm"]).any()
    assert found["found_mm"][found["best"]] == found["found_mm"].min()


def test_a_recording_that_was_written_trains_an_estimator(run_script):
    found = run_script(6)
    assert not found["recording"].report.faults
    assert len(np.unique(found["frames"].place_id)) == 1 + 16
    assert found["metrics"].total_force_error_percent < 20
    assert found["metrics"].location_error_px < 2


def test_a_scan_becomes_parts_a_map_and_a_price(run_script):
    scan = run_script(7)
    assert {"core", "shell"} <= {part.name for part in scan["parts"]}
    assert np.all(scan["run"].scores.position_bound_mm > 0)
    assert 20 < scan["price_eur"] < 1000


def test_the_scanned_magnet_has_the_polarization_that_another_code_fits(run_script):
    """Magpylib's documentation fits 1126 mT to the whole scan."""
    found = run_script(8)
    assert found["numbers"][6] == pytest.approx(1.126, abs=0.002)
    assert np.sqrt(np.mean(found["left_mt"] ** 2)) < 0.05
    assert found["spread_t"] < 0.02


def test_the_scanned_magnet_is_as_strong_as_a_weak_one_of_its_grade(run_script):
    """Weaker than the guaranteed remanence, and within 1 % of what such a magnet is to have."""
    found = run_script(8)
    weakest, nominal = found["predicted_mt"][1.05]
    assert weakest == pytest.approx(1170 / (1 + 0.05 * 0.634568), rel=1e-6)
    assert nominal / weakest == pytest.approx(1220 / 1170, rel=1e-9)
    polarization_mt = 1e3 * found["numbers"][6]
    assert abs(polarization_mt / weakest - 1) < 0.01
    assert polarization_mt < 0.965 * 1170, (
        "without its own field the magnet would be out of its grade"
    )


def test_a_policy_that_feels_squeezes_less_and_seldom_drops(run_script):
    grips = run_script(9)
    assert grips["judged_n"].mean() < 0.7 * grips["fixed_n"].mean()
    assert np.mean(grips["judged_n"] >= grips["needed_n"]) > 0.95


def test_the_scan_beside_the_script_is_the_published_one():
    published = ROOT.parent / "shared" / "data" / "magnet-scan" / "Bomatec_LD025_scan0.npy"
    if not published.exists():
        pytest.skip(f"{published} is not here")
    copied = np.loadtxt(GALLERY / "data" / "magnet_scan.csv", delimiter=",", skiprows=1)
    np.testing.assert_allclose(copied[:, 1:], np.load(published)[::2], atol=5e-5)


def test_data_beside_the_scripts_carry_their_licence():
    licence = (GALLERY / "data" / "LICENSE").read_text()
    for path in (GALLERY / "data").glob("*.csv"):
        assert path.name in licence


def test_files_beside_the_scripts_are_used():
    text = "".join(path.read_text() for path in SCRIPTS)
    beside = [path for path in GALLERY.rglob("*") if path.suffix in (".toml", ".csv")]
    assert beside
    assert not [path for path in beside if Path(path).name not in text]


def test_the_soft_pad_is_ranked_gentler_by_what_the_object_felt(run_script):
    found = run_script(10)
    assert 0 < found["low"] < found["high"]
    # the overshoot of the hard pad, which the frames do not name
    expected = 4.0 * (found["GRIPPERS"]["hard pad"][1] - found["GRIPPERS"]["soft pad"][1])
    assert found["low"] - 0.3 < expected < found["high"] + 0.3


def test_a_reader_that_knows_turning_reads_no_contact_where_nothing_touches(run_script):
    """The other one reads several, and more than the finger's force."""
    grasp = run_script(11)
    is_pressed = grasp["true_n"] > 0
    still_n, turned_n = (grasp["read_n"][name] for name in ("stands still", "is turned"))
    assert np.mean(turned_n[~is_pressed] > 0) <= 0.01
    assert np.mean(still_n[~is_pressed] > 0) > 0.1
    assert abs(turned_n[is_pressed].mean() - 5.0) < 0.3
    away = (grasp["field_ut"] - grasp["true_ut"]) / grasp["sigma_ut"]
    assert np.mean(np.abs(away) < 1.645) > 0.85
