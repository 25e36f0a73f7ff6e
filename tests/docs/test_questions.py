"""Blocks of "How do I …?" work when they are pasted, and leave the files that the page names."""

import re
import shlex
import shutil

import pytest

from tests.support.cli import run
from tests.support.objects.tiny_cube import SMALL_CUBE, lend_mechanics
from tests.support.pages import DOCS, ROOT

PAGE = (DOCS / "questions.md").read_text()
SECTIONS = dict(re.findall(r"^## … (.*?)\?\n(.*?)(?=^## |\Z)", PAGE, re.MULTILINE | re.DOTALL))
LEAVES = {
    "see whether my edges are weak": ("runs/my_object/maps", "runs/my_object/scores.csv"),
    "know what to buy": ("orders.csv", "assembly.html"),
    "use my own STL": ("my_fruit.toml",),
    "read my own CSV files": ("runs/press/frames.nc",),
    "read it on my robot": ("runs/my_object/continuous/contacts.csv",),
}
"""Files that stand in a folder after a block, or in `cad_out/my_object`."""
SLOW = {"know what to buy", "use my own STL", "read it on my robot"}
"""They build parts or read many frames: from half a minute on."""
NOT_RUN = {"make it better"}
"""A search takes three quarters of an hour; `test_blocks` holds that its line is taken."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A small cube in place of the one that `instobj new` writes, and its mechanics."""
    here = tmp_path_factory.mktemp("questions")
    text = SMALL_CUBE.read_text().replace('name = "small_cube"', 'name = "my_object"')
    text = text[: text.index("[training]")]  # its networks: `instobj new` writes none
    (here / "my_object.toml").write_text(text)
    shutil.copytree(ROOT / "examples" / "bodies", here / "examples" / "bodies")
    lend_mechanics(here / ".instobj")
    return here


def paste(block, folder):
    """Run the lines of a block as a shell would; here documents become files."""
    for name, content in re.findall(r"^cat > (\S+) <<'END'\n(.*?)^END$", block, re.M | re.S):
        (folder / name).write_text(content)
    lines = re.sub(r"^cat > .*?^END$", "", block, flags=re.MULTILINE | re.DOTALL).splitlines()
    return [run(*shlex.split(line)[1:], cwd=folder) for line in filter(None, lines)]


def test_there_are_the_ten_tasks_each_with_a_block_first():
    assert len(SECTIONS) == 10
    assert set(LEAVES) | SLOW | NOT_RUN <= set(SECTIONS)
    for text in SECTIONS.values():
        assert text.startswith("```sh\n")
        assert "\n**You see** " in text
        assert re.search(r"^!\[.+\]\(.+\)$", text, re.MULTILINE)


def answers(slow):
    names = [name for name in SECTIONS if (name in SLOW) == slow and name not in NOT_RUN]
    return pytest.mark.parametrize("name", names)


def check_answer(name, folder, monkeypatch):
    monkeypatch.setenv("INSTOBJ_STORE", str(folder / ".instobj"))
    block = re.match(r"```sh\n(.*?)^```$", SECTIONS[name], re.MULTILINE | re.DOTALL)[1]
    for done in paste(block, folder):
        assert done.returncode == 0, done.stderr
        assert done.stdout.strip()
    for path in LEAVES.get(name, ()):
        assert (folder / path).exists() or (folder / "cad_out" / "my_object" / path).exists()


@answers(slow=False)
def test_a_quick_answer_works_when_it_is_pasted(name, folder, monkeypatch):
    check_answer(name, folder, monkeypatch)


@pytest.mark.slow
@answers(slow=True)
def test_a_slow_answer_works_when_it_is_pasted(name, folder, monkeypatch):
    check_answer(name, folder, monkeypatch)


def test_the_two_lines_before_all_blocks_work(tmp_path):
    block = re.search(r"```sh\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)[1]
    assert [done.returncode for done in paste(block, tmp_path)] == [0, 0]


def test_a_block_that_does_not_work_is_noticed(tmp_path):
    assert paste("instobj check none.toml\n", tmp_path)[0].returncode == 2
