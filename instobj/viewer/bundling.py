"""The page's program as one file: made by maintainers from its sources, checked by a test.

`python -m instobj.viewer.bundling` installs the exact versions of package-lock.json into a temporary
folder (Node and npm; no install scripts run) and writes `bundle.js`, whose first line holds the
digest of everything that it was made from, and `LICENSES.txt`.
"""

from __future__ import annotations

import hashlib
import shutil
import subprocess
import tempfile
from pathlib import Path

from design.files import atomic_path

ROOM = Path(__file__).parent
BUNDLE = ROOM / "bundle.js"
_LICENSES = ROOM / "LICENSES.txt"
_ESBUILD = (
    *("--bundle", "--minify", "--format=iife", "--global-name=instobjViewer"),
    *("--target=es2022", "--legal-comments=none"),
)


def digest_of_sources() -> str:
    """SHA-256 over the sources, the lock file and the options of the bundler."""
    digest = hashlib.sha256(" ".join(_ESBUILD).encode())
    for path in (ROOM / "package.json", ROOM / "package-lock.json", *sources()):
        digest.update(path.name.encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()


def sources() -> list[Path]:
    """The page's own modules, in the order of their names."""
    return sorted((ROOM / "source").glob("*.js"))


def digest_in_bundle() -> str:
    """Return what the committed bundle says that it was made from."""
    with BUNDLE.open(encoding="utf-8") as file:
        return file.readline().removeprefix("// made from ").strip()


def program() -> str:
    """The bundle as it stands in a page."""
    return BUNDLE.read_text(encoding="utf-8")


def bundled(folder: Path) -> str:
    """Install into a folder and bundle there; needs Node, npm and its registry."""
    for name in ("package.json", "package-lock.json"):
        shutil.copy(ROOM / name, folder)
    shutil.copytree(ROOM / "source", folder / "source")
    npm = ("npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--silent")
    subprocess.run(npm, cwd=folder, check=True)
    esbuild = folder / "node_modules" / ".bin" / "esbuild"
    made = subprocess.run(
        (str(esbuild), "source/main.js", *_ESBUILD),
        cwd=folder,
        check=True,
        capture_output=True,
        text=True,
    )
    return f"// made from {digest_of_sources()}\n{made.stdout}"


def _used(modules: Path) -> list[tuple[str, Path]]:
    """Packages that are in the bundle, and where they lie."""
    return [("three.js", modules / "three"), ("uPlot", modules / "uplot")]


def main() -> None:
    """Write the bundle and the licences of what is in it."""
    with tempfile.TemporaryDirectory() as folder:
        content = bundled(Path(folder))
        licenses = [
            f"{name}, in bundle.js:\n\n{(modules / 'LICENSE').read_text(encoding='utf-8')}"
            for name, modules in _used(Path(folder) / "node_modules")
        ]
    for path, text in ((BUNDLE, content), (_LICENSES, "\n".join(licenses))):
        with atomic_path(path) as temporary:
            temporary.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
