"""Times renderers on a CPU on one scene: Open3D (Embree), MuJoCo, PyBullet, Mitsuba 3, and this project.

    pip install numpy open3d mujoco pybullet mitsuba
    python benches/peers/render.py                      # home 42, living room
    python benches/peers/render.py --seed 7 --room kitchen
    python benches/peers/render.py --file SCENE.glb     # the peers alone, on a file
    python benches/peers/render.py --obj reference.obj  # all but Mitsuba on the sixteen views of vc-render's bench

The scene comes from `cargo run --release --example render -- --files`, which writes glTF with a camera; all
render the same triangles from that camera. A peer that is not installed, or does not start, is skipped with
a message. Times are CPU time of the process, milliseconds a picture, medians. MuJoCo wants MUJOCO_GL=osmesa or
egl; Mitsuba's fast variant wants DRJIT_LIBLLVM_PATH, without it the scalar one is timed.

With --obj, this project's bench runs before and after the peers, and what a peer takes over the mean of what ours
takes for the same is set beside its bar, at the largest size; where one is missed, the script exits with 1. The file
is written by `cargo bench -p vc-render --bench costs`. MuJoCo draws the shadows of the sun alone, of the sun and a
lamp, and of the sun and all three lamps, as ours does: that is held to the bar. Ours draws shadow maps once for all
views, MuJoCo for each picture.

Equal quality: of Mitsuba and of this project's path tracer, each without smoothing, the error of N paths a pixel
against many paths of the same program is measured on the light itself and after an eye's curve; so is the time.
The root mean square of the light's error is given against the median brightness of the picture; of this, lights
that are in the picture are left out (brighter than 50 medians), as each of their pixels would count for thousands.
The square of the error falls with the time, so the time for one quality follows; a table at the end has them.
"""

import argparse
import json
import os
import pathlib
import re
import statistics
import struct
import subprocess
import time

import numpy as np

SIZES = ((84, 84), (300, 300), (640, 480))
ROOT = pathlib.Path(__file__).resolve().parents[2]


# --- the scene


class Scene:
    """Triangles by object, in the world, and the camera, as a glTF file has them."""

    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        length = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + length])
        self.bytes = data[28 + length:]
        self.objects, self.camera = [], None
        for root in self.json["scenes"][self.json.get("scene", 0)]["nodes"]:
            self.visit(root, np.eye(4), None)
        if self.camera is None:
            raise SystemExit(f"{path} has no camera; write it with the example `render --files`")

    def visit(self, index, above, owner):
        node = self.json["nodes"][index]
        world = above @ local(node)
        owner = node.get("name", owner) if "extras" in node and "class" in node["extras"].get("vc", {}) else owner
        if "camera" in node:
            shape = self.json["cameras"][node["camera"]]["perspective"]
            self.camera = (world, shape["yfov"])
        for part in self.json["meshes"][node["mesh"]]["primitives"] if "mesh" in node else ():
            points = self.array(part["attributes"]["POSITION"]).astype(np.float64) @ world[:3, :3].T + world[:3, 3]
            faces = self.array(part["indices"]).reshape(-1, 3).astype(np.int32)
            self.objects.append((owner, points.astype(np.float32), faces, self.json["materials"][part["material"]]))
        for child in node.get("children", ()):
            self.visit(child, world, owner)

    def array(self, index):
        accessor = self.json["accessors"][index]
        kind = {5123: np.uint16, 5125: np.uint32, 5126: np.float32, 5121: np.uint8}[accessor["componentType"]]
        width = {"SCALAR": 1, "VEC3": 3}[accessor["type"]]
        view = self.json["bufferViews"][accessor["bufferView"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        flat = np.frombuffer(self.bytes, kind, accessor["count"] * width, start)
        return flat.reshape(-1, width) if width > 1 else flat

    def view(self):
        """Eye, target and up."""
        world, _ = self.camera
        return world[:3, 3], world[:3, 3] - world[:3, 2], world[:3, 1]


class Reference:
    """The home that `cargo bench -p vc-render --bench costs` writes, seen by one of its cameras."""

    def __init__(self, path):
        self.objects, self.cameras, self.lamps, self.sun, self.which = [], [], [], None, 0
        material = {"pbrMetallicRoughness": {"baseColorFactor": [0.6, 0.6, 0.6, 1.0]}}
        first, name, points, faces = 1, None, [], []
        for line in [*pathlib.Path(path).read_text().splitlines(), "o end"]:
            kind, *rest = line.split()
            if line.startswith("# camera"):
                self.cameras.append([float(v) for v in rest[1:]])
            elif line.startswith("# lamp"):
                self.lamps.append([float(v) for v in rest[1:]])
            elif line.startswith("# sun"):
                self.sun = np.array([float(v) for v in rest[1:]])
            elif kind == "v":
                points.append([float(v) for v in rest])
            elif kind == "f":
                faces.append([int(v) - first for v in rest])
            elif kind == "o":
                if points:
                    self.objects.append((name, np.array(points, np.float32), np.array(faces, np.int32), material))
                first, name, points, faces = first + len(points), rest[0], [], []

    @property
    def camera(self):
        return None, np.radians(self.cameras[self.which][6])

    def view(self):
        eye, target = np.array(self.cameras[self.which][:3]), np.array(self.cameras[self.which][3:6])
        along = (target - eye) / np.linalg.norm(target - eye)
        up = np.array([0.0, 0.0, 1.0])
        return eye, target, up - along * along.dot(up)


def local(node):
    if "matrix" in node:
        return np.array(node["matrix"]).reshape(4, 4).T
    matrix = np.eye(4)
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    turn = np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ])
    matrix[:3, :3] = turn * np.array(node.get("scale", (1, 1, 1)))
    matrix[:3, 3] = node.get("translation", (0, 0, 0))
    return matrix


