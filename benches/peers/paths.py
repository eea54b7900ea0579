"""Times path tracing at equal quality with Mitsuba 3 and this project, on a room of a generated home.

    pip install numpy mitsuba
    python benches/peers/paths.py                      # home 42, living room
    python benches/peers/paths.py --seed 7 --room kitchen --truth 64

For both programs, without denoising, the script measures the CPU time and the error of N paths per pixel against many
paths of the same program, on the radiance itself and after a tone curve. The root mean square error of the radiance is
relative to the median brightness of the picture; it leaves out light sources in the picture (brighter than 50 medians),
since each of their pixels would count for thousands. The squared error is inversely proportional to the time, which
gives the time for a fixed quality. Mitsuba's fast variant requires DRJIT_LIBLLVM_PATH; without it the scalar one is
timed, and without Mitsuba this project alone.
"""

import argparse
import os
import struct
import subprocess
import time

import numpy as np

from render_scene import ROOT, clear, colour, command, generated, local, which_room

SIZE = (640, 480)


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
    width, height = SIZE
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
            # The root rotates z up to y up, for all nodes.
            upright = local({"rotation": (-0.5, -0.5, -0.5, 0.5)})
            towards = (upright @ local(node))[:3, 2]
            value = [c * kind["intensity"] / 5000 for c in kind["color"]]
            yield {"type": "directional", "direction": (-towards).tolist(), "irradiance": {"type": "rgb", "value": value}}


def eye_curve(image, middle):
    """Perceived brightness of an eye adapted to a mean luminance."""
    return np.sqrt(np.clip(image / (2 * middle), 0, 1))


# Errors for which the time is given: of the radiance, in medians, and after the tone curve.
TARGETS = (0.1, 0.02)


def report(name, picture, quality):
    """Prints the rows of the table of equal quality."""
    truth = picture(quality, 1000)[0]
    middle = np.median(truth[truth > 0])
    seen = truth.max(axis=2) < 50 * middle
    rows = []
    for samples in (4, 16):
        image, seconds = picture(samples, 1)
        light = rms((image - truth)[seen] / middle)
        curve = rms(eye_curve(image, middle) - eye_curve(truth, middle))
        # The error also contains the reference's own noise.
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


def ours(options):
    def picture(samples, seed):
        more = ["--reference", str(samples), "--raw", "--noise", str(seed), "--files"]
        text = subprocess.run([*command(options), *more], cwd=ROOT, check=True, capture_output=True, text=True).stdout
        seconds = next(float(line.split()[-3]) for line in text.splitlines() if "paths for each pixel" in line)
        return exr(options.out / f"{options.room}_{options.seed}_reference.exr"), seconds

    report("this project", picture, options.truth)


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


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    which_room(parser)
    parser.add_argument("--truth", type=int, default=256, help="paths of the picture that errors are measured against")
    options = parser.parse_args()
    scene = generated(options)
    try:
        mitsuba(scene, options.truth)
    except ImportError as error:
        print(f"mitsuba: skipped, {error} (pip install mitsuba)", flush=True)
    ours(options)
    table()


if __name__ == "__main__":
    main()
