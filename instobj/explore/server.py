"""The page's server, on this machine alone: it judges whatever design the page holds, and keeps none."""

from __future__ import annotations

import base64
import json
from asyncio import get_running_loop, to_thread
from collections.abc import Awaitable, Callable, Sequence
from concurrent.futures import Executor
from dataclasses import asdict, dataclass, field
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np
from aiohttp import web

from design.errors import InputError, InstobjError
from design.spec.object import ObjectSpec
from instobj.explore.design import (
    broken_limits,
    kept_file,
    save_design,
    shown_places,
    with_design,
)
from instobj.explore.engine import Explorer, Pressed, skin_profile_mm, summary_of
from instobj.explore.scene import explorer_scene
from instobj.explore.shells import Shells
from instobj.explore.work import Work, confirmed_rows
from instobj.report.remedies import price_and_minutes
from instobj.search.outcome.layouts import parts_of
from instobj.viewer.bundling import program
from instobj.viewer.served import page_headers, refusal

ADDRESS = "127.0.0.1"
PAGE = Path(__file__).parent / "page.html"
_LARGEST_BYTES = 100_000
"""Largest question; a design has a few thousand."""
Asked = Callable[[dict[str, Any]], Awaitable[dict[str, Any]]]
Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]


@dataclass
class Session:
    """Shells that the page explores, the specification with its file, and long work."""

    explorer: Explorer
    source: Path
    work: Work = field(default_factory=Work)

    def __post_init__(self) -> None:
        self.shells = Shells.beginning_with(self.explorer)

    def answer(self, question: str, query: dict[str, Any]) -> dict[str, Any]:
        """Return the answer to one of `QUESTIONS` about a design.

        Raises
        ------
        InputError
            A design that breaks a rule, or cannot be judged or saved.
        """
        try:
            return QUESTIONS[question](self, self.design(query), query)
        except InstobjError:
            raise
        except (KeyError, TypeError, AttributeError, IndexError, ValueError) as error:
            raise InputError(f"the page asked wrongly ({error!r}). Reload it") from error

    def design(self, query: dict[str, Any]) -> ObjectSpec:
        """Return the design of a question.

        Raises
        ------
        InputError
            None, or one that breaks a rule.
        """
        try:
            return with_design(self.explorer.spec, query["design"])
        except (KeyError, TypeError, AttributeError) as error:
            raise InputError(f"the page asked wrongly ({error!r}). Reload it") from error

    def judged(self, design: ObjectSpec, query: dict[str, Any]) -> dict[str, Any]:
        """Return figures at every place, where parts are, and what they cost."""
        explorer = self.shells.explorer_of(design)
        judgement = explorer.judge(design, query["force_n"])
        figures = {"position": judgement.position_bound_mm, "force": judgement.force_bound_n}
        if query["figure"] == "least":
            figures["least"] = explorer.least_forces_n(design)
        faces = len(design.body.sensed)
        counts = (faces * design.magnets.count, faces * design.sensors.count_per_face)
        return {
            "scene": self.shells.name_of(design),
            "values": _jsonable(figures[query["figure"]].ravel()),
            "summary": {name: _summary(values) for name, values in figures.items()},
            "beyond": judgement.beyond,
            "parts": parts_of(design),
            "shown": shown_places(design),
            "magnets": counts[0],
            "sensors": counts[1],
            "price_and_minutes": price_and_minutes(*counts),
        }

    def range_used(self, design: ObjectSpec, query: dict[str, Any]) -> dict[str, Any]:
        """Return the share of the chips' range that is used."""
        return {"range_used": self.shells.explorer_of(design).range_used(design)}

    def pressed(self, design: ObjectSpec, query: dict[str, Any]) -> dict[str, Any]:
        """Return what happens in presses at some places of a face at once, and how the skin bends."""
        readings = self._press(design, query)
        return _pressed(readings, query["places"]) | {
            "skin_mm": skin_profile_mm(design, float(query["force_n"])).round(4).tolist()
        }

    def _press(self, design: ObjectSpec, query: dict[str, Any]) -> Pressed:
        return self.shells.explorer_of(design).press(design, query["face"], query["force_n"])

    def saved(self, design: ObjectSpec, query: dict[str, Any]) -> dict[str, Any]:
        """Save the design; return the file and the commands that go on with it."""
        path, kept = save_design(design, self.source)
        names = [f"instobj {command} {path}" for command in ("check", "run", "explore")]
        return {"file": str(path), "comments_kept": kept, "commands": names}

    def scene(self, design: ObjectSpec) -> bytes:
        """Return the body, places and accuracy of a design's shell, for the page."""
        shells = self.shells
        return explorer_scene(shells.explorer_of(design), shells.name_of(design))

    def exported(self) -> str:
        """Return the page with all answers about its first design in it, to look at and to press."""
        from instobj.report.pages import policy

        data = json.dumps(self._all_answers(), separators=(",", ":")).replace("<", "\\u003c")
        scene = base64.b64encode(self.scene(self.explorer.spec)).decode()
        head = f'<meta http-equiv="Content-Security-Policy" content="{policy()}">'
        held = (
            f'<script type="application/json" id="answers">{data}</script>'
            f'<script type="application/octet-stream" id="scene">{scene}</script>'
        )
        page = PAGE.read_text(encoding="utf-8").replace("<title>", f"{head}\n<title>")
        return page.replace('<script src="/program.js">', f"{held}<script>{program()}")

    def _all_answers(self) -> dict[str, Any]:
        spec, explorer = self.explorer.spec, self.explorer
        answers: dict[str, Any] = {
            "limits": {"broken": broken_limits(spec)},
            "range": self.range_used(spec, {}),
        }
        for force in explorer.forces_n:
            for figure in ("position", "force", "least"):
                query = {"figure": figure, "force_n": force}
                answers[f"judge {figure} {force:g}"] = self.judged(spec, query)
            skin = skin_profile_mm(spec, force).round(4).tolist()
            for face in explorer.presses:
                readings = self._press(spec, {"face": face, "force_n": force})
                answers[f"press {face} {force:g}"] = [
                    _pressed(readings, [place]) | {"skin_mm": skin}
                    for place in range(len(explorer.grid.xy_mm))
                ]
        return answers


