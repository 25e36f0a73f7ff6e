"""`instobj score --also jaw`: what is known beside tips, and what is refused."""

from pathlib import Path

import pytest

from design.errors import InputError
from instobj.commands.comparison import score_designs

CUBE = Path(__file__).parents[3] / "examples" / "paper_cube.toml"


def test_only_jaws_are_known_beside_tips(tmp_path):
    with pytest.raises(InputError, match="--also 'ball' is not known"):
        score_designs([CUBE], ["ball"], tmp_path, [])
