"""Draw `docs/simulated.png`: the paper's cube lifted in MuJoCo by two jaws, each of two tips.

instobj build examples/paper_cube.toml --twin
MUJOCO_GL=osmesa python examples/draw_simulated.py runs/paper_cube/twin/paper_cube.xml docs/simulated.png
"""

import sys

import mujoco
from PIL import Image

GRIP_N, LIFT_M, CLOSED_S, STEPS = 6.0, 0.03, 0.9, 2500
SLIDE, JOINT = mujoco.mjtJoint.mjJNT_SLIDE, mujoco.mjtTrn.mjTRN_JOINT
BOX, BALL, PLANE = (getattr(mujoco.mjtGeom, f"mjGEOM_{n}") for n in ("BOX", "SPHERE", "PLANE"))
JAW_KG, STIFFNESS, DAMPING = 3.0, 6000.0, 300.0


def add_jaw(scene: mujoco.MjSpec, side: int) -> None:
    """Add a jaw that closes along y and rises along z."""
    jaw = scene.worldbody.add_body(pos=[0, side * 0.045, 0])
    for name, axis in (("x", [0, -side, 0]), ("z", [0, 0, 1])):
        jaw.add_joint(name=f"{name}{side}", type=SLIDE, axis=axis, damping=20)
        motor = scene.add_actuator(name=f"{name}{side}", target=f"{name}{side}", trntype=JOINT)
        if name == "z":
            motor.set_to_position(kp=STIFFNESS, kv=DAMPING)
    for x in (-0.008, 0.008):
        jaw.add_geom(
            type=BALL, size=[0.005, 0, 0], pos=[x, -side * 0.004, 0], mass=0.5,
            friction=[1, 0.005, 0.0001], rgba=[0.8, 0.35, 0.2, 1],
        )  # fmt: skip
    jaw.add_geom(
        type=BOX, size=[0.014, 0.003, 0.008], pos=[0, side * 0.003, 0], mass=JAW_KG - 1,
        contype=0, conaffinity=0, rgba=[0.35, 0.37, 0.4, 0.55],
    )  # fmt: skip


def lifted(path: str) -> tuple[mujoco.MjModel, mujoco.MjData]:
    """Return the scene after the jaws closed and rose."""
    scene = mujoco.MjSpec.from_file(path)
    scene.add_texture(
        name="sky", type=mujoco.mjtTexture.mjTEXTURE_SKYBOX, width=64, height=64,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_FLAT, rgb1=[1, 1, 1], rgb2=[1, 1, 1],
    )  # fmt: skip
    scene.visual.global_.offwidth, scene.visual.global_.offheight = 1100, 700
    scene.visual.map.force = 0.07
    scene.visual.scale.contactwidth, scene.visual.scale.contactheight = 0.1, 0.05
    scene.visual.scale.forcewidth = 0.05
    scene.worldbody.add_light(pos=[0.1, -0.3, 0.6], dir=[-0.1, 0.3, -0.6], diffuse=[0.6] * 3)
    scene.worldbody.add_geom(
        type=PLANE, size=[0.3, 0.3, 0.01], pos=[0, 0, -0.021], rgba=[0.8, 0.83, 0.85, 1]
    )
    for side in (-1, 1):
        add_jaw(scene, side)
    model = scene.compile()
    data = mujoco.MjData(model)
    for step in range(STEPS):
        rise = LIFT_M * min(1.0, max(0.0, step * model.opt.timestep - CLOSED_S))
        for side in (-1, 1):
            data.actuator(f"x{side}").ctrl = GRIP_N
            data.actuator(f"z{side}").ctrl = rise + JAW_KG * 9.81 / STIFFNESS
        mujoco.mj_step(model, data)
    return model, data


def main(path: str, target: str) -> None:
    """Write the picture."""
    model, data = lifted(path)
    camera, shown = mujoco.MjvCamera(), mujoco.MjvOption()
    camera.lookat[:] = 0, 0, 0.02
    camera.distance, camera.azimuth, camera.elevation = 0.17, 155, -20
    shown.flags[mujoco.mjtVisFlag.mjVIS_CONTACTFORCE] = True
    shown.sitegroup[:] = 0
    renderer = mujoco.Renderer(model, 700, 1100)
    renderer.update_scene(data, camera, shown)
    Image.fromarray(renderer.render()).quantize(96).save(target, optimize=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