def colour(material):
    return material.get("pbrMetallicRoughness", {}).get("baseColorFactor", [1, 1, 1, 1])


def clear(material):
    return "KHR_materials_transmission" in material.get("extensions", {})


# --- timing


def median(work, runs):
    work()
    times = []
    for _ in range(runs):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return 1e3 * statistics.median(times)


# What is compared with what of ours: the peer, what it gives, what of ours gives it, and the wanted ratio.
BARS = (
    ("Open3D", "depth and ids, rays made before", "depth and nodes", 15),
    ("MuJoCo", "RGB, depth, ids, no shadows", "plain colours, depth, nodes", 3),
    ("MuJoCo", "RGB, depth, ids, shadows of 1", "colours, depth, nodes", None),
    ("MuJoCo", "RGB, depth, ids, shadows of 2", "colours, depth, nodes", None),
    ("MuJoCo", "RGB, depth, ids, shadows of 4", "colours, depth, nodes", 12),
    ("PyBullet", "RGB, depth, ids, no shadows", "plain colours, depth, nodes", 10),
    ("PyBullet", "RGB, depth, ids, shadows of 1", "colours, depth, nodes", 20),
)
SHOWN = {}


def show(peer, what, times):
    SHOWN[peer, what] = times
    print(f"{peer:12} {what:34}" + "".join(f"{t:10.2f}" for t in times) + "  ms CPU", flush=True)


def our_times():
    """Milliseconds of one thread by what is wanted, for each size."""
    command = ["cargo", "bench", "-p", "vc-render", "--bench", "render", "--", "first"]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    times = {}
    for what, size, one in re.findall(r"^(\S.*?)\s+(\d+x\d+)\s+([\d.]+) ms", text, re.MULTILINE):
        if size in [f"{w}x{h}" for w, h in SIZES]:
            times.setdefault(what, []).append(float(one))
    return times


def hold(rounds):
    """Prints ratios beside their bars, and tells whether all are met."""
    ours = {what: np.mean([times[what] for times in rounds], axis=0) for what in rounds[0]}
    for what, times in ours.items():
        show("ours", what, times)
    print("\nHow many times as long as ours:")
    met = True
    for peer, what, own, bar in BARS:
        if (peer, what) not in SHOWN:
            continue
        ratios = SHOWN[peer, what] / ours[own]
        wanted = f"at least {bar} at {SIZES[-1][0]}x{SIZES[-1][1]}" if bar else ""
        missed = bool(bar) and ratios[-1] < bar
        met = met and not missed
        print(f"{peer:12} {what:34}" + "".join(f"{r:10.1f}" for r in ratios) + f"  {wanted}{', MISSED' if missed else ''}")
    return met


