"""A table is the same as a file and as text."""

from design.tables import table_text, write_table

HEADER = ("place", "force_n")
ROWS = [("edge", 1.5), ("face, upper", 2)]


def test_file_and_text_are_the_same(tmp_path):
    write_table(tmp_path / "table.csv", HEADER, ROWS)
    assert (tmp_path / "table.csv").read_bytes() == table_text(HEADER, ROWS).encode()


def test_fields_with_commas_are_quoted_and_lines_end_in_a_line_feed():
    assert table_text(HEADER, ROWS) == 'place,force_n\nedge,1.5\n"face, upper",2\n'
