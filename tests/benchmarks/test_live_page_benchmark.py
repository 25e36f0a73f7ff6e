"""The benchmark of the live page runs in a browser, and its figures hang together."""

import shutil

import pytest


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("chromium"), reason="no Chromium")
def test_quick_run_sees_pictures_with_the_camera_still_and_turned(quick_run):
    result, printed = quick_run("live_page", 1, ["live_page.json"])
    for state in ("still", "turned"):
        assert result["states"][state]["pictures_per_second"] > 1
        assert f"{state}: " in printed
    assert result["states"]["turned"]["objectDrawn"] > result["states"]["still"]["objectDrawn"]
