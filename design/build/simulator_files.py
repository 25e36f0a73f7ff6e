"""Files of an object for physics simulators: MJCF, URDF and USD, with the meshes that they share.

Lengths are in m, masses in kg; the body's frame is the object's. Meshes are in mm, and scaled there.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING
from xml.etree import ElementTree

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from design.build.simulator_body import SimulatorBody
from design.files import atomic_path

if TYPE_CHECKING:
    import trimesh

_M = 1e-3
"""Metres in a millimetre, and kilograms in a gram."""
_KG_M2 = 1e-9
"""kg m² in a g mm²."""
_IMPEDANCE = 0.01
"""MuJoCo's impedance d of contacts. A contact's force is that of a spring and a damper for d → 0;
inertia of both bodies is reduced by the share d."""
_COLOURS = {
    "core": (0.35, 0.47, 0.62, 1.0),
    "shell": (0.93, 0.84, 0.68, 0.45),
    "magnets": (0.6, 0.6, 0.62, 1.0),
    "boards": (0.1, 0.45, 0.22, 1.0),
}


def write_simulator_files(body: SimulatorBody, folder: Path) -> list[Path]:
    """Write meshes, then NAME.xml (MJCF), NAME.urdf and NAME.usda; return their paths.

    Raises
    ------
    StoreError
        The folder cannot be written.
    """
    paths = []
    for name, surface in body.meshes.items():
        paths.append(folder / "meshes" / f"{name}.stl")
        with atomic_path(paths[-1]) as path:
            surface.export(path)
    texts = {".xml": mjcf_text(body), ".urdf": urdf_text(body), ".usda": usd_text(body)}
    for suffix, text in texts.items():
        paths.append(folder / f"{body.identifier}{suffix}")
        with atomic_path(paths[-1]) as path:
            path.write_text(text, encoding="utf-8")
    return paths


def mjcf_text(body: SimulatorBody) -> str:
    """Return the object as a MuJoCo model with a free joint.

    A contact of MuJoCo sees the inverse masses of both bodies. Its spring has the stated stiffness
    against what stands fast or is far heavier, and less by the share m / (m + M) against a mass M.
    """
    root = ElementTree.Element("mujoco", model=body.identifier)
    root.append(ElementTree.Comment(body.comment))
    ElementTree.SubElement(root, "compiler", meshdir="meshes", angle="radian")
    # soft contacts creep along friction; elliptic cones and the pass without slip hold them
    ElementTree.SubElement(
        root, "option", timestep="0.001", cone="elliptic", impratio="10", noslip_iterations="10"
    )
    assets, world = (ElementTree.SubElement(root, name) for name in ("asset", "worldbody"))
    for name in body.meshes:
        scale = _numbers(np.full(3, _M))
        ElementTree.SubElement(assets, "mesh", name=name, file=f"{name}.stl", scale=scale)
    top = ElementTree.SubElement(world, "body", name=body.identifier)
    ElementTree.SubElement(top, "freejoint")
    inertia = body.mass.inertia_g_mm2 * _KG_M2
    ElementTree.SubElement(
        top,
        "inertial",
        mass=_number(body.mass.mass_g * _M),
        pos=_numbers(body.mass.centre_mm * _M),
        # Ixx, Iyy, Izz, Ixy, Ixz, Iyz
        fullinertia=_numbers(inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]),
    )
    for name in body.visual:
        colour = {"rgba": _numbers(np.array(_COLOURS[name])), "group": "2"}
        off = {"contype": "0", "conaffinity": "0"}
        ElementTree.SubElement(top, "geom", type="mesh", mesh=name, **colour, **off)
    contact = _mujoco_contact(body)
    for name in body.meshes.keys() - body.visual.keys():
        ElementTree.SubElement(top, "geom", type="mesh", mesh=name, group="3", **contact)
    for name, (place, axes) in body.frames.items():
        quaternion = _numbers(Rotation.from_matrix(axes).as_quat(scalar_first=True))
        ElementTree.SubElement(top, "site", name=name, pos=_numbers(place * _M), quat=quaternion)
    return _text(root)


def _mujoco_contact(body: SimulatorBody) -> dict[str, str]:
    """Return the attributes of a geom that make its contacts springs and dampers.

    MuJoCo's force is (k r + b v) d / ((1 − d) Â), with  the sum of inverse masses; solref holds −k d
    and −b d (MuJoCo, "Computation", solver parameters). So −solref = (K, C) (1 − d) / m.
    """
    spring = np.array([body.contact.n_per_mm, body.contact.n_s_per_mm]) / _M
    solref = -spring * (1 - _IMPEDANCE) / (body.mass.mass_g * _M)
    return {
        "solref": _numbers(solref),
        "solimp": f"{_IMPEDANCE} {_IMPEDANCE} 0.001",
        "friction": _numbers(np.array([body.contact.friction, 0.005, 0.0001])),
        # before what touches it, whose material is another one
        "priority": "1",
    }


def urdf_text(body: SimulatorBody) -> str:
    """Return the object as a robot of one link; chips and magnets are links without mass on it.

    Stiffness and damping stand in the extensions of PyBullet (`contact`) and Gazebo (`gazebo`).
    """
    root = ElementTree.Element("robot", name=body.identifier)
    root.append(ElementTree.Comment(body.comment))
    link = ElementTree.SubElement(root, "link", name=body.identifier)
    inertial = ElementTree.SubElement(link, "inertial")
    ElementTree.SubElement(inertial, "origin", xyz=_numbers(body.mass.centre_mm * _M), rpy="0 0 0")
    ElementTree.SubElement(inertial, "mass", value=_number(body.mass.mass_g * _M))
    inertia = body.mass.inertia_g_mm2 * _KG_M2
    entries = {f"i{a}{b}": (i, j) for i, a in enumerate("xyz") for j, b in enumerate("xyz")}
    upper = {name: _number(inertia[at]) for name, at in entries.items() if at[0] <= at[1]}
    ElementTree.SubElement(inertial, "inertia", **upper)
    for name in body.meshes:
        kind = "visual" if name in body.visual else "collision"
        part = ElementTree.SubElement(link, kind, name=name)
        geometry = ElementTree.SubElement(part, "geometry")
        scale = _numbers(np.full(3, _M))
        ElementTree.SubElement(geometry, "mesh", filename=f"meshes/{name}.stl", scale=scale)
        if kind == "visual":
            material = ElementTree.SubElement(part, "material", name=name)
            ElementTree.SubElement(material, "color", rgba=_numbers(np.array(_COLOURS[name])))
    spring = {
        "stiffness": _number(body.contact.n_per_mm / _M),
        "damping": _number(body.contact.n_s_per_mm / _M),
        "lateral_friction": _number(body.contact.friction),
    }
    contact = ElementTree.SubElement(link, "contact")
    gazebo = ElementTree.SubElement(root, "gazebo", reference=body.identifier)
    for (name, value), short in zip(spring.items(), ("kp", "kd", "mu1"), strict=True):
        ElementTree.SubElement(contact, name, value=value)
        ElementTree.SubElement(gazebo, short).text = value
    for name, (place, axes) in body.frames.items():
        ElementTree.SubElement(root, "link", name=name)
        joint = ElementTree.SubElement(root, "joint", name=f"{name}_joint", type="fixed")
        ElementTree.SubElement(joint, "parent", link=body.identifier)
        ElementTree.SubElement(joint, "child", link=name)
        # URDF turns about the fixed x, y and z, in this order
        turns = _numbers(Rotation.from_matrix(axes).as_euler("xyz", suppress_warnings=True))
        ElementTree.SubElement(joint, "origin", xyz=_numbers(place * _M), rpy=turns)
    return _text(root)


def usd_text(body: SimulatorBody) -> str:
    """Return the object as a rigid body of UsdPhysics, its meshes inside; stiffness in PhysX's terms."""
    return "\n".join(_usd_lines(body)) + "\n"


