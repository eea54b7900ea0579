"""Times renderers on a CPU on one scene: Open3D (Embree), MuJoCo, PyBullet, and this project.

    pip install numpy open3d mujoco pybullet
    VC_OUT=/tmp cargo bench -p vc-render --bench costs
    python benches/peers/render.py --obj /tmp/reference.obj  # the sixteen views of vc-render's bench, against the targets
    python benches/peers/render.py --seed 7 --room kitchen   # the peers alone, on a room of a generated home
    python benches/peers/render.py --file SCENE.glb          # the same, on a file

All render the same triangles from the same cameras. A peer that is not installed, or does not start, is skipped with a
message. Times are CPU time of the process, milliseconds per picture, medians. MuJoCo needs MUJOCO_GL=osmesa or egl.

With --obj, this project's bench runs before and after the peers, and the ratio of a peer's time to the mean of this
project's for the same work is compared with its target, at the largest size; if a target is missed, the script exits
with 1. MuJoCo draws the shadows of two lamps and of the sun and three lamps, each against this project with the same
lights. This project draws shadow maps once for all views, MuJoCo for each picture. `paths.py` compares path tracing.

Targets in milliseconds and in rays per second are those of one machine. The peers' times on that machine show how much
slower the present one is: the geometric mean of the ratios at a size is the pace, by which the targets are scaled.
"""

import argparse
import pathlib
import re
import statistics
import subprocess
import time

import numpy as np

from render_scene import ROOT, Reference, Scene, colour, generated, views, which_room

SIZES = ((84, 84), (300, 300), (640, 480))

# The comparisons: the peer, its output, this project's bench of the same output, and the target ratio.
BARS = (
    ("Open3D", "depth and ids, rays made before", "depth and nodes", 15),
    ("MuJoCo", "RGB, depth, ids, no shadows", "plain colours, depth, nodes", 3),
    ("MuJoCo", "RGB, depth, ids, shadows of 2", "colours of two lamps, the same", 12),
    ("MuJoCo", "RGB, depth, ids, shadows of 4", "colours, depth, nodes", 12),
    ("PyBullet", "RGB, depth, ids, no shadows", "plain colours, depth, nodes", 10),
    ("PyBullet", "RGB, depth, ids, shadows of 1", "colours, depth, nodes", 20),
)
# The peers' times on the machine on which the targets were set (Zen 4, quiet), for each size.
THERE = {
    ("Open3D", "depth and ids, rays made before"): (1.03, 12.4, 40.5),
    ("MuJoCo", "RGB, depth, ids, no shadows"): (10.4, 22.0, 38.8),
    ("MuJoCo", "RGB, depth, ids, shadows of 2"): (118, 138, 166),
    ("MuJoCo", "RGB, depth, ids, shadows of 4"): (184, 208, 251),
    ("PyBullet", "RGB, depth, ids, no shadows"): (25, 56, 133),
    ("PyBullet", "RGB, depth, ids, shadows of 1"): (48, 134, 347),
}
# This project's targets on that machine: milliseconds at a size, and million rays per second.
WANTED = (("labels, depth and flow", 2, 3.0), ("all six", 2, 12.0), ("all six", 0, 1.0))
RAYS = (("primary", 6.0), ("bounces", 2.5))
SHOWN = {}


def show(peer, what, times):
    SHOWN[peer, what] = times
    print(f"{peer:12} {what:34}" + "".join(f"{t:10.2f}" for t in times) + "  ms CPU", flush=True)


def median(work, runs):
    """Milliseconds of CPU time, after a first run that is not counted."""
    work()
    times = []
    for _ in range(runs):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return 1e3 * statistics.median(times)


# --- this project


def our_times():
    """Milliseconds of one thread by set of modalities, for each size."""
    command = ["cargo", "bench", "-p", "vc-render", "--bench", "render", "--", "first"]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    times = {}
    for what, size, one in re.findall(r"^(\S.*?)\s+(\d+x\d+)\s+([\d.]+) ms", text, re.MULTILINE):
        if size in [f"{w}x{h}" for w, h in SIZES]:
            times.setdefault(what, []).append(float(one))
    return times