# --- peers


def open3d(scene):
    import open3d

    caster = open3d.t.geometry.RaycastingScene(nthreads=1)
    for _, points, faces, _ in scene.objects:
        caster.add_triangles(open3d.core.Tensor(points), open3d.core.Tensor(faces.astype(np.uint32)))
    all_times = []
    for eye, target, up in views(scene):
        times = []
        for width, height in SIZES:
            rays = caster.create_rays_pinhole(
                fov_deg=float(fov_across(scene, width, height)),
                center=target, eye=eye, up=up, width_px=width, height_px=height)
            times.append(median(lambda: caster.cast_rays(rays, nthreads=1), 5))
        all_times.append(times)
    show("Open3D", "depth and ids, rays made before", mean(all_times))


def views(scene):
    """The scene from each of its cameras in turn."""
    for which in range(len(scene.cameras)) if isinstance(scene, Reference) else [0]:
        scene.which = which
        yield scene.view()


def mean(times):
    """Of views, for each size."""
    return np.mean(times, axis=0)


def fov_across(scene, width, height):
    return np.degrees(2 * np.arctan(np.tan(scene.camera[1] / 2) * width / height))


def mujoco(scene):
    import mujoco

    spec = mujoco.MjSpec()
    spec.visual.global_.offwidth, spec.visual.global_.offheight = SIZES[-1]
    spec.visual.quality.shadowsize = 2048
    for index, (_, points, faces, material) in enumerate(scene.objects):
        # Its compiler takes no mesh without volume.
        if np.linalg.matrix_rank(points - points[0], tol=1e-5) < 3:
            continue
        mesh = spec.add_mesh(name=f"m{index}", uservert=points.ravel().tolist(), userface=faces.ravel().tolist())
        mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
        mesh.maxhullvert = 8
        spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=f"m{index}", rgba=colour(material),
                                contype=0, conaffinity=0)
    lights = sun_and_lamps(mujoco, scene, spec)
    count = 0
    for eye, target, up in views(scene):
        x = np.cross(target - eye, up)
        camera = spec.worldbody.add_camera(name=f"eye{count}", pos=eye.tolist(), fovy=float(np.degrees(scene.camera[1])))
        camera.alt.xyaxes = [*x.tolist(), *up.tolist()]
        count += 1
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    for shadows in sorted({0, 1, 2, len(lights)} & set(range(len(lights) + 1))):
        model.light_castshadow[:] = [index < shadows for index in range(len(lights))]
        times = []
        for width, height in SIZES:
            with mujoco.Renderer(model, height, width) as renderer:

                def three(eye, renderer=renderer):
                    renderer.update_scene(data, eye)
                    renderer.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = shadows > 0
                    renderer.render()
                    renderer.enable_depth_rendering()
                    renderer.render()
                    renderer.disable_depth_rendering()
                    renderer.enable_segmentation_rendering()
                    renderer.render()
                    renderer.disable_segmentation_rendering()

                times.append(mean([median(lambda i=i: three(f"eye{i}"), 3) for i in range(count)]))
        show("MuJoCo", f"RGB, depth, ids, {f'shadows of {shadows}' if shadows else 'no shadows'}", times)


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

    client = pybullet.connect(pybullet.DIRECT)
    for _, points, faces, material in scene.objects:
        shape = pybullet.createVisualShape(pybullet.GEOM_MESH, vertices=points.tolist(), indices=faces.ravel().tolist(),
                                           rgbaColor=colour(material))
        pybullet.createMultiBody(0, -1, shape)
    for shadow in (0, 1):
        all_times = []
        for eye, target, up in views(scene):
            view = pybullet.computeViewMatrix(eye.tolist(), target.tolist(), up.tolist())
            times = []
            for width, height in SIZES:
                lens = pybullet.computeProjectionMatrixFOV(float(np.degrees(scene.camera[1])), width / height, 0.05, 50)
                times.append(median(lambda: pybullet.getCameraImage(
                    width, height, view, lens, shadow=shadow, renderer=pybullet.ER_TINY_RENDERER), 2))
            all_times.append(times)
        show("PyBullet", f"RGB, depth, ids, {'shadows of 1' if shadow else 'no shadows'}", mean(all_times))
    pybullet.disconnect(client)


