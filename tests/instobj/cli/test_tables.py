"""Tables on a terminal of 80 columns: nothing is cut or lost; many files are told in a few lines."""

import pytest

from instobj.cli.tables import print_result
from instobj.commands.recorded.validate import agreement_rows
from instobj.commands.run import check_specifications
from tests.support.pages import ROOT

MODELS = ("heatmap", "position", "pre-trained")
SCORES = ("A_sim", "paper A_sim", "E_loc px", "paper E_loc px", "E_loc x px", "E_loc y px")


@pytest.fixture
def printed(monkeypatch, capsys):
    """Function rows → lines of their table, without its title and rule."""
    monkeypatch.setenv("COLUMNS", "80")

    def lines(rows):
        print_result({"tables": {"title": rows}})
        shown = capsys.readouterr().out.splitlines()
        assert max(map(len, shown)) <= 80
        return [line.split() for line in shown[1:] if line.strip() and "─" not in line]

    return lines


def words_of(rows):
    return {word for row in rows for pair in row.items() for text in pair for word in text.split()}


def test_sixteen_columns_of_six_rows_are_turned_and_keep_their_words(printed):
    scores = (*SCORES, *(f"{name} of all" for name in SCORES), "distance px", "non-contact")
    rows = [
        {"model": model, "places": places} | dict.fromkeys(scores, f"{k}.25")
        for model in MODELS
        for k, places in enumerate(("seen", "unseen"))
    ]
    shown = printed(rows)
    assert ["places", *["seen", "unseen"] * 3] in shown
    assert ["non-contact", *["0.25", "1.25"] * 3] in shown
    assert words_of(rows) <= {word for line in shown for word in line}


def test_columns_that_fit_when_their_names_are_broken_at_spaces_stay_columns(printed):
    names = ("data", "training frames", *SCORES, "total force %", "E_f %")
    rows = [dict.fromkeys(names, f"{k}/256") for k in range(3)]
    shown = printed(rows)
    assert shown[-3:] == [[f"{k}/256"] * len(names) for k in range(3)]
    assert words_of(rows) <= {word for line in shown for word in line}


def test_few_columns_are_turned_where_their_names_do_not_fit(printed):
    names = [f"median_position_bound_{k}_mm" for k in range(4)]
    rows = [{"object": f"cube_{k}"} | dict.fromkeys(names, f"{k}.5") for k in range(2)]
    assert printed(rows) == [
        ["object", "cube_0", "cube_1"],
        *([name, "0.5", "1.5"] for name in names),
    ]


def test_what_fits_neither_way_is_folded_and_nothing_is_lost(printed):
    path = "/a/folder" * 12
    shown = printed([{"trials": "64", "kept in": path}])
    assert path in "".join(word for line in shown for word in line)


ROBUST = ("tolerance", "spread mm", "spread N", "share %", "largest", "place", "worst mm")


@pytest.mark.parametrize("count", [2, 12, 40])
def test_numbers_are_never_broken_whatever_else_is(printed, count):
    """As of `robustness`: long names beside numbers with exponents, in 80 columns."""
    values = [1.47e-7 * (k + 1) for k in range(count)]
    rows = [
        {f"{name}_of_the_whole_object": value for name in (*ROBUST, *(f"{n}_2" for n in ROBUST))}
        for value in values
    ]
    shown = {word for line in printed(rows) for word in line}
    assert {f"{value:.3g}" for value in values} <= shown


def test_words_are_not_broken_where_two_tables_hold_them(printed):
    """The robustness table of a box: 'remanence' and 'temperature' were cut in pieces of six."""
    names = ("earth's field 50 µT, turned", "remanence 2 %", "temperature 5 K")
    figures = (
        "localisation error mm",
        "worst mm",
        "force error N",
        "worst N",
        "ΔS %",
        "rest counts",
    )
    rows = [
        {"tolerance": name}
        | dict.fromkeys(figures, 7.67e-7)
        | {"position bound %": 1.05e-10, "force bound %": 1.65e-9}
        for name in names
    ]
    words = {word for line in printed(rows) for word in line}
    assert {"remanence", "temperature", "tolerance", "counts", "7.67e-07", "1.65e-09"} <= words


@pytest.fixture
def of_networks():
    """The table of `train` on a recording: rows named by face and model, too wide for 80 columns."""
    figures = ("similarity", "shift px", "force error %", "force error N", "total force error N")
    more = ("rest read", "frames pressed", "frames at rest")
    return [
        {"face": face, "model": model} | dict.fromkeys((*figures, *more), 0.01234 * face)
        for face in (1, 2, 3, 4, 5)
        for model in ("network", "linear", "mean map")
    ]


def test_every_part_of_a_split_table_begins_with_what_names_its_rows(printed, of_networks):
    """The second part had the face without the model: which of three rows was which could not be seen."""
    shown = printed(of_networks)
    for face in "12345":
        for model in ("network", "linear", "mean"):
            rows = [line for line in shown if line[:2] == [face, model]]
            assert len(rows) == 2, "one in each part"
            assert {len(row) for row in rows} <= {6, 7}


