"""Holds vc-map's reading and writing of real maps against SUMO's netconvert, and drives on the result.

    pip install eclipse-sumo==1.28.0
    cargo build --release --example map
    python benches/peers/maps.py                   # the extracts of ../shared/data/osm, and the hand-drawn town
    python benches/peers/maps.py FILE.osm ...      # any other files
    python benches/peers/maps.py --drive           # an hour of random trips on each as well

For each file it prints the length of the lanes of through traffic that cars or buses may use, and the number of junctions with
lights, here and in netconvert's own import. map_lights.py finds the cause of each junction with lights that only one of the two
has. Then netconvert makes networks of our plain XML and of our OpenDRIVE. It fails if lengths differ by more than 5 %, if a
difference has no cause, if netconvert reports an error, or a warning of a kind that is not on the list below. Without
`eclipse-sumo` it says so and ends well.
"""

import gzip
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

import map_lights

PROJECT = pathlib.Path(__file__).resolve().parents[2]
TARGET = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", PROJECT / "target"))
EXAMPLE = TARGET / "release" / "examples" / "map"
IMPORT = (
    "--geometry.remove --ramps.guess --junctions.join --tls.guess-signals --tls.discard-simple --tls.join "
    "--sidewalks.guess --crossings.guess"
).split()
# Classes of through traffic, in our words and in those of OpenStreetMap.
THROUGH = {"motorway", "trunk", "primary", "secondary", "tertiary", "minor", "residential", "living"}
THROUGH |= {"unclassified", "living_street", "road"}
DRIVEN = {"passenger", "bus"}
# Seconds between random trips in an hour of driving: 450 and 900 of them.
PERIODS = [8, 4]

# Kinds of warnings that may come, each with its reason.
FINE = {
    r"Edge .* is not connected to outgoing edges": "a street ends at the edge of the extract, or is one-way into a dead end there",
    r"Lane .* is not connected from any incoming edge": "a lane is added at a junction: nobody comes from straight behind it",
    r"Invalid pedestrian topology": "SUMO builds one walking area on both sides of a crossing where people may walk on the street",
    r"Discarding invalid crossing": "as above: paths end on the carriageway, without a pavement",
    r"Unused state in tlLogic": "the light of such a crossing",
    r"Intersecting left turns": "left turns of a junction of several nodes cross; the signal's phases keep them apart",
    r"Found sharp turn with radius": "ways of OpenStreetMap have corners",
    r"Found angle of .* degrees": "ways of OpenStreetMap have corners",
    r"Speed of straight connection .* reduced": "SUMO slows vehicles where a junction bends",
    r"Speed of turning connection .* reduced": "SUMO slows vehicles where a junction bends",
    r"Ambiguity in turnarounds": "two carriageways end side by side; turning there is not in our connections",
    r"Edge .* has no lanes": "a path or pavement for which OpenDRIVE has a lane type that netconvert leaves out",
    r"Could not find edge .* for signal": "a signal on such a path, of bicycles for example",
    r"Connection .* is only .*m short": "two junctions nearly touch",
    r"lane .* has length 0": "two junctions nearly touch",
    r"Junction .* is too complicated": "a bus station whose bays netconvert cannot rule with lights",
    r"has a high cycle time": "the crossing of a long street for people takes its time",
    r"\d+ total messages of type": "a sum",
}


def sumo_home():
    try:
        import sumo
    except ImportError:
        return None
    return pathlib.Path(sumo.SUMO_HOME)


def run(command, folder):
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True)
    lines = [line.strip() for line in (done.stdout + done.stderr).splitlines() if line.strip()]
    return done.returncode, lines


def unknown(lines):
    """Errors, and warnings that are not on the list."""
    told = [line for line in lines if line.startswith(("Warning", "Error"))]
    return [line for line in told if not any(re.search(kind, line) for kind in FINE)]


def is_driven(lane):
    """Whether cars or buses may use a lane of a network in SUMO's form."""
    allow, disallow = lane.get("allow"), lane.get("disallow")
    if allow is not None:
        return bool(DRIVEN & set(allow.split()))
    closed = set((disallow or "").split())
    return "all" not in closed and not DRIVEN <= closed


