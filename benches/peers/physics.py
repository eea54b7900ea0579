"""Times MuJoCo and PyBullet on the scene of benches/physics.rs.

    pip install mujoco pybullet numpy
    python benches/peers/physics.py            # 100 and 500 objects
    python benches/peers/physics.py 2000

A peer that is not installed is skipped with a message. Times are CPU time of the
thread, medians of several runs if a run is short.

Scenes: scene_N.json.gz in ../shared/peers/physics beside the project, in the folder
that VC_PEERS names, or in target/peers, where the bench writes generated rooms if it
finds no others. Room modules of 25 objects; floor and walls are fixed, everything
else is loose, fridge doors are on hinges.
"""

import gzip
import json
import math
import os
import pathlib
import statistics
import sys
import time

SMALL = ("cup", "apple", "toy", "milk", "plate")
FRICTION = 0.6


def read(count):
    project = pathlib.Path(__file__).resolve().parents[2]
    given = pathlib.Path(os.environ.get("VC_PEERS", project.parent / "shared" / "peers" / "physics"))
    paths = [folder / f"scene_{count}.json.gz" for folder in (given, project / "target" / "peers")]
    path = next((path for path in paths if path.exists()), None)
    if path is None:
        print(f"no scene of {count} objects: run `cargo bench --bench physics` first, which writes it", flush=True)
        return None
    with gzip.open(path, "rt") as file:
        return json.load(file)


def timed(work):
    start = time.thread_time()
    result = work()
    return time.thread_time() - start, result


def median(work, runs):
    return statistics.median(timed(work)[0] for _ in range(runs))


def show(peer, count, rows):
    for what, seconds in rows:
        unit = f"{seconds * 1e6:10.1f} us" if seconds < 1e-3 else f"{seconds * 1e3:10.2f} ms"
        print(f"{peer:10} {count:5} {what:28} {unit}", flush=True)


def doors(scene):
    hung = {}
    for thing in scene["objs"]:
        if thing["hinge"]:
            hung.setdefault(thing["hinge"]["parent"], []).append(thing)
    return hung


# --- MuJoCo


def mjcf(scene, dt):
    def numbers(values):
        return " ".join(map(str, values))

    def geoms(thing, offset=(0, 0, 0)):
        for part in thing["parts"]:
            kind, size = next(iter(part["geo"].items()))
            pos = [a + b for a, b in zip(part["pos"], offset)]
            shape, size = {
                "Box": lambda: ("box", size),
                "Cyl": lambda: ("cylinder", (size["r"], size["h"])),
                "Ball": lambda: ("sphere", (size,)),
            }[kind]()
            yield f'<geom type="{shape}" pos="{numbers(pos)}" size="{numbers(size)}" density="{thing["density"]}"/>'

    def door(thing):
        hinge = thing["hinge"]
        offset = [-v for v in hinge["anchor_child"]]
        limits = numbers(math.degrees(v) for v in hinge["lim"])
        yield f'<body pos="{numbers(hinge["anchor"])}">'
        yield f'<joint type="hinge" axis="0 0 1" range="{limits}" limited="true"/>'
        yield from geoms(thing, offset)
        yield "</body>"

    def body(thing, hung):
        yaw = thing["yaw"] / 2
        quat = numbers((math.cos(yaw), 0, 0, math.sin(yaw)))
        yield f'<body name="o{thing["id"]}" pos="{numbers(thing["pos"])}" quat="{quat}"><freejoint/>'
        yield from geoms(thing)
        for child in hung:
            yield from door(child)
        yield "</body>"

    hung = doors(scene)
    still = [scene["floor"], *scene["walls"]]
    yield f'<mujoco><option timestep="{dt}" gravity="0 0 -9.81" integrator="implicitfast"><flag sleep="enable"/></option>'
    yield '<size memory="200M"/><default>'
    yield f'<geom friction="{FRICTION} 0.005 0.0001"/></default><worldbody>'
    for pos, half in still:
        yield f'<geom type="box" pos="{numbers(pos)}" size="{numbers(half)}"/>'
    for thing in scene["objs"]:
        if not thing["hinge"]:
            yield from body(thing, hung.get(thing["id"], []))
    yield "</worldbody></mujoco>"


def run_mujoco(scene, count):
    import mujoco

    dt = 1 / 240
    text = "".join(mjcf(scene, dt))

    def build():
        model = mujoco.MjModel.from_xml_string(text)
        return model, mujoco.MjData(model)

    built = [timed(build) for _ in range(5 if count < 2000 else 1)]
    model, data = built[-1][1]
    rows = [("build", statistics.median(t for t, _ in built))]
    mujoco.mj_resetData(model, data)
    rows.append(("first forward", timed(lambda: mujoco.mj_forward(model, data))[0]))
    rows.append(("reset and forward", median(lambda: (mujoco.mj_resetData(model, data), mujoco.mj_forward(model, data)), 10)))
    mujoco.mj_resetData(model, data)

    def settle():
        steps = 0
        while data.time < 2:
            mujoco.mj_step(model, data)
            steps += 1
            if data.ntree_awake == 0:
                break
        return steps

    seconds, steps = timed(settle)
    rows.append((f"settle, {steps} steps", seconds))
    for _ in range(3):
        mujoco.mj_step(model, data)
    rows.append(("step, all asleep", median(lambda: mujoco.mj_step(model, data), 20)))
    thrown = [o["id"] for o in scene["objs"] if o["class"] in SMALL][:50]
    ids = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, f"o{i}") for i in thrown]
    dofs = [model.jnt_dofadr[model.body_jntadr[i]] for i in ids]
    times = []
    for step in range(480):
        if step % 40 == 0:
            for dof in dofs:
                data.qvel[dof + 2] += 0.4
        times.append(timed(lambda: mujoco.mj_step(model, data))[0])
    rows.append(("step, 50 active", statistics.median(times)))
    rows.append(("2 s, 50 active", sum(times)))
    show("mujoco", count, rows)