def our_rays():
    """Million rays per second of one thread through the same home."""
    command = ["cargo", "bench", "-p", "vc-render", "--bench", "rays", "--", "home"]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    found = re.findall(r"/(\w+)\s+time:.*?thrpt:\s+\[\S+ \S+ (\S+) Melem/s", text, re.DOTALL)
    return {kind: float(rate) for kind, rate in found}


def keep_pace(rounds):
    """Prints the targets beside the measured figures scaled to that machine; returns whether all are met."""
    ratios = {key: np.array(SHOWN[key]) / there for key, there in THERE.items() if key in SHOWN}
    if not ratios:
        return True
    paces = np.exp(np.mean(np.log(list(ratios.values())), axis=0))
    print("\nHow many times as long peers take as where the bars were set:")
    for (peer, what), ratio in ratios.items():
        print(f"{peer:12} {what:34}" + "".join(f"{r:10.2f}" for r in ratio))
    print(f"{'pace':47}" + "".join(f"{p:10.2f}" for p in paces))
    print("\nOurs at that pace:")
    rows = [(f"{what}, {SIZES[at][0]}x{SIZES[at][1]}", np.mean([times[what][at] for times in rounds]), "ms",
             lambda value, at=at: value / paces[at], "at most", most) for what, at, most in WANTED]
    rays = our_rays()
    rows += [(f"rays, {kind}", rays[kind], "M/s", lambda value: value * paces[-1], "at least", least) for kind, least in RAYS]
    met = True
    for what, here, unit, there, side, bar in rows:
        missed = (there(here) > bar) == (side == "at most")
        met = met and not missed
        print(f"{what:34}{here:8.2f} {unit} here,{there(here):8.2f} there, {side} {bar}{', MISSED' if missed else ''}")
    return met


def hold(rounds):
    """Prints ratios beside their targets; returns whether all are met."""
    ours = {what: np.mean([times[what] for times in rounds], axis=0) for what in rounds[0]}
    for what, times in ours.items():
        show("ours", what, times)
    print("\nHow many times as long as ours:")
    met = True
    for peer, what, own, bar in BARS:
        if (peer, what) not in SHOWN:
            continue
        ratios = SHOWN[peer, what] / ours[own]
        missed = ratios[-1] < bar
        met = met and not missed
        wanted = f"at least {bar} at {SIZES[-1][0]}x{SIZES[-1][1]}{', MISSED' if missed else ''}"
        print(f"{peer:12} {what:34}" + "".join(f"{r:10.1f}" for r in ratios) + f"  {wanted}")
    return met


# --- peers


def open3d(scene):
    import open3d

    caster = open3d.t.geometry.RaycastingScene(nthreads=1)
    for _, points, faces, _ in scene.objects:
        caster.add_triangles(open3d.core.Tensor(points), open3d.core.Tensor(faces.astype(np.uint32)))

    def timed(eye, target, up, width, height):
        across = np.degrees(2 * np.arctan(np.tan(scene.camera[1] / 2) * width / height))
        rays = caster.create_rays_pinhole(
            fov_deg=float(across), center=target, eye=eye, up=up, width_px=width, height_px=height)
        return median(lambda: caster.cast_rays(rays, nthreads=1), 5)

    show("Open3D", "depth and ids, rays made before", of_views(scene, timed))


def of_views(scene, timed):
    """The mean over the views of a scene, for each size."""
    return np.mean([[timed(*view, *size) for size in SIZES] for view in views(scene)], axis=0)


def mujoco(scene):
    import mujoco

    spec = mujoco.MjSpec()
    spec.visual.global_.offwidth, spec.visual.global_.offheight = SIZES[-1]
    spec.visual.quality.shadowsize = 2048
    for index, (_, points, faces, material) in enumerate(scene.objects):
        # MuJoCo's compiler does not accept meshes without volume.
        if np.linalg.matrix_rank(points - points[0], tol=1e-5) < 3:
            continue
        mesh = spec.add_mesh(name=f"m{index}", uservert=points.ravel().tolist(), userface=faces.ravel().tolist())
        mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
        mesh.maxhullvert = 8
        spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=f"m{index}", rgba=colour(material),
                                contype=0, conaffinity=0)
    lights = sun_and_lamps(mujoco, scene, spec)
    eyes = []
    for eye, target, up in views(scene):
        x, name = np.cross(target - eye, up), f"eye{len(eyes)}"
        camera = spec.worldbody.add_camera(name=name, pos=eye.tolist(), fovy=float(np.degrees(scene.camera[1])))
        camera.alt.xyaxes = [*x.tolist(), *up.tolist()]
        eyes.append(name)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    every = list(range(len(lights)))
    # The lights that are on, and whether they cast shadows; the sun is the first.
    for on, shadows in [(every, False), ([1, 2], True), (every, True)][:: 1 if len(lights) > 2 else 2]:
        model.light_active[:] = [index in on for index in every]
        model.light_castshadow[:] = shadows
        times = []
        for width, height in SIZES:
            with mujoco.Renderer(model, height, width) as renderer:
                renderer.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = shadows
                work = [lambda eye=eye: three(renderer, data, eye) for eye in eyes]
                times.append(np.mean([median(one, 3) for one in work]))
        show("MuJoCo", f"RGB, depth, ids, {f'shadows of {len(on)}' if shadows else 'no shadows'}", times)


