"""Counts the vehicle-steps in a second of CPU, here and in SUMO, on a grid of 30 by 30 junctions with lights.

    pip install eclipse-sumo==1.28.0
    python benches/peers/traffic.py            # runs the bench `traffic` of vc-traffic, too
    python benches/peers/traffic.py --sumo     # SUMO alone
    python benches/peers/traffic.py --sumo --size 6 --cars 400  # a smaller grid

Streets are 200 m from junction to junction, with two lanes in each direction; 11,500 cars set out within 200 s between random streets, as
in the bench. SUMO's steps are its usual ones, of a second; ours are a tenth of one, and timed by the clock, on one thread. The seconds from 210 to 270 are timed, as the
difference between two runs, so that loading, routes and departures before do not count. Without `eclipse-sumo` it says so and ends well.
"""

import argparse
import os
import pathlib
import random
import re
import resource
import subprocess
import tempfile
import xml.etree.ElementTree as ET

PROJECT = pathlib.Path(__file__).resolve().parents[2]
WITHIN, FROM, TO = 200, 210, 270


def binary(name):
    try:
        import sumo
    except ImportError:
        return None
    return os.path.join(sumo.SUMO_HOME, "bin", name)


def cpu(command):
    """The seconds of CPU that a command takes."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def demand(net, routes, cars):
    edges = [edge.get("id") for edge in ET.parse(net).getroot().iter("edge") if edge.get("function") is None]
    random.seed(7)
    trips = sorted((random.uniform(0, WITHIN), *random.sample(edges, 2)) for _ in range(cars))
    with open(routes, "w") as file:
        file.write('<routes><vType id="car" carFollowModel="IDM" length="4.6" tau="1.2" minGap="2" accel="1.5" decel="2"/>\n')
        for number, (depart, begin, end) in enumerate(trips):
            file.write(f'<trip id="{number}" type="car" depart="{depart:.2f}" from="{begin}" to="{end}" departLane="best"/>\n')
        file.write("</routes>\n")


def theirs(size, cars):
    with tempfile.TemporaryDirectory() as folder:
        net, routes, summary = (os.path.join(folder, name) for name in ("net.xml", "routes.xml", "summary.xml"))
        subprocess.run(
            [binary("netgenerate"), "--grid", "--grid.number", str(size), "--grid.length", "200", "-L", "2"]
            + ["--default-junction-type", "traffic_light", "--grid.attach-length", "200", "-o", net],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        demand(net, routes, cars)
        run = [binary("sumo"), "-n", net, "-r", routes, "--no-step-log", "--time-to-teleport", "-1", "--seed", "1"]
        run += ["--summary-output", summary, "--no-warnings"]
        first = cpu([*run, "--end", str(FROM)])
        both = cpu([*run, "--end", str(TO)])
        steps = [step for step in ET.parse(summary).getroot().iter("step") if float(step.get("time")) >= FROM]
        count = sum(int(step.get("running")) for step in steps)
        halting = sum(int(step.get("halting")) for step in steps) / count
        return count / (both - first), count / len(steps), halting


def ours():
    text = subprocess.run(
        ["cargo", "bench", "-p", "vc-traffic", "--bench", "traffic"], cwd=PROJECT, check=True, capture_output=True, text=True
    ).stdout
    rows = [line for line in text.splitlines() if "million" in line]
    return [float(re.search(r"([\d.]+) million", row).group(1)) * 1e6 for row in rows]


def main():
    parser = argparse.ArgumentParser(description="vehicle-steps in a second of CPU, here and in SUMO")
    parser.add_argument("--sumo", action="store_true", help="SUMO alone")
    parser.add_argument("--size", type=int, default=30, help="junctions along a side of SUMO's grid")
    parser.add_argument("--cars", type=int, default=11_500, help="cars that set out there")
    arguments = parser.parse_args()
    if binary("sumo") is None:
        print("SKIPPED: eclipse-sumo is not installed")
        return
    steps, running, halting = theirs(arguments.size, arguments.cars)
    print(f"SUMO: {steps / 1e3:.0f} thousand vehicle-steps a second of CPU, {running:.0f} vehicles, {halting:.0%} of them stand")
    if arguments.sumo:
        return
    for own in ours():
        print(f"vc-traffic: {own / 1e3:.0f} thousand, {own / steps:.0f} times SUMO's")


if __name__ == "__main__":
    main()