def _usd_lines(body: SimulatorBody) -> Iterator[str]:
    moments, axes = np.linalg.eigh(body.mass.inertia_g_mm2 * _KG_M2)
    axes = axes * np.sign(np.linalg.det(axes))
    contact = body.contact
    yield from (
        "#usda 1.0",
        f'(\n    defaultPrim = "{body.identifier}"\n    doc = "{body.comment}"',
        '    metersPerUnit = 1\n    kilogramsPerUnit = 1\n    upAxis = "Z"\n)',
        f'def Xform "{body.identifier}" (',
        '    prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"]\n)\n{',
        f"    float physics:mass = {_number(body.mass.mass_g * _M)}",
        f"    point3f physics:centerOfMass = {_tuple(body.mass.centre_mm * _M)}",
        f"    float3 physics:diagonalInertia = {_tuple(moments)}",
        f"    quatf physics:principalAxes = {_quaternion(axes)}",
        '    def Material "silicone" (',
        '        prepend apiSchemas = ["PhysicsMaterialAPI", "PhysxMaterialAPI"]\n    )\n    {',
        f"        float physics:staticFriction = {_number(contact.friction)}",
        f"        float physics:dynamicFriction = {_number(contact.friction)}",
        "        float physxMaterial:compliantContactStiffness = " + _number(contact.n_per_mm / _M),
        "        float physxMaterial:compliantContactDamping = " + _number(contact.n_s_per_mm / _M),
        "    }",
    )
    for name, surface in body.meshes.items():
        yield from _usd_mesh(name, surface, body)
    for name, (place, frame) in body.frames.items():
        yield from (
            f'    def Xform "{name}"\n    {{',
            f"        double3 xformOp:translate = {_tuple(place * _M)}",
            f"        quatf xformOp:orient = {_quaternion(frame)}",
            '        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:orient"]\n    }',
        )
    yield "}"


