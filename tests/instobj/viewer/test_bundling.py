"""The page's program is the one that its sources make."""

import shutil

import pytest

from instobj.viewer import bundling


def test_the_bundle_was_made_from_these_sources_and_this_lock_file():
    assert bundling.digest_in_bundle() == bundling.digest_of_sources(), (
        "run python -m instobj.viewer.bundling"
    )


def test_the_digest_feels_every_source(tmp_path, monkeypatch):
    copy = tmp_path / "viewer"
    shutil.copytree(bundling.ROOM, copy)
    before = bundling.digest_of_sources()
    monkeypatch.setattr(bundling, "ROOM", copy)
    assert bundling.digest_of_sources() == before
    for path in (*bundling.sources(), copy / "package.json", copy / "package-lock.json"):
        kept = path.read_bytes()
        path.write_bytes(kept + b"\n")
        assert bundling.digest_of_sources() != before, path.name
        path.write_bytes(kept)


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("npm") is None, reason="needs npm and its registry")
def test_bundling_again_gives_the_committed_bundle(tmp_path):
    assert bundling.bundled(tmp_path) == bundling.program()
