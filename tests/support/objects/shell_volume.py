"""The cast shell's volume in closed form, and what fills the closed mould: they must agree."""

from math import hypot, pi, prod

from design.body.kinds.base import BodyKind
from design.body.kinds.cylinder import Cylinder
from design.body.kinds.pad import Pad
from design.layout.blocks import slits_volume_mm3
from design.layout.body import body_of
from design.layout.core_hold import locators
from design.layout.pockets import shell_pockets
from design.layout.volumes import sealed_volume_mm3
from design.mould.room import cast_room
from design.solids.booleans import Shape, cut
from design.spec.object import ObjectSpec
from tests.support.objects.whole_mould import inside_of_mould, mould_around


def cast_volume_mm3(body: BodyKind, layer_mm: float, sensed: tuple[int, ...]) -> float:
    """Volume of a body without a layer on its sensed faces, in closed form where its kind has one."""
    if body.sampled:
        inside = body.with_bore(body.core_surface())
        return float(body.cast_surface(layer_mm, sensed).difference(inside).volume)
    if isinstance(body, Cylinder):
        radius, low, high = body.cast_measures_mm(layer_mm, sensed)
        solid = pi * body.radius_mm**2 * body.size_mm[2]
        return body.volume_mm3() - solid + pi * radius**2 * (high - low)
    if body.cuboid or isinstance(body, Pad):
        low, high = body.cast_corners_mm(layer_mm, sensed)
        core = prod(body.size_mm) - body.volume_mm3() if body.cuboid else 0.0
        return prod((high - low).tolist()) - core
    return body.less(layer_mm).volume_mm3()


def cast_cavity(spec: ObjectSpec) -> Shape:
    """What silicone fills in the closed mould, within the first pour's envelope."""
    return cut(cast_room(spec), *mould_around(spec), *inside_of_mould(spec))


def shell_volume_mm3(spec: ObjectSpec) -> float:
    """Volume of the cast shell in mm³: the sealed body less its open pockets, the holes of pins
    that held the core of a closed body, and the seal layer.

    On curved patches pockets are taken to end at the plane that touches there: 0.03 % too much is
    left out on a ball of 50 mm, 0.15 % on a dome of radius 12 mm.
    """
    pockets = sum(pocket.volume_mm3 for face in shell_pockets(spec) for pocket in face)
    holes = sum(locator.volume_mm3 for locator in locators(spec))
    return sealed_volume_mm3(spec) - pockets - holes - _layer_volume_mm3(spec)


def _layer_volume_mm3(spec: ObjectSpec) -> float:
    """Silicone of the seal layer itself, without what fills the pockets and holes below it."""
    layer, body = spec.shell.seal_layer_mm, body_of(spec)
    if not layer:
        return 0.0
    slits = slits_volume_mm3(spec) - slits_volume_mm3(spec, layer)
    mouths = sum(p.outline.area_mm2 * layer / p.axis[2] for f in shell_pockets(spec) for p in f)
    mouths += sum(pi * pin.radius_mm**2 * layer * hypot(1, pin.rise_mm) for pin in locators(spec))
    solid = body.volume_mm3() - cast_volume_mm3(body, layer, spec.body.sensed)
    return solid - slits - float(mouths)