def _usd_mesh(name: str, surface: trimesh.Trimesh, body: SimulatorBody) -> Iterator[str]:
    if name in body.visual:
        *colour, opacity = _COLOURS[name]
        yield from (
            f'    def Mesh "{name}"\n    {{',
            f"        color3f[] primvars:displayColor = [{_tuple(np.array(colour))}]",
            f"        float[] primvars:displayOpacity = [{_number(opacity)}]",
        )
    else:
        schemas = "PhysicsCollisionAPI", "PhysicsMeshCollisionAPI", "MaterialBindingAPI"
        yield from (
            f'    def Mesh "{name}" (',
            f"        prepend apiSchemas = {str(list(schemas)).replace(chr(39), chr(34))}\n    )\n    {{",
            '        uniform token physics:approximation = "convexHull"',
            '        uniform token purpose = "guide"',
            f"        rel material:binding:physics = </{body.identifier}/silicone>",
        )
    points = ", ".join(map(_tuple, surface.vertices * _M))
    corners = ", ".join(map(str, surface.faces.ravel().tolist()))
    yield from (
        '        uniform token subdivisionScheme = "none"',
        f"        int[] faceVertexCounts = [{', '.join(['3'] * len(surface.faces))}]",
        f"        int[] faceVertexIndices = [{corners}]",
        f"        point3f[] points = [{points}]\n    }}",
    )


def _text(root: ElementTree.Element) -> str:
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode") + "\n"


def _number(value: float) -> str:
    # what is far below a nanometre, or a gram and square millimetre, is rounding
    return f"{value if abs(value) > 1e-15 else 0.0:.9g}"


def _numbers(values: Float[np.ndarray, "n"]) -> str:
    return " ".join(map(_number, values))


def _tuple(values: Float[np.ndarray, "n"]) -> str:
    return f"({', '.join(map(_number, values))})"


def _quaternion(axes: Float[np.ndarray, "3 3"]) -> str:
    return _tuple(Rotation.from_matrix(axes).as_quat(scalar_first=True))
