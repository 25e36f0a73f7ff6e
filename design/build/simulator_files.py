"""Files of an object for physics simulators: MJCF, URDF and USD, with the meshes that they share.

Lengths are in m, masses in kg; the body's frame is the object's. STL files are in mm, and scaled.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from design.build.simulator_body import SimulatorBody
from design.files import atomic_path

_M = 1e-3
"""Metres in a millimetre, and kilograms in a gram."""
_KG_M2 = 1e-9
"""kg m² in a g mm²."""
_IMPEDANCE = 0.01
"""MuJoCo's impedance d of contacts. A contact's force becomes a spring's and a damper's for d → 0;
inertia of both bodies is reduced by the share d."""
_LONGEST_STEP_S, _STEP_OF_SWING = 1e-3, 0.2
"""Step of MuJoCo: at most this share of 1/ω, with ω of the body on one contact point. Contacts are
stepped explicitly and those of a face add up; at 0.6 / ω a dome of 6 g jumps off its table."""
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
    meshes = {f"meshes/{name}.stl": surface for name, surface in body.meshes.items()}
    for name, surface in meshes.items():
        with atomic_path(folder / name) as path:
            surface.export(path)
    texts = {".xml": mjcf_text(body), ".urdf": urdf_text(body), ".usda": usd_text(body)}
    named = {f"{body.name}{suffix}": text for suffix, text in texts.items()}
    for name, text in named.items():
        with atomic_path(folder / name) as path:
            path.write_text(text, encoding="utf-8")
    return [folder / name for name in (*meshes, *named)]


def mjcf_text(body: SimulatorBody) -> str:
    """Return the object as a MuJoCo model with a free joint.

    MuJoCo's contact force is (k r + b v) d / ((1 − d) Â), with  the sum of the inverse masses of both
    bodies; solref holds −k d and −b d (MuJoCo, "Computation", solver parameters). So the spring has
    its stiffness against what stands fast or is far heavier, m / (m + M) less against a mass M.
    """
    mass_kg, inertia = body.mass.mass_g * _M, body.mass.inertia_g_mm2 * _KG_M2
    spring = np.array([body.contact.n_per_mm, body.contact.n_s_per_mm]) / _M
    step_s = min(_LONGEST_STEP_S, _STEP_OF_SWING * np.sqrt(mass_kg / spring[0]))
    # priority: what touches the object has another material, which does not count
    contact = (
        f'priority="1" friction="{body.contact.friction} 0.005 0.0001" '
        f'solref="{_joined(-spring * (1 - _IMPEDANCE) / mass_kg)}" '
        f'solimp="{_IMPEDANCE} {_IMPEDANCE} 0.001" group="3"'
    )
    visual_only = 'group="2" contype="0" conaffinity="0"'
    assets = [
        f'    <mesh name="{name}" file="{name}.stl" scale="{_M} {_M} {_M}"/>'
        for name in body.meshes
    ]
    geoms = [
        f'      <geom type="mesh" mesh="{name}" '
        + (
            f'{visual_only} rgba="{_joined(_COLOURS[name])}"/>'
            if name in body.visual
            else f"{contact}/>"
        )
        for name in body.meshes
    ]
    sites = [
        f'      <site name="{name}" pos="{_joined(place * _M)}" quat="{_joined(_quaternion(axes))}"/>'
        for name, (place, axes) in body.frames.items()
    ]
    # Ixx, Iyy, Izz, Ixy, Ixz, Iyz
    six = _joined(inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]])
    # soft contacts creep along friction: elliptic cones and the pass without slip hold them
    return _lines(
        f'<mujoco model="{body.name}">\n  <!-- {body.comment} -->\n  <compiler meshdir="meshes"/>',
        f'  <option timestep="{step_s:.2g}" cone="elliptic" impratio="10" noslip_iterations="10"/>',
        *("  <asset>", *assets, "  </asset>"),
        f'  <worldbody>\n    <body name="{body.name}">\n      <freejoint/>',
        f'      <inertial mass="{_number(mass_kg)}" pos="{_joined(body.mass.centre_mm * _M)}" '
        f'fullinertia="{six}"/>',
        *(*geoms, *sites, "    </body>\n  </worldbody>\n</mujoco>"),
    )


def urdf_text(body: SimulatorBody) -> str:
    """Return the object as a robot of one link; chips and magnets are links without mass on it.

    Stiffness and damping stand in Gazebo's extension.
    """
    inertia = body.mass.inertia_g_mm2 * _KG_M2
    six = " ".join(
        f'i{"xyz"[i]}{"xyz"[j]}="{_number(inertia[i, j])}"' for i in range(3) for j in range(i, 3)
    )
    parts = []
    for name in body.meshes:
        kind = "visual" if name in body.visual else "collision"
        mesh = f'<mesh filename="meshes/{name}.stl" scale="{_M} {_M} {_M}"/>'
        colour = f'<color rgba="{_joined(_COLOURS[name])}"/>' if name in body.visual else ""
        material = f'<material name="{name}">{colour}</material>' if colour else ""
        parts.append(f'    <{kind} name="{name}"><geometry>{mesh}</geometry>{material}</{kind}>')
    links = []
    for name, (place, axes) in body.frames.items():
        # URDF turns about the fixed x, y and z, in this order
        turns = Rotation.from_matrix(axes).as_euler("xyz", suppress_warnings=True)
        links += [
            f'  <link name="{name}"/>\n  <joint name="{name}_joint" type="fixed">',
            f'    <parent link="{body.name}"/><child link="{name}"/>',
            f'    <origin xyz="{_joined(place * _M)}" rpy="{_joined(turns)}"/>\n  </joint>',
        ]
    contact = body.contact
    return _lines(
        f'<robot name="{body.name}">\n  <!-- {body.comment} -->\n  <link name="{body.name}">',
        f'    <inertial><origin xyz="{_joined(body.mass.centre_mm * _M)}" rpy="0 0 0"/>',
        f'      <mass value="{_number(body.mass.mass_g * _M)}"/><inertia {six}/></inertial>',
        *(*parts, "  </link>"),
        f'  <gazebo reference="{body.name}"><kp>{_number(contact.n_per_mm / _M)}</kp>'
        f"<kd>{_number(contact.n_s_per_mm / _M)}</kd><mu1>{contact.friction}</mu1></gazebo>",
        *(*links, "</robot>"),
    )


def usd_text(body: SimulatorBody) -> str:
    """Return the object as a rigid body of UsdPhysics, its meshes inside; stiffness in PhysX's terms."""
    moments, axes = np.linalg.eigh(body.mass.inertia_g_mm2 * _KG_M2)
    axes = axes * np.sign(np.linalg.det(axes))
    contact = body.contact
    frames = [
        f'    def Xform "{name}"\n    {{\n'
        f"        double3 xformOp:translate = {_tuple(place * _M)}\n"
        f"        quatf xformOp:orient = {_tuple(_quaternion(frame))}\n"
        '        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:orient"]\n    }'
        for name, (place, frame) in body.frames.items()
    ]
    return _lines(
        f'#usda 1.0\n(\n    defaultPrim = "{body.name}"\n    doc = "{body.comment}"',
        '    metersPerUnit = 1\n    kilogramsPerUnit = 1\n    upAxis = "Z"\n)',
        f'def Xform "{body.name}" (',
        '    prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"]\n)\n{',
        f"    float physics:mass = {_number(body.mass.mass_g * _M)}",
        f"    point3f physics:centerOfMass = {_tuple(body.mass.centre_mm * _M)}",
        f"    float3 physics:diagonalInertia = {_tuple(moments)}",
        f"    quatf physics:principalAxes = {_tuple(_quaternion(axes))}",
        '    def Material "silicone" (',
        '        prepend apiSchemas = ["PhysicsMaterialAPI", "PhysxMaterialAPI"]\n    )\n    {',
        f"        float physics:staticFriction = {contact.friction}",
        f"        float physics:dynamicFriction = {contact.friction}",
        f"        float physxMaterial:compliantContactStiffness = {_number(contact.n_per_mm / _M)}",
        f"        float physxMaterial:compliantContactDamping = {_number(contact.n_s_per_mm / _M)}\n    }}",
        *(*(_usd_mesh(name, body) for name in body.meshes), *frames, "}"),
    )