def mitsuba(scene, quality):
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb" if os.environ.get("DRJIT_LIBLLVM_PATH") else "scalar_rgb")
    world = {"type": "scene", "integrator": {"type": "path", "max_depth": 12}}
    for index, (_, points, faces, material) in enumerate(scene.objects):
        mesh = mi.Mesh(f"m{index}", len(points), len(faces), has_vertex_normals=False, props=surface(mi, material))
        params = mi.traverse(mesh)
        params["vertex_positions"] = points.ravel()
        params["faces"] = faces.ravel().astype(np.uint32)
        params.update()
        world[f"m{index}"] = mesh
    world["sky"] = {"type": "constant", "radiance": {"type": "rgb", "value": [0.8, 0.9, 1.0]}}
    for index, light in enumerate(suns(scene)):
        world[f"sun{index}"] = light
    eye, target, up = scene.view()
    width, height = SIZES[-1]
    world["sensor"] = {
        "type": "perspective", "fov": float(np.degrees(scene.camera[1])), "fov_axis": "y", "near_clip": 0.01,
        "to_world": mi.ScalarTransform4f().look_at(eye.tolist(), target.tolist(), up.tolist()),
        "film": {"type": "hdrfilm", "width": width, "height": height, "rfilter": {"type": "box"}},
        "sampler": {"type": "independent"},
    }
    made = mi.load_dict(world)

    def picture(samples, seed):
        start = time.process_time()
        image = np.array(mi.render(made, spp=samples, seed=seed))[..., :3]
        return image, time.process_time() - start

    picture(1, 9)
    report(f"Mitsuba {mi.__version__} {mi.variant()}", picture, quality)


def surface(mi, material):
    pbr = material.get("pbrMetallicRoughness", {})
    if clear(material):
        kind = {"type": "thindielectric"}
    else:
        kind = {"type": "twosided", "inner": {
            "type": "principled", "base_color": {"type": "rgb", "value": [min(c, 0.9) for c in colour(material)[:3]]},
            "roughness": max(pbr.get("roughnessFactor", 1.0), 0.05), "metallic": pbr.get("metallicFactor", 1.0)}}
    props = mi.Properties()
    props["bsdf"] = mi.load_dict(kind)
    return props


def suns(scene):
    for node in scene.json["nodes"]:
        light = node.get("extensions", {}).get("KHR_lights_punctual")
        kind = scene.json["extensions"]["KHR_lights_punctual"]["lights"][light["light"]] if light else None
        if kind and kind["type"] == "directional":
            # The root turns z up to y up, as it does all nodes.
            upright = local({"rotation": (-0.5, -0.5, -0.5, 0.5)})
            towards = (upright @ local(node))[:3, 2]
            value = [c * kind["intensity"] / 5000 for c in kind["color"]]
            yield {"type": "directional", "direction": (-towards).tolist(), "irradiance": {"type": "rgb", "value": value}}


# --- equal quality


def eye_curve(image, middle):
    """Brightness as an eye has it that is used to a mean light."""
    return np.sqrt(np.clip(image / (2 * middle), 0, 1))


# Errors for which the time is given: of the light, in medians, and after the curve.
TARGETS = (0.1, 0.02)


def report(name, picture, quality):
    """Rows of the table of equal quality."""
    truth = picture(quality, 1000)[0]
    middle = np.median(truth[truth > 0])
    seen = truth.max(axis=2) < 50 * middle
    rows = []
    for samples in (4, 16):
        image, seconds = picture(samples, 1)
        light = rms((image - truth)[seen] / middle)
        curve = rms(eye_curve(image, middle) - eye_curve(truth, middle))
        # The reference's own noise is in the error too.
        share = quality / (quality + samples)
        times = [seconds * (error / target) ** 2 * share for error, target in zip((light, curve), TARGETS)]
        rows.append((name, samples, seconds, light, curve, *times))
    QUALITY.extend(rows)


