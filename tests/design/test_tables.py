"""A table is the same as a file and as text."""

import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as some

from design.tables import table_text, toml_text, write_records, write_table

HEADER = ("place", "force_n")
ROWS = [("edge", 1.5), ("face, upper", 2)]


def test_file_and_text_are_the_same(tmp_path):
    write_table(tmp_path / "table.csv", HEADER, ROWS)
    assert (tmp_path / "table.csv").read_bytes() == table_text(HEADER, ROWS).encode()


def test_fields_with_commas_are_quoted_and_lines_end_in_a_line_feed():
    assert table_text(HEADER, ROWS) == 'place,force_n\nedge,1.5\n"face, upper",2\n'


@pytest.mark.parametrize("text", ["=1+2", "+cmd", "-2 and more", "@SUM(A1)", "\t=1", "\r=1"])
def test_a_text_that_a_spreadsheet_would_work_out_begins_with_an_apostrophe(text, tmp_path):
    """In rows, headers and records: all tables are written in one place."""
    header, row = table_text([text, "b"], [[text, "c"]]).split("b\n", 1)
    assert header.strip('"').startswith(f"'{text}")
    assert row.strip('"').startswith(f"'{text}")
    write_records(tmp_path / "records.csv", [{text: 1.0, "name": text}])
    assert (tmp_path / "records.csv").read_text(encoding="utf-8").count("'") == 2


def test_numbers_stay_numbers_also_as_text():
    rows = [(-1.5, "-1.5", "+2e-3", "-inf", "a=b", "2 - 1")]
    assert table_text("abcdef", rows).splitlines()[1] == "-1.5,-1.5,+2e-3,-inf,a=b,2 - 1"


_TEXTS = some.text(some.characters(exclude_categories=["Cs"]))
_LEAVES = some.one_of(
    some.booleans(), some.integers(-(2**63), 2**63 - 1), some.floats(allow_nan=False), _TEXTS
)
_VALUES = some.recursive(
    _LEAVES, lambda inner: some.lists(inner) | some.dictionaries(_TEXTS, inner), max_leaves=20
)


@given(some.dictionaries(_TEXTS, _VALUES))
def test_what_is_written_as_toml_is_read_back(tables):
    assert tomllib.loads(toml_text(tables)) == tables
