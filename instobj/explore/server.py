"""The page's server, on this machine alone: it judges whatever design the page holds, and keeps none."""

from __future__ import annotations

import base64
import json
from asyncio import get_running_loop
from collections.abc import Awaitable, Callable
from concurrent.futures import Executor
from dataclasses import asdict, dataclass
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np
from aiohttp import web

from design.errors import InputError, InstobjError
from design.spec.object import ObjectSpec
from instobj.explore.design import broken_limits, save_design, shown_places, with_design
from instobj.explore.engine import Explorer, summary_of
from instobj.explore.scene import explorer_scene
from instobj.report.remedies import price_and_minutes
from instobj.search.outcome.layouts import parts_of
from instobj.viewer.bundling import program
from instobj.viewer.served import page_headers, refusal

ADDRESS = "127.0.0.1"
PAGE = Path(__file__).parent / "page.html"
_LARGEST_BYTES = 100_000
"""Largest question; a design has a few thousand."""
Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]


@dataclass(frozen=True)
class Session:
    """Mechanics that the page explores: mechanics, and the specification's file."""

    explorer: Explorer
    source: Path

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
        judgement = self.explorer.judge(design, query["force_n"])
        figures = {"position": judgement.position_bound_mm, "force": judgement.force_bound_n}
        if query["figure"] == "least":
            figures["least"] = self.explorer.least_forces_n(design)
        faces = len(design.body.sensed)
        counts = (faces * design.magnets.count, faces * design.sensors.count_per_face)
        return {
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
        return {"range_used": self.explorer.range_used(design)}

    def pressed(self, design: ObjectSpec, query: dict[str, Any]) -> dict[str, Any]:
        """Return readings of a face's chips in presses, at one place or at all."""
        readings = self.explorer.press(design, query["face"], query["force_n"])
        which = slice(None) if query.get("place") is None else [query["place"]]
        return {
            "counts": _jsonable(
                readings.counts[which].reshape(-1, readings.counts[0].size).round(1)
            ),
            "noise_counts": _jsonable(readings.noise_counts.round(1)),
            "position_mm2": _jsonable(readings.position_mm2[which].reshape(-1, 4)),
        }

    def saved(self, design: ObjectSpec, query: dict[str, Any]) -> dict[str, Any]:
        """Save the design; return the file and the commands that go on with it."""
        path, kept = save_design(design, self.source)
        names = [f"instobj {command} {path}" for command in ("check", "run", "explore")]
        return {"file": str(path), "comments_kept": kept, "commands": names}

    def exported(self) -> str:
        """Return the page with all answers about its first design in it, to look at and to press."""
        from instobj.report.pages import policy

        data = json.dumps(self._all_answers(), separators=(",", ":")).replace("<", "\\u003c")
        scene = base64.b64encode(explorer_scene(self.explorer)).decode()
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
            for face in explorer.presses:
                query = {"face": face, "force_n": force}
                answers[f"press {face} {force:g}"] = self.pressed(spec, query)
        return answers


QUESTIONS: dict[str, Callable[[Session, ObjectSpec, dict[str, Any]], dict[str, Any]]] = {
    "judge": Session.judged,
    "range": Session.range_used,
    "press": Session.pressed,
    "save": Session.saved,
}


def application(session: Session, checking: Executor) -> web.Application:
    """Return the server's routes, behind its guard; limits are checked by `checking`, which hands that drag
    a part do not wait for."""
    scene = explorer_scene(session.explorer)

    async def index(request: web.Request) -> web.Response:
        text, headers = PAGE.read_text(encoding="utf-8"), page_headers(request.host)
        return web.Response(text=text, content_type="text/html", headers=headers)

    async def read_program(_: web.Request) -> web.Response:
        return web.Response(text=program(), content_type="text/javascript")

    async def read_scene(_: web.Request) -> web.Response:
        return web.Response(body=scene, content_type="application/octet-stream")

    async def answer(request: web.Request) -> web.Response:
        try:
            query, question = await request.json(), request.match_info["question"]
            if question == "limits":
                design = session.design(query)
                broken = await get_running_loop().run_in_executor(checking, broken_limits, design)
                answered = {"broken": broken}
            else:
                answered = session.answer(question, query)
        except InstobjError as error:
            return web.json_response({"error": str(error)}, status=400)
        except json.JSONDecodeError:
            return web.json_response({"error": "no JSON. Reload the page"}, status=400)
        return web.json_response(answered)

    app = web.Application(middlewares=[_guard], client_max_size=_LARGEST_BYTES)
    app.add_routes(
        [
            web.get("/", index),
            web.get("/program.js", read_program),
            web.get("/scene", read_scene),
            web.post(f"/{{question:limits|{'|'.join(QUESTIONS)}}}", answer),
        ]
    )
    return app


@web.middleware
async def _guard(request: web.Request, handler: Handler) -> web.StreamResponse:
    """Refuse foreign names and pages of other origins."""
    if reason := refusal(request.host, request.headers.get("Origin"), ADDRESS):
        raise web.HTTPForbidden(text=reason)
    return await handler(request)


def _summary(values: np.ndarray) -> dict[str, Any]:
    summary = asdict(summary_of(values))
    return {name: value if isfinite(value) else None for name, value in summary.items()}


def _jsonable(values: np.ndarray) -> list[Any]:
    """Return numbers, None where there is none or it is infinite."""
    plain = values.astype(object)
    plain[~np.isfinite(values)] = None
    return plain.tolist()
