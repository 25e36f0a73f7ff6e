"""Tables of numbers as other people write them."""

import gzip

import numpy as np
import pytest

from design.errors import RecordingError
from estimator.adoption.text_table import read_text_table

NUMBERS = np.array([[1.5, -2, 3, 4, 5, 6], [7, 8, 9, 10, 11, 12.25], [0, 1, 0, -1, 0, 1]])


def written(folder, text, name="log.txt"):
    path = folder / name
    path.write_text(text)
    return path


def rows(form):
    return "\n".join(form.format(*row) for row in NUMBERS.tolist())


FORMS = {
    "comma": rows("{},{},{},{},{},{}"),
    "trailing comma": rows("{},{},{},{},{},{},"),
    "blanks": rows("  {} {}\t {}  {} {} {}"),
    "bars": rows("|{}|{}|{}|{}|{}|{}|").replace("\n|", "\n").removeprefix("|"),
    "tuples": rows("[({}, {}, {}), ({}, {}, {})]"),
    "named tuples": rows("array('f', [{}, {}, {}, {}, {}, {}])"),
    "labels before tuples": rows("{} {} {} [({}, {}, {})]"),
    "tuples without commas between": rows("({}, {}, {}) ({}, {}, {})"),
    "labels behind semicolons": rows("{};{};{};[{}  {} {}]"),
    "dictionaries": rows("{{'a': {}, 'b': {}, 'c': [({}, {}, {})], 'd': {}}}"),
    "JSON": rows('{{"a": {}, "b": {}, "c": [{}, {}, {}], "d": {}}}'),
    "serial monitor": rows("12:00:01.250 -> {},{},{},{},{},{}"),
    "keys": rows("a: {}, b: {}, c: {}, d={}, e={}, f={}"),
    "header and comment": "# made today\na,b,c,d,e,f\n" + rows("{},{},{},{},{},{}"),
    "messages": "".join(
        "header:\n  frame_id: 'base'\ndata:\n" + "".join(f"- {v}\n" for v in row) + "---\n"
        for row in NUMBERS.tolist()
    ),
    "decimal commas": rows("{};{};{};{};{};{}").replace(".", ","),
    "decimal commas by blanks": "\n".join(
        " ".join(f"{v:.2f}".replace(".", ",") for v in row) for row in NUMBERS.tolist()
    ),
}


@pytest.mark.parametrize("form", FORMS)
def test_the_same_numbers_come_out_of_every_form(tmp_path, form):
    table = read_text_table(written(tmp_path, FORMS[form]))
    np.testing.assert_array_equal(table.values, NUMBERS)


def test_a_header_names_columns_and_packing_changes_nothing(tmp_path):
    text = "Face;X1;Y1\n" + "\n".join("1;2;3" for _ in range(5))
    plain = read_text_table(written(tmp_path, text))
    packed = tmp_path / "log.csv.gz"
    packed.write_bytes(gzip.compress(text.encode()))
    assert plain.names == ("Face", "X1", "Y1")
    np.testing.assert_array_equal(read_text_table(packed).values, plain.values)


@pytest.mark.parametrize("between", [" ", "T"])
def test_stamps_become_seconds_and_text_is_left_out_with_a_note(tmp_path, between):
    text = "\n".join(f"2024-06-01{between}12:00:{s:02d},left,{s}" for s in range(20))
    table = read_text_table(written(tmp_path, text))
    np.testing.assert_allclose(np.diff(table.values[:, 0]), 1.0)
    assert table.values.shape == (20, 2)
    assert any("text left out: 2 ('left')" in note for note in table.notes)


def test_values_that_json_leaves_out_are_empty_cells(tmp_path):
    text = "\n".join(f'{{"a": {k}, "b": [{"null" if k == 3 else k}, 5]}}' for k in range(9))
    values = read_text_table(written(tmp_path, text)).values
    assert np.isnan(values[3, 1])
    assert np.isfinite(np.delete(values, 3, axis=0)).all()


def test_few_damaged_rows_are_left_out_and_named(tmp_path):
    lines = [f"{k},{k},{k}" for k in range(100)]
    lines[40] = "40,4"
    table = read_text_table(written(tmp_path, "\n".join(lines)))
    assert len(table.values) == 99
    assert any("1 damaged rows left out, first data row 40" in note for note in table.notes)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "empty"),
        (b"only one line", "1 rows"),
        (b"\x80\x04\x95pickle\x00", "no text"),
        (gzip.compress(b"1,2,3\n" * 9, mtime=0)[:-12], "damaged"),
        (b"some words\nand others\nwithout any number\n", "no rows of"),
        (b"\n".join(b"1," * (k % 7) + b"2" for k in range(60)), "no rows of"),
    ],
)
def test_what_is_no_table_is_refused_with_the_way_out(tmp_path, content, message):
    path = tmp_path / "log"
    path.write_bytes(content)
    with pytest.raises(RecordingError, match=message):
        read_text_table(path)


def test_a_small_archive_of_endless_text_is_not_unpacked(tmp_path, monkeypatch):
    monkeypatch.setattr("estimator.adoption.text_table.MOST_BYTES", 10_000)
    path = tmp_path / "bomb.gz"
    path.write_bytes(gzip.compress(b"1,2,3\n" * 100_000))
    with pytest.raises(RecordingError, match="Split it"):
        read_text_table(path)