QUESTIONS: dict[str, Callable[[Session, ObjectSpec, dict[str, Any]], dict[str, Any]]] = {
    "judge": Session.judged,
    "range": Session.range_used,
    "press": Session.pressed,
    "save": Session.saved,
}


def application(session: Session, checking: Executor) -> web.Application:
    """Return the server's routes, behind its guard."""

    async def index(request: web.Request) -> web.Response:
        text, headers = PAGE.read_text(encoding="utf-8"), page_headers(request.host)
        return web.Response(text=text, content_type="text/html", headers=headers)

    async def read_program(_: web.Request) -> web.Response:
        return web.Response(text=program(), content_type="text/javascript")

    async def read_scene(request: web.Request) -> web.Response:
        query = await request.json() if request.can_read_body else {"design": {}}
        scene = await answers.scene(query)
        return web.Response(body=scene, content_type="application/octet-stream")

    answers = Answers(session, checking)

    async def answer(request: web.Request) -> web.Response:
        try:
            query, question = await request.json(), request.match_info["question"]
            return web.json_response(await answers.to(question, query))
        except InstobjError as error:
            return web.json_response({"error": str(error)}, status=400)
        except json.JSONDecodeError:
            return web.json_response({"error": "no JSON. Reload the page"}, status=400)

    async def end(_: web.Application) -> None:
        await answers.end()

    app = web.Application(middlewares=[_guard], client_max_size=_LARGEST_BYTES)
    app.on_cleanup.append(end)
    app.add_routes(
        [
            web.get("/", index),
            web.get("/program.js", read_program),
            web.get("/scene", read_scene),
            web.post("/scene", read_scene),
            web.post(f"/{{question:{'|'.join(answers.names)}}}", answer),
        ]
    )
    return app


