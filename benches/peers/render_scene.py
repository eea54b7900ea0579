"""Scenes for these scripts: glTF as written by the example `render --files`, OBJ as written by vc-render's bench."""

import json
import pathlib
import struct
import subprocess

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]


def command(options):
    """The command line of the example that renders a room of a home."""
    return ["cargo", "run", "--release", "--example", "render", "--", "--seed", str(options.seed), "--room", options.room,
            "--out", str(options.out)]


def generated(options):
    """A room of a generated home."""
    subprocess.run([*command(options), "--files"], cwd=ROOT, check=True)
    return Scene(options.out / f"{options.room}_{options.seed}.glb")


def which_room(parser):
    parser.add_argument("--seed", type=int, default=42)
    parser.add_argument("--room", default="livingroom")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "peers")


class Scene:
    """Triangles by object, in world coordinates, and the camera of a glTF file."""

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
    """The home written by `cargo bench -p vc-render --bench costs`, with its cameras."""

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


def views(scene):
    """Eye, target and up of each of a scene's cameras in turn."""
    for which in range(len(scene.cameras)) if isinstance(scene, Reference) else [0]:
        scene.which = which
        yield scene.view()