QUALITY = []


def rms(errors):
    return float(np.sqrt(np.mean(np.square(errors, dtype=np.float64))))


def table():
    if QUALITY:
        print(f"\n{'equal quality':28} {'paths':>5} {'s CPU':>8} {'rms light':>10} {'after curve':>12} "
              f"{f's for {TARGETS[0]}':>10} {f's for {TARGETS[1]}':>10}")
    for name, samples, seconds, light, curve, linear, curved in QUALITY:
        print(f"{name:28} {samples:5} {seconds:8.2f} {light:10.4f} {curve:12.4f} {linear:10.1f} {curved:10.1f}")


def ours(options, out, quality):
    command = ["cargo", "run", "--release", "--example", "render", "--", "--seed", str(options.seed), "--room", options.room,
               "--out", str(out)]
    subprocess.run([*command, "--time"], cwd=ROOT, check=True)

    def picture(samples, seed):
        text = subprocess.run([*command, "--reference", str(samples), "--raw", "--noise", str(seed), "--files"], cwd=ROOT,
                              check=True, capture_output=True, text=True).stdout
        seconds = next(float(line.split()[-3]) for line in text.splitlines() if "paths for each pixel" in line)
        return exr(out / f"{options.room}_{options.seed}_reference.exr"), seconds

    report("this project", picture, quality)


def exr(path):
    """Reads the plain OpenEXR files that this project writes."""
    data = path.read_bytes()
    at, values = 8, {}
    while data[at]:
        name, kind, rest = data[at:].split(b"\0", 2)
        at += len(name) + len(kind) + 2
        size = struct.unpack_from("<i", data, at)[0]
        values[name.decode()] = data[at + 4:at + 4 + size]
        at += 4 + size
    x, y, right, bottom = struct.unpack("<4i", values["dataWindow"])
    width, height = right - x + 1, bottom - y + 1
    first = at + 1 + 8 * height
    rows = np.frombuffer(data, np.uint8, offset=first).reshape(height, -1)[:, 8:]
    # Blue, green, red.
    return rows.copy().view(np.float32).reshape(height, -1, width).transpose(0, 2, 1)[..., ::-1]


def peers(scene, which):
    count = sum(len(o[2]) for o in scene.objects)
    print(f"{count} triangles, {len(scene.objects)} meshes; " + ", ".join(f"{w}x{h}" for w, h in SIZES), flush=True)
    for name, peer in which:
        try:
            peer(scene)
        except ImportError as error:
            print(f"{name}: skipped, {error} (pip install {name})", flush=True)
        except Exception as error:
            print(f"{name}: skipped, it does not run here: {type(error).__name__}: {error}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=42)
    parser.add_argument("--room", default="livingroom")
    parser.add_argument("--file", type=pathlib.Path)
    parser.add_argument("--obj", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "peers")
    parser.add_argument("--truth", type=int, default=256, help="paths of the picture that errors are measured against")
    options = parser.parse_args()
    if options.obj:
        before = our_times()
        peers(Reference(options.obj), (("open3d", open3d), ("mujoco", mujoco), ("pybullet", pybullet)))
        raise SystemExit(0 if hold([before, our_times()]) else 1)
    file = options.file
    if file is None:
        command = ["cargo", "run", "--release", "--example", "render", "--", "--seed", str(options.seed),
                   "--room", options.room, "--out", str(options.out), "--files"]
        subprocess.run(command, cwd=ROOT, check=True)
        file = options.out / f"{options.room}_{options.seed}.glb"
    peers(Scene(file), (("open3d", open3d), ("mujoco", mujoco), ("pybullet", pybullet),
                        ("mitsuba", lambda s: mitsuba(s, options.truth))))
    if options.file is None:
        ours(options, options.out, options.truth)
    table()


if __name__ == "__main__":
    main()