def test_the_title_of_a_split_table_is_printed_once(monkeypatch, capsys, of_networks):
    monkeypatch.setenv("COLUMNS", "80")
    title = "force maps of held-out presses"
    print_result({"tables": {title: of_networks}})
    shown = capsys.readouterr().out.splitlines()
    assert [line.rstrip() for line in shown].count(title) == 1
    assert sum("─" in line for line in shown) == 2


def test_a_turned_table_is_headed_by_the_values_of_its_first_column(printed):
    """Contacts' `tips a face` was headed 1: 1, 2: 1, 3: 1."""
    figures = [f"figure of the {name} %" for name in ("first", "second", "third", "fourth")]
    figures += [f"{name} in 90 % interval" for name in ("force", "place", "turn")]
    rows = [
        {"tips a face": tips, "force": force} | dict.fromkeys(figures, "0.333333333")
        for tips, force in ((1, "light"), (1, "firm"), (2, "light"))
    ]
    assert printed(rows)[:2] == [
        ["tips", "a", "face", "1", "1", "2"],
        ["force", "light", "firm", "light"],
    ]


def test_a_single_row_whose_names_do_not_fit_a_line_is_a_list(printed):
    """Headings of predictions stood in lines of one or two words."""
    names = ("frames", "frames that lack a reading", "frames before a zero", "largest force N")
    row = dict.fromkeys((*names, "force interval held"), 7)
    assert printed([row]) == [[*name.split(), "7"] for name in row]
    assert printed([{"frames": 7, "contacts": 2}]) == [["frames", "contacts"], ["7", "2"]]


def test_rounding_errors_are_zero_and_what_is_not_known_a_dash(printed):
    shown = printed([{"a": -9.09e-13, "b": float("nan"), "c": 1.47e-7, "d": -0.0, "e": None}])
    assert shown[-1] == ["0", "–", "1.47e-07", "0", "–"]


def written(names):
    return [{"path": name, "bytes": 1000 * k} for k, name in enumerate(names, start=1)]


def test_many_files_are_told_as_folders_and_the_page_to_open_last(monkeypatch, capsys):
    monkeypatch.setenv("COLUMNS", "80")
    maps = [f"runs/cube/maps/force_bound_face_{face}.png" for face in range(1, 41)]
    parts = [f"cad_out/cube/part_{k}.stl" for k in range(8)]
    first = ["runs/cube/report.html", "runs/cube/metrics/held_out.png", "cad_out/cube/parts.png"]
    print_result({"files": written([*maps, *parts, *first])})
    shown = capsys.readouterr().out.splitlines()
    assert shown == [
        "wrote 9 files, 0.4 MB, to cad_out/cube/",
        "wrote 42 files, 0.9 MB, to runs/cube/",
        "open  runs/cube/report.html",
    ]


def test_a_few_files_are_named_one_by_one_and_whole(monkeypatch, capsys):
    monkeypatch.setenv("COLUMNS", "80")
    names = ["runs/cube/" + "a_long_folder/" * 8 + "slip.json", "runs/cube/slip.png"]
    print_result({"files": written(names)})
    assert capsys.readouterr().out.splitlines() == [
        f"wrote {names[0]} (1.0 kB)",
        "wrote runs/cube/slip.png (2.0 kB)",
    ]


def test_check_tells_what_of_the_surface_the_locations_cover(monkeypatch, capsys):
    monkeypatch.setenv("COLUMNS", "80")
    print_result(check_specifications([ROOT / "examples" / "paper_cube.toml"], []))
    shown = capsys.readouterr().out.splitlines()
    assert max(map(len, shown)) <= 80
    (told,) = [line.strip() for line in shown if "contact locations cover" in line]
    assert told == "980 contact locations cover 100 % of the sensed surface, 9 mm² each"


def test_a_table_without_rows_says_so(capsys):
    """Bring-up of a sound object has nothing to put right, and ended with a traceback."""
    print_result({"tables": {"what to put right": []}})
    assert capsys.readouterr().out.strip() == "what to put right: nothing"


def test_what_some_rows_do_not_have_is_left_open(printed):
    assert printed([{"figure": "a", "value": 1.0}, {"figure": "b", "p": 0.5}]) == [
        ["figure", "value", "p"],
        ["a", "1", "–"],
        ["b", "–", "0.5"],
    ]


def test_agreement_with_recordings_is_printed_whole(printed):
    figure = {"value": 0.75, "null": 0.25, "p": 0.0001, "exchanges": 40320}
    figures = dict.fromkeys(("cosine", "signs", "size_spread", "modulus_spread"), figure)
    found = figures | {"what": "face 3", "size_ratio": 1.13, "modulus_mpa": 0.36}
    shown = printed(agreement_rows({"agreement": [found]}))
    assert shown[0][-4:] == ["value", "null", "p", "exchanges"]
    assert [line[-4:] for line in shown[1:] if "cosine" in line] == [
        ["0.75", "0.25", "0.0001", "40320"]
    ]
    assert [line[-4:] for line in shown[1:] if "MPa" in line] == [["0.36", "–", "–", "–"]]