def theirs(network):
    """Metres of lanes for through traffic of a network in SUMO's form, and its frame."""
    root = ET.parse(network).getroot()
    edges = [edge for edge in root.iter("edge") if edge.get("function") is None and is_through(edge.get("type", ""))]
    metres = sum(float(lane.get("length")) for edge in edges for lane in edge.iter("lane") if is_driven(lane))
    offset = [float(value) for value in root.find("location").get("netOffset").split(",")]
    return metres, offset, root.find("location").get("projParameter")


def is_through(kind):
    """Whether an edge's type has a class of through traffic: `highway.primary_link|railway.tram` has."""
    words = [word.removeprefix("highway.").removesuffix("_link") for word in kind.split("|")]
    return bool(THROUGH & set(words))


def ours(folder, name):
    """Metres of lanes for through traffic, and longitude and latitude of junctions with lights with their nodes."""
    features = json.loads((folder / f"{name}.geojson").read_text())["features"]
    lit, metres = [], 0.0
    for feature in features:
        p, points = feature["properties"], feature["geometry"]["coordinates"]
        if p["kind"] == "lane" and p["class"] in THROUGH and {"car", "bus"} & set(p["users"]):
            metres += length(points)
        elif p["kind"] == "junction" and p["control"] == "signals":
            lit.append((points, set(p["source"])))
    return metres, lit


def length(points):
    total = 0.0
    for (a, b), (c, d) in zip(points, points[1:]):
        x, y = (c - a) * math.cos(math.radians(b)) * 111_319.5, (d - b) * 111_132.0
        total += math.hypot(x, y)
    return total


def frame(projection):
    """From longitude and latitude to the metres of SUMO's frame, a UTM zone."""
    zone = int(re.search(r"zone=(\d+)", projection).group(1))
    centre = math.radians(zone * 6 - 183)
    a, f, k = 6378137.0, 1 / 298.257223563, 0.9996
    e2 = f * (2 - f)
    n = e2 / (1 - e2)

    def project(longitude, latitude):
        phi, lam = math.radians(latitude), math.radians(longitude) - centre
        v, t, c, s = a / math.sqrt(1 - e2 * math.sin(phi) ** 2), math.tan(phi) ** 2, n * math.cos(phi) ** 2, math.cos(phi) * lam
        m = a * (
            (1 - e2 / 4 - 3 * e2**2 / 64 - 5 * e2**3 / 256) * phi
            - (3 * e2 / 8 + 3 * e2**2 / 32 + 45 * e2**3 / 1024) * math.sin(2 * phi)
            + (15 * e2**2 / 256 + 45 * e2**3 / 1024) * math.sin(4 * phi)
            - 35 * e2**3 / 3072 * math.sin(6 * phi)
        )
        x = k * v * (s + (1 - t + c) * s**3 / 6) + 500000.0
        y = k * (m + v * math.tan(phi) * (s**2 / 2 + (5 - t + 9 * c) * s**4 / 24))
        return x, y

    return project


def drive(home, folder, network, period):
    """An hour of random trips: vehicles that ended, teleports by reason, and the places of the first ones."""
    trips = [sys.executable, home / "tools" / "randomTrips.py", "-n", network, "-o", "trips.xml", "-e", "3600", "-p", period]
    routes = ["-r", "routes.rou.xml", "--validate", "--fringe-factor", "10", "--seed", "1"]
    status, lines = run([*trips, *routes], folder)
    if status:
        return [f"    randomTrips failed: {lines[-1]}"]
    command = [home / "bin" / "sumo", "-n", network, "-r", "routes.rou.xml", "--end", "7200", "--no-step-log"]
    _, lines = run([*command, "--duration-log.statistics"], folder)
    kept = [line for line in lines if re.match(r"(Inserted|Running|Waiting|Teleports)", line)]
    teleports = [line for line in lines if "Teleporting" in line]
    more = [f"... and {len(teleports) - 20} more"] if len(teleports) > 20 else []
    return [f"    {line}" for line in [*kept, *teleports[:20], *more]]


