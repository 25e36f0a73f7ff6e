"""Placement of what is asked for, or what would fit instead: larger bodies, fewer parts."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import chain

import numpy as np

from design.body.kinds.capsule import Capsule
from design.body.kinds.pad import Pad
from design.body.kinds.registry import KINDS
from design.errors import SpecError
from design.fit.roughness import rough_patches
from design.placement.hooking import shell_variants_of, simple_body_text, with_thinnest
from design.placement.objects import (
    COARSE,
    SHARES,
    Request,
    Tables,
    bare_tables,
    fits_roughly,
    fitting,
    fitting_most,
    fitting_tables,
    roomy_faces,
    spec_of,
)
from design.spec.body import LONGEST_EDGE_MM
from design.spec.object import ObjectSpec

_GROWTH, _LARGEST_GROWTH, _LARGEST_BESIDE, _HALVINGS = 1.25, 8.0, 3.1, 3
"""Steps in which a larger size is looked for, how far, how far where longer short edges help, and how
often the last step is halved."""
_MARGIN = 1.05
"""Step in which a size that fits roughly grows until it is placed."""
_DIGITS, _ROUNDED = 4, 0.999
"""Digits of a scale that is named, which may be rounded up by a thousandth; what that leaves of the
longest edge."""
_MOULD_MM = 30.0
"""Room for walls and flanges, beyond the body."""
_PLATE = 0.5
"""Share of the shorter of the other edges, up to which a height makes a plate."""


def place_parts(request: Request) -> Tables:
    """Tables of a specification in which everything fits and can be made.

    Raises
    ------
    SpecError
        The kind takes no such size, or it is too small; with the smallest that works.
    """
    return next(placements(request))


def most_printed_mm() -> float:
    """Longest edge of a body whose mould lies on the default printer."""
    return min(ObjectSpec(name="default").printer.bed_mm[:2]) - _MOULD_MM


def placements(request: Request) -> Iterator[Tables]:
    """The same for each shell that takes everything, the most generous first.

    Raises
    ------
    SpecError
        As `place_parts`.
    """
    request = with_thinnest(request)
    layouts = fitting_most(request, shell_variants_of(request), SHARES)
    first = next(layouts, None)
    if first is None:
        raise SpecError(_not_placed(request))
    yield from chain([first], layouts)


def _bare(request: Request) -> Tables:
    return bare_tables(request, request.thinnest)


def _not_placed(request: Request) -> str:
    size = " × ".join(f"{edge:.4g}" for edge in request.size_mm)
    body = "an imported body" if request.file else f"a body of kind {request.kind}"
    sensors = f"{request.sensors} sensor{'s' * (request.sensors > 1)}"
    magnets = f"{request.magnets} magnets" if (request.magnets or 1) > 1 else "a magnet"
    fewest = replace(request, sensors=1)
    even = request.takes_fewer and request != fewest
    parts = f"{sensors} and {magnets} per face{' (even for 1 sensor)' * even}"
    ways = "; or ".join(_ways(request))
    if even and not ways and (ways_of_fewest := _ways(fewest)):
        ways = f"With 1 sensor: {'; or '.join(ways_of_fewest)}"
    rough = rough_patches(spec_of(_bare(request))) if request.file else []
    if ways:
        message = f"{body} of {size} mm is too small for {parts}"
        return ". ".join([message, *rough, ways[0].upper() + ways[1:]])
    # what does not fit at any size is not too small
    longest = max(request.size_mm)
    growth = _most_growth(longest)
    message = (
        f"no place was found for {parts} on {body} of {size} mm, nor at any size up to {growth:.2g} times "
        f"that ({growth * longest:.4g} mm)"
    )
    return ". ".join([message, *rough, "Choose another shape"])


def _ways(request: Request) -> list[str]:
    return [*_larger(request), *base_advice(request), *_fewer(request), *_simpler(request)]


def _larger(request: Request) -> Iterator[str]:
    """Sizes that work: of that shape, unless its mould is larger than the bed and another helps, and where
    that helps with the short edges longer alone."""
    flat = min(request.size_mm) < max(request.size_mm) and not request.file
    thicker = smallest_working(request, min(request.size_mm), thickened_request) if flat else None
    most = _LARGEST_GROWTH if thicker is None else _LARGEST_BESIDE
    whole = smallest_working(request, max(request.size_mm), grown_request, most)
    if whole is not None and (thicker is None or max(whole.size_mm) <= most_printed_mm()):
        scale = f" (scale = {dict(whole.file)['scale']:.4g})" if whole.file else ""
        yield f"The smallest of that shape that works is about {_told(whole)}{scale}"
    else:
        whole = None
    if thicker is not None and (whole is None or _shorter_somewhere(thicker, whole)):
        yield f"{'with' if whole else 'With'} its short edges longer about {_told(thicker)} works"


def _shorter_somewhere(size_a: Request, size_b: Request) -> bool:
    """Return whether one size is below the other along any edge."""
    return any(a < b for a, b in zip(size_a.size_mm, size_b.size_mm, strict=True))


def _told(request: Request) -> str:
    faces = request.faces or ()
    sensed = f" with sensors on face{'s' * (len(faces) > 1)} {', '.join(map(str, faces))} alone"
    size = " × ".join(f"{edge:.4g}" for edge in request.size_mm)
    return f"{size} mm{sensed * bool(faces)}"


def smallest_working(
    request: Request,
    edge_mm: float,
    grown: Callable[[Request, float], Request],
    most: float = _LARGEST_GROWTH,
) -> Request | None:
    """The request at about the least growth, up to `most`, at which everything finds room; or None.

    `edge_mm` is the edge that grows, to what a body may measure at most.
    """

    def working(growth: float) -> Request | None:
        larger = grown(request, growth)
        return _fitting_roughly(larger) if KINDS[larger.kind].takes_size(larger.size_mm) else None

    low, high, fitting_request = 1.0, 1.0, None
    largest = _most_growth(edge_mm, most)
    while fitting_request is None and high < largest:
        low, high = high, min(high * _GROWTH, largest)
        fitting_request = working(high)
    for _ in range(_HALVINGS if fitting_request else 0):
        middle = (low + high) / 2
        smaller = working(middle)
        low, high, fitting_request = (
            (low, middle, smaller) if smaller else (middle, high, fitting_request)
        )
    # what fits roughly may not be placed when a user asks for it
    while fitting_request is not None and not _is_placed(
        replace(fitting_request, faces=request.faces)
    ):
        high *= _MARGIN
        fitting_request = working(high) if high <= largest else None
    return fitting_request


def _most_growth(edge_mm: float, most: float = _LARGEST_GROWTH) -> float:
    """Return how far sizes are looked for: no edge of a body may be longer than `LONGEST_EDGE_MM`."""
    # a file's scale is rounded, which must not carry its body beyond the limit
    return min(most, _ROUNDED * LONGEST_EDGE_MM[1] / edge_mm)


def _is_placed(request: Request) -> bool:
    """Return whether everything is placed where a user asks for that size."""
    request = with_thinnest(request)
    return next(fitting(request, shell_variants_of(request), SHARES), None) is not None


def base_advice(request: Request) -> Iterator[str]:
    """A plate whose core has no room for its walls, as a slab on a rigid base."""
    x, y, z = request.size_mm
    plate = KINDS[request.kind].cuboid and z <= _PLATE * min(x, y)
    if plate and fits_roughly(replace(request, kind=Pad.name, faces=None)):
        yield f"--kind {Pad.name}, a slab of that size on a rigid base, sensed from above, would fit"


def _fewer(request: Request) -> Iterator[str]:
    """Fewer sensors, and fewer magnets, that the size takes on all faces."""
    for count in sorted({request.sensors - 1, request.sensors // 2, 1} - {0}, reverse=True):
        if count < request.sensors and fits_roughly(replace(request, sensors=count)):
            yield f"{count} sensor{'s' * (count > 1)} per face would fit"
            break
    if request.magnets is not None and request.magnets > 1:
        tables = next(
            fitting_tables(replace(request, magnets=None), (request.thinnest,), COARSE), None
        )
        if tables is not None:
            count = len(tables["magnets"]["positions_mm"])
            yield f"{count} magnet{'s' * (count > 1)} per face would fit"


def _simpler(request: Request) -> Iterator[str]:
    """A capsule about as thick and as long as a file's body."""
    short, _, long = sorted(request.size_mm)
    text = simple_body_text(request, Capsule.name, (short, short, long)) if request.file else ""
    if text:
        yield text