def three(renderer, data, eye):
    """MuJoCo's colours, depth and ids."""
    renderer.update_scene(data, eye)
    renderer.render()
    renderer.enable_depth_rendering()
    renderer.render()
    renderer.disable_depth_rendering()
    renderer.enable_segmentation_rendering()
    renderer.render()
    renderer.disable_segmentation_rendering()


def sun_and_lamps(mujoco, scene, spec):
    """The sun, and lamps that shine downwards; in homes from files only a light from above."""
    if not isinstance(scene, Reference):
        corners = np.concatenate([o[1] for o in scene.objects])
        down, middle = np.array([0.0, -1.0, 0.0]), (corners.min(0) + corners.max(0)) / 2
        return [spec.worldbody.add_light(pos=(middle - down).tolist(), dir=down.tolist())]
    kind = mujoco.mjtLightType
    sun = spec.worldbody.add_light(type=kind.mjLIGHT_DIRECTIONAL, pos=(8 * scene.sun).tolist(), dir=(-scene.sun).tolist())
    lamp = {"type": kind.mjLIGHT_SPOT, "dir": [0, 0, -1], "cutoff": 80, "exponent": 1}
    return [sun, *(spec.worldbody.add_light(pos=at, **lamp) for at in scene.lamps)]


def pybullet(scene):
    import pybullet

    pybullet.connect(pybullet.DIRECT)
    for _, points, faces, material in scene.objects:
        shape = pybullet.createVisualShape(pybullet.GEOM_MESH, vertices=points.tolist(), indices=faces.ravel().tolist(),
                                           rgbaColor=colour(material))
        pybullet.createMultiBody(0, -1, shape)
    for shadow in (0, 1):

        def timed(eye, target, up, width, height, shadow=shadow):
            view = pybullet.computeViewMatrix(eye.tolist(), target.tolist(), up.tolist())
            lens = pybullet.computeProjectionMatrixFOV(float(np.degrees(scene.camera[1])), width / height, 0.05, 50)
            return median(lambda: pybullet.getCameraImage(
                width, height, view, lens, shadow=shadow, renderer=pybullet.ER_TINY_RENDERER), 2)

        show("PyBullet", f"RGB, depth, ids, {'shadows of 1' if shadow else 'no shadows'}", of_views(scene, timed))
    pybullet.disconnect()


def peers(scene):
    count = sum(len(o[2]) for o in scene.objects)
    print(f"{count} triangles, {len(scene.objects)} meshes; " + ", ".join(f"{w}x{h}" for w, h in SIZES), flush=True)
    for peer in (open3d, mujoco, pybullet):
        name = peer.__name__
        try:
            peer(scene)
        except ImportError as error:
            print(f"{name}: skipped, {error} (pip install {name})", flush=True)
        except Exception as error:
            print(f"{name}: skipped, it does not run here: {type(error).__name__}: {error}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    which_room(parser)
    parser.add_argument("--file", type=pathlib.Path)
    parser.add_argument("--obj", type=pathlib.Path)
    options = parser.parse_args()
    if options.obj is None:
        return peers(Scene(options.file) if options.file else generated(options))
    before = our_times()
    peers(Reference(options.obj))
    rounds = [before, our_times()]
    met = [hold(rounds), keep_pace(rounds)]
    raise SystemExit(0 if all(met) else 1)


if __name__ == "__main__":
    main()