class Answers:
    """Answers to all questions of a page or a notebook; `checking` checks limits, so that hands that drag a
    part do not wait for it."""

    def __init__(self, session: Session, checking: Executor) -> None:
        self._session = session
        self._awaited = _awaited(session, checking)
        self.names = [*self._awaited, *QUESTIONS]

    async def to(self, question: str, query: dict[str, Any]) -> dict[str, Any]:
        """Return the answer to a question.

        Raises
        ------
        InputError
            As `Session.answer`.
        """
        if question in self._awaited:
            return await self._awaited[question](query)
        await self._session.shells.open(self._session.design(query))
        return self._session.answer(question, query)

    async def scene(self, query: dict[str, Any]) -> bytes:
        """Return the body, places and accuracy of a design's shell; of the first one for an empty design."""
        design = self._session.design(query)
        await self._session.shells.open(design)
        return await to_thread(self._session.scene, design)

    async def end(self) -> None:
        """End what is at work."""
        self._session.shells.close()
        await self._session.work.stop()


def _awaited(session: Session, checking: Executor) -> dict[str, Asked]:
    """Return the questions whose answers others work on meanwhile, by name."""

    async def limits(query: dict[str, Any]) -> dict[str, Any]:
        design = session.design(query)
        return {"broken": await get_running_loop().run_in_executor(checking, broken_limits, design)}

    async def state(query: dict[str, Any]) -> dict[str, Any]:
        design = session.design(query)
        await session.shells.open(design)
        return {
            "scene": session.shells.name_of(design),
            "refined": session.shells.told(design),
            "refining": session.shells.is_refining(design),
            "work": await to_thread(session.work.told),
        }

    async def improve(query: dict[str, Any]) -> dict[str, Any]:
        path = await to_thread(kept_file, session.design(query), session.source)
        await session.work.improve(path, float(query["seconds"]))
        return {}

    async def confirm(query: dict[str, Any]) -> dict[str, Any]:
        path = await to_thread(kept_file, session.design(query), session.source)
        await session.work.confirm(path, query["force_n"])
        return {}

    async def confirmed(query: dict[str, Any]) -> dict[str, Any]:
        design, (path, force) = session.design(query), (session.work.path, query["force_n"])
        explorer = session.shells.explorer_of(design)
        rows = await to_thread(confirmed_rows, explorer, path, force)
        return {"rows": rows, "channels": design.score.channels}

    async def stop(_: dict[str, Any]) -> dict[str, Any]:
        await session.work.stop()
        return {}

    awaited = (limits, state, improve, confirm, confirmed, stop)
    return {handler.__name__: handler for handler in awaited}


@web.middleware
async def _guard(request: web.Request, handler: Handler) -> web.StreamResponse:
    """Refuse foreign names and pages of other origins."""
    if reason := refusal(request.host, request.headers.get("Origin"), ADDRESS):
        raise web.HTTPForbidden(text=reason)
    return await handler(request)


def _pressed(readings: Pressed, places: Sequence[int]) -> dict[str, Any]:
    ellipses = readings.position_mm2(places).reshape(-1, 4)
    return {
        "counts": _jsonable(readings.counts(places).ravel().round(1)),
        "noise_counts": _jsonable(readings.noise_counts.round(1)),
        "position_mm2": [_jsonable(ellipse) for ellipse in ellipses],
        "motions": [
            _jsonable(body.round(5)) for body in readings.motions[list(places)].sum(axis=0)
        ],
    }


def _summary(values: np.ndarray) -> dict[str, Any]:
    summary = asdict(summary_of(values))
    return {name: value if isfinite(value) else None for name, value in summary.items()}


def _jsonable(values: np.ndarray) -> list[Any]:
    """Return numbers, None where there is none or it is infinite."""
    plain = values.astype(object)
    plain[~np.isfinite(values)] = None
    return plain.tolist()