def _fitting_roughly(request: Request) -> Request | None:
    """The request where it fits roughly, if need be without the faces that do not take everything by
    themselves, as `first_fit` leaves them out; None where it does not."""
    request = with_thinnest(request)
    if fits_roughly(request):
        return request
    faces = () if request.faces is not None else roomy_faces(request)
    fewer = replace(request, faces=faces)
    return fewer if faces and fits_roughly(fewer) else None


def grown_request(request: Request, growth: float) -> Request:
    """Return the request grown by half millimetres; a file's body by a scale of four digits, of which its
    size follows."""
    if not request.file:
        x, y, z = (float(np.ceil(2 * growth * edge)) / 2 for edge in request.size_mm)
        return replace(request, size_mm=(x, y, z))
    file = dict(request.file)
    scale_before = file.get("scale", 1.0)
    digits = _DIGITS - int(np.ceil(np.log10(scale_before * growth)))
    scale = float(np.ceil(scale_before * growth * 10.0**digits - 1e-6)) / 10.0**digits
    x, y, z = (edge * scale / scale_before for edge in request.size_mm)
    return replace(request, size_mm=(x, y, z), file=tuple((file | {"scale": scale}).items()))


def thickened_request(request: Request, growth: float) -> Request:
    floor = float(np.ceil(2 * growth * min(request.size_mm))) / 2
    x, y, z = (max(edge, floor) for edge in request.size_mm)
    return replace(request, size_mm=(x, y, z))