# --- PyBullet


def run_pybullet(scene, count):
    import pybullet as p

    dt = 1 / 60
    hung = doors(scene)

    def primitive(geometry):
        kind, size = next(iter(geometry.items()))
        return {
            "Box": lambda: (p.GEOM_BOX, dict(halfExtents=size), 8 * math.prod(size)),
            "Cyl": lambda: (
                p.GEOM_CYLINDER,
                dict(radius=size["r"], height=2 * size["h"]),
                2 * math.pi * size["r"] ** 2 * size["h"],
            ),
            "Ball": lambda: (p.GEOM_SPHERE, dict(radius=size), 4 / 3 * math.pi * size**3),
        }[kind]()

    def shape(thing, offset, cache):
        key = json.dumps([thing["parts"], offset])
        if key not in cache:
            made = [primitive(part["geo"]) for part in thing["parts"]]
            where = [[a + b for a, b in zip(part["pos"], offset)] for part in thing["parts"]]
            cache[key] = p.createCollisionShapeArray(
                shapeTypes=[m[0] for m in made],
                halfExtents=[m[1].get("halfExtents", [0, 0, 0]) for m in made],
                radii=[m[1].get("radius", 0) for m in made],
                lengths=[m[1].get("height", 0) for m in made],
                collisionFramePositions=where,
            )
        return cache[key]

    def mass(thing):
        return sum(primitive(part["geo"])[2] for part in thing["parts"]) * thing["density"]

    def centre(thing):
        volumes = [primitive(part["geo"])[2] for part in thing["parts"]]
        whole = sum(volumes)
        return [sum(v * part["pos"][i] for v, part in zip(volumes, thing["parts"])) / whole for i in range(3)]

    def links(thing):
        hinge = thing["hinge"]
        offset = [-v for v in hinge["anchor_child"]]
        return dict(
            linkMasses=[mass(thing)],
            linkCollisionShapeIndices=[shape(thing, offset, cache)],
            linkVisualShapeIndices=[-1],
            linkPositions=[hinge["anchor"]],
            linkOrientations=[[0, 0, 0, 1]],
            linkInertialFramePositions=[offset],
            linkInertialFrameOrientations=[[0, 0, 0, 1]],
            linkParentIndices=[0],
            linkJointTypes=[p.JOINT_REVOLUTE],
            linkJointAxis=[[0, 0, 1]],
        )

    def body(thing):
        extra = {}
        for door in hung.get(thing["id"], [])[:1]:
            extra = links(door)
        turn = p.getQuaternionFromEuler([0, 0, thing["yaw"]])
        made = p.createMultiBody(
            mass(thing),
            shape(thing, [0, 0, 0], cache),
            -1,
            thing["pos"],
            turn,
            baseInertialFramePosition=centre(thing),
            **extra,
        )
        p.changeDynamics(made, -1, lateralFriction=FRICTION, activationState=p.ACTIVATION_STATE_ENABLE_SLEEPING)
        return made

    def build():
        for pos, half in [scene["floor"], *scene["walls"]]:
            p.createMultiBody(0, p.createCollisionShape(p.GEOM_BOX, halfExtents=half), basePosition=pos)
        return {thing["id"]: body(thing) for thing in scene["objs"] if not thing["hinge"]}

    p.connect(p.DIRECT)
    times = []
    for _ in range(5 if count < 2000 else 1):
        cache = {}
        p.resetSimulation()
        p.setGravity(0, 0, -9.81)
        p.setPhysicsEngineParameter(fixedTimeStep=dt, numSolverIterations=50, deterministicOverlappingPairs=1)
        seconds, bodies = timed(build)
        times.append(seconds)
    rows = [("build", statistics.median(times)), ("first step", timed(p.stepSimulation)[0])]
    state = p.saveState()
    rows.append(("settle, 90 steps (never asleep)", timed(lambda: [p.stepSimulation() for _ in range(90)])[0]))
    rows.append(("step, at rest", median(p.stepSimulation, 20)))
    thrown = [bodies[o["id"]] for o in scene["objs"] if o["class"] in SMALL][:50]
    times = []
    for step in range(120):
        if step % 10 == 0:
            for one in thrown:
                linear, spin = p.getBaseVelocity(one)
                p.changeDynamics(one, -1, activationState=p.ACTIVATION_STATE_WAKE_UP)
                p.resetBaseVelocity(one, [linear[0], linear[1], linear[2] + 0.4], spin)
        times.append(timed(p.stepSimulation)[0])
    rows.append(("step, 50 active", statistics.median(times)))
    rows.append(("2 s, 50 active", sum(times)))
    rows.append(("restore state", median(lambda: p.restoreState(state), 10)))
    p.disconnect()
    show("pybullet", count, rows)


def main():
    counts = [int(word) for word in sys.argv[1:]] or [100, 500]
    for name, run in (("mujoco", run_mujoco), ("pybullet", run_pybullet)):
        try:
            __import__(name)
        except ImportError:
            print(f"{name} is not installed: skipped (pip install {name})")
            continue
        for count in counts:
            scene = read(count)
            if scene:
                run(scene, count)


if __name__ == "__main__":
    main()
