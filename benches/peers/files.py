"""Checks the output of `--example render` with the programs that it is written for.

    cargo run --release --example render -- --files --reference 4 --out out/render
    pip install numpy pycocotools OpenEXR bpy
    python benches/peers/files.py out/render

numpy loads depth and flow, pycocotools boxes and masks, OpenEXR depth, flow and the reference picture's light,
Blender the scene with its camera and lights. The results are compared: depth is the same in both formats, and masks
have the stated areas and lie in their boxes. A reader that is not installed is skipped with a message; the exit
status is 1 if any of the others finds an error.
"""

import argparse
import pathlib
import sys


def reader(name):
    """A module, or None if it is not installed."""
    try:
        return __import__(name)
    except ImportError:
        print(f"SKIPPED: {name} is not installed; see the head of this file")
        return None


def check(holds, what):
    if not holds:
        print(f"WRONG: {what}")
        check.wrong += 1


check.wrong = 0


def numbers(stem, np):
    depth, flow = np.load(f"{stem}.depth.npy"), np.load(f"{stem}.flow.npy")
    check(depth.dtype == np.float32 and depth.ndim == 2, f"{stem}: depth is {depth.dtype} {depth.shape}")
    check(flow.shape == (*depth.shape, 2), f"{stem}: flow is {flow.shape}")
    check((depth > 0).all() and np.isfinite(depth).any(), f"{stem}: depth is not above zero")
    print(f"numpy: depth {depth.shape}, {np.isfinite(depth).mean():.1%} finite, flow {flow.shape}")
    return depth, flow


def pictures(stem, np, exr, depth, flow):
    if depth is not None:
        channels = exr.File(f"{stem}.exr", separate_channels=True).channels()
        for name, wanted in (("Z", depth), ("forward.u", flow[..., 0]), ("forward.v", flow[..., 1])):
            same = np.array_equal(channels[name].pixels, wanted, equal_nan=True)
            check(same, f"{stem}.exr: {name} is not what the NPY has")
        print(f"OpenEXR: {', '.join(sorted(channels))}, the same as the NPY")
    light = pathlib.Path(f"{stem}_reference.exr")
    if light.exists():
        channels = exr.File(str(light), separate_channels=True).channels()
        for name in "RGB":
            check(np.isfinite(channels[name].pixels).all(), f"{light}: {name} is not finite")
        print(f"OpenEXR: the reference picture's {', '.join(sorted(channels))}")


def annotations(stem, np, coco):
    found = coco.COCO(f"{stem}.coco.json")
    for one in found.loadAnns(found.getAnnIds()):
        mask = found.annToMask(one)
        rows, columns = np.nonzero(mask)
        x, y, width, height = one["bbox"]
        around = [columns.min(), rows.min(), np.ptp(columns) + 1, np.ptp(rows) + 1]
        check(mask.sum() == one["area"], f"{stem}: annotation {one['id']} has area {one['area']}, its mask {mask.sum()}")
        check(around == [x, y, width, height], f"{stem}: annotation {one['id']} has box {one['bbox']}, its mask {around}")
        check(found.loadCats([one["category_id"]])[0]["name"], f"{stem}: category {one['category_id']} has no name")
    print(f"pycocotools: {len(found.anns)} annotations of {len(found.cats)} categories")


def scene(stem, bpy):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=f"{stem}.glb")
    kinds = [thing.type for thing in bpy.data.objects]
    for kind in ("MESH", "CAMERA", "LIGHT"):
        check(kind in kinds, f"{stem}.glb: Blender finds no {kind}")
    count = {kind: kinds.count(kind) for kind in sorted(set(kinds))}
    print(f"Blender {bpy.app.version_string}: {count}, {len(bpy.data.materials)} materials")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="what --example render wrote to, with --files")
    folder = parser.parse_args().folder
    stems = [str(path).removesuffix(".coco.json") for path in sorted(folder.glob("*.coco.json"))]
    if not stems:
        sys.exit(f"there is no .coco.json in {folder}; see the head of this file")
    np, exr, bpy = (reader(name) for name in ("numpy", "OpenEXR", "bpy"))
    coco = reader("pycocotools") and __import__("pycocotools.coco").coco
    for stem in stems:
        print(stem)
        depth, flow = numbers(stem, np) if np else (None, None)
        if np and exr:
            pictures(stem, np, exr, depth, flow)
        if np and coco:
            annotations(stem, np, coco)
        if bpy:
            scene(stem, bpy)
    sys.exit(1 if check.wrong else 0)


if __name__ == "__main__":
    main()