def compare(home, folder, plain, name):
    """Lengths and lights here and in netconvert's own import; complaints."""
    left = ["--lefthand"] if "lefthand" in (folder / f"{name}.netccfg").read_text() else []

    def convert(file, options, output):
        return run([home / "bin" / "netconvert", "--osm-files", file, *options, *left, "-o", output], folder)

    convert(plain, IMPORT, "own.net.xml")
    metres, offset, projection = theirs(folder / "own.net.xml")
    here, lit = ours(folder, name)
    project = frame(projection)
    mine = [(tuple(value + shift for value, shift in zip(project(*place), offset)), nodes) for place, nodes in lit]
    their = map_lights.lit_junctions(folder / "own.net.xml")
    print(f"{name}: lanes {here:.0f} m here, {metres:.0f} m there ({100 * here / metres - 100:+.1f} %);", end=" ")
    print(f"lights at {len(mine)} junctions here, {len(their)} there", flush=True)
    account = (folder / f"{name}.report.txt").read_text().splitlines()
    lines, unexplained = map_lights.Causes(plain, IMPORT, convert, account).explain(mine, their)
    print(*lines, sep="\n", flush=True)
    wrong = [] if abs(here / metres - 1) <= 0.05 else [f"{name}: lanes differ by more than 5 %"]
    return wrong + [f"{name}: lights at {unexplained} junctions differ without a cause"] * bool(unexplained)


def accept(home, folder, name):
    """Networks of our files; complaints."""
    wrong = []
    for what, command in [
        ("plain XML", ["-c", f"{name}.netccfg"]),
        ("OpenDRIVE", ["--opendrive-files", f"{name}.xodr", "-o", "xodr.net.xml"]),
    ]:
        status, lines = run([home / "bin" / "netconvert", *command], folder)
        bad = unknown(lines) + ([f"status {status}"] if status else [])
        warnings = sum(line.startswith("Warning") for line in lines)
        print(f"    netconvert on our {what}: {'accepted' if not status else 'refused'}, {warnings} lines of warnings", flush=True)
        wrong += [f"{name}, {what}: {line}" for line in bad]
    return wrong


def check(home, file, folder, driving):
    name = file.name.split(".")[0]
    plain = folder / f"{name}.osm"
    plain.write_bytes(gzip.decompress(file.read_bytes()) if file.suffix == ".gz" else file.read_bytes())
    status, lines = run([EXAMPLE, plain, "--out", folder, "--scale", "0.5"], folder)
    if status:
        return [f"{name}: the example failed: {lines[-1]}"]
    wrong = compare(home, folder, plain, name) + accept(home, folder, name)
    for period in PERIODS if driving else []:
        print(f"  {3600 // period} random trips in an hour on our plain XML", flush=True)
        print(*drive(home, folder, f"{name}.net.xml", period), sep="\n", flush=True)
        print("  the same on netconvert's own import", flush=True)
        print(*[line for line in drive(home, folder, "own.net.xml", period) if "Teleporting" not in line], sep="\n", flush=True)
    return wrong


def main():
    home = sumo_home()
    if home is None:
        print("eclipse-sumo is not installed: nothing was compared")
        return
    driving = "--drive" in sys.argv
    given = [pathlib.Path(word) for word in sys.argv[1:] if word != "--drive"]
    data = pathlib.Path(os.environ.get("VC_DATA", PROJECT.parent / "shared" / "data")) / "osm"
    town = PROJECT / "vc-map" / "data" / "riverside.osm"
    files = given or [*sorted(data.glob("*.osm.gz")), town]
    wrong = []
    for file in files:
        with tempfile.TemporaryDirectory() as folder:
            wrong += check(home, file, pathlib.Path(folder), driving)
    print("\n".join(wrong) if wrong else "no errors, and no warnings of unknown kinds")
    sys.exit(bool(wrong))


main()
