"""The page of `instobj explore` in a notebook: its design and map are traits (anywidget)."""

from __future__ import annotations

import asyncio
import re
from collections.abc import Coroutine, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import traitlets

from design.errors import InstobjError
from design.spec_io import load_spec
from instobj.explore.design import design_of
from instobj.explore.engine import Explorer, open_shell
from instobj.explore.server import PAGE, Answers, Session
from instobj.report.widget import ObjectView


def _page_part(tag: str) -> str:
    """Return what stands in the first `tag` of the page."""
    text = re.search(rf"<{tag}>\n(.*?)</{tag}>", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert text is not None
    return re.sub(r"<script.*?</script>", "", text[1])


class DesignView(ObjectView):
    """A design that hands move in the view and code moves by `design`; `design_view` makes it.

    Attributes
    ----------
    design : tables as in a specification, with the positions of magnets and sensors (mm)
    figure, force_n : what the map shows: "position", "force" or "least", at one of the judged forces
    map : `values` at every place of every face, face by face (mm or N; None where there is none), and their
        `summary`; or an `error` that says what is wrong
    """

    # Rules of the page hold within the view alone.
    _css = f".explore-widget {{ {_page_part('style')} }}"
    markup = traitlets.Unicode(_page_part("body")).tag(sync=True)
    design = traitlets.Dict().tag(sync=True)
    figure = traitlets.Unicode("position").tag(sync=True)
    force_n = traitlets.Float().tag(sync=True)
    map = traitlets.Dict(read_only=True).tag(sync=True)
    request = traitlets.Int(0).tag(sync=True)

    def __init__(self, explorer: Explorer, source: Path) -> None:
        session, spec = Session(explorer, source), explorer.spec
        self._answers = Answers(session, ThreadPoolExecutor(1))
        self._tasks = set[asyncio.Task[None]]()
        super().__init__(
            scene=session.scene(spec), design=design_of(spec), force_n=explorer.first_force_n
        )
        self.on_msg(lambda _, message, __: self._begin(self._answer(message)))
        self.observe(
            lambda _: self._begin(self._judge()), ["design", "figure", "force_n", "request"]
        )
        self._begin(self._judge())

    async def _judge(self) -> None:
        query = {"design": self.design, "figure": self.figure, "force_n": self.force_n}
        request, answer = self.request, await self._told("judge", query)
        self.set_trait("map", answer | {"request": request})

    async def _answer(self, message: dict[str, Any]) -> None:
        number, question, query = (message[key] for key in ("number", "question", "query"))
        if question == "scene":
            self.send({"number": number}, buffers=[await self._answers.scene(query)])
        else:
            self.send({"number": number, "answer": await self._told(question, query)})

    async def _told(self, question: str, query: dict[str, Any]) -> dict[str, Any]:
        try:
            return await self._answers.to(question, query)
        except InstobjError as error:
            return {"error": str(error)}

    def _begin(self, work: Coroutine[Any, Any, None]) -> None:
        """Run within the notebook's loop, or at once where there is none."""
        try:
            loop = asyncio.get_running_loop()
        except RuntimeError:
            asyncio.run(work)
            return
        task = loop.create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)


def design_view(path: Path | str, overrides: Sequence[str] = ()) -> DesignView:
    """Return the view of a specification, with `overrides` such as "shell.thickness_mm=10"; coarse where the
    shell's own mechanics is not stored.

    Raises
    ------
    InputError
        A specification that the quick model cannot judge.
    """
    spec = load_spec(Path(path), list(overrides))
    return DesignView(open_shell(spec), Path(path))