def _usd_mesh(name: str, body: SimulatorBody) -> str:
    surface = body.meshes[name]
    if name in body.visual:
        *colour, opacity = _COLOURS[name]
        head = (
            f'    def Mesh "{name}"\n    {{',
            f"        color3f[] primvars:displayColor = [{_tuple(colour)}]",
            f"        float[] primvars:displayOpacity = [{opacity}]",
        )
    else:
        schemas = '"PhysicsCollisionAPI", "PhysicsMeshCollisionAPI", "MaterialBindingAPI"'
        head = (
            f'    def Mesh "{name}" (\n        prepend apiSchemas = [{schemas}]\n    )\n    {{',
            '        uniform token physics:approximation = "convexHull"',
            '        uniform token purpose = "guide"',
            f"        rel material:binding:physics = </{body.name}/silicone>",
        )
    return "\n".join(
        (
            *head,
            '        uniform token subdivisionScheme = "none"',
            f"        int[] faceVertexCounts = [{', '.join(['3'] * len(surface.faces))}]",
            f"        int[] faceVertexIndices = [{', '.join(map(str, surface.faces.ravel()))}]",
            f"        point3f[] points = [{', '.join(map(_tuple, surface.vertices * _M))}]\n    }}",
        )
    )


def _lines(*lines: str) -> str:
    return "\n".join(lines) + "\n"


def _number(value: float) -> str:
    # what is far below a nanometre, or a gram and square millimetre, is rounding
    return f"{value if abs(value) > 1e-15 else 0.0:.9g}"


def _joined(values: Float[np.ndarray, "n"] | tuple[float, ...], by: str = " ") -> str:
    return by.join(map(_number, values))


def _tuple(values: Float[np.ndarray, "n"] | list[float]) -> str:
    return f"({_joined(tuple(values), ', ')})"


def _quaternion(axes: Float[np.ndarray, "3 3"]) -> Float[np.ndarray, "4"]:
    return Rotation.from_matrix(axes).as_quat(scalar_first=True)
