"""`instobj docs`: every page of the site, and the gallery's scripts, by name."""

from instobj.commands.docs import page_names, page_text
from tests.support.pages import DOCS, ROOT, site_pages


def test_every_page_of_the_site_is_printed_but_its_index():
    """Measured pages, proofs and the gallery were on the site alone."""
    names = {page.relative_to(DOCS).with_suffix("").as_posix() for page in site_pages()}
    written = names - {"index", "reference/specification"} | {"specification"}
    scripts = {f"gallery/{path.stem}" for path in (ROOT / "examples/gallery").glob("[0-9]*.py")}
    shown = page_names()
    assert len(shown) == len(set(shown))
    assert set(shown) == written | scripts
    assert page_text("measured/grasps") == (DOCS / "measured" / "grasps.md").read_text()
    assert "Two designs compared" in page_text("gallery/02_two_designs")
