"""Why a junction has lights in vc-map's import and not in netconvert's, or the other way round; used by maps.py.

A cause is not supposed but tried: netconvert reads the file again with one option changed, or with one tag changed, and if the
difference goes away that was its cause. A difference that goes away for no change is unexplained.
"""

import functools
import math
import re
import xml.etree.ElementTree as ET

# Two junctions are the same if they are this near, metres: each side joins nodes in its own way.
NEAR = 45.0
# A crossing is the last thing before the end of a street up to this distance, metres.
END = 15.0
STREET = r"highway\.(motorway|trunk|primary|secondary|tertiary|unclassified|residential|living_street)"

# What is changed, and what it means if lights that only we have are there then. A word that ends in `=` has a value after it.
FOR_OURS = [
    (("-", "--tls.discard-simple"), "only people cross there, or few roads meet: --tls.discard-simple drops such lights"),
    (("-", "--tls.join", "--junctions.join"), "netconvert joins them with those of another junction"),
    (("+", "--tls.guess-signals.dist", "60"), "the signals stand more than 25 m before the junction: netconvert looks no farther"),
    (("tags", "-", "--tls.discard-simple"), "crossing=traffic_signals without highway=traffic_signals: netconvert knows the latter"),
]
# The same for lights that only netconvert has: what is changed if they are not there any more.
FOR_THEIRS = [
    (("-", "--tls.guess-signals"), "guessed from signals on the arms: --tls.guess-signals"),
    (("-", "--junctions.join", "--tls.join"), "netconvert joins nodes here that we keep apart"),
]


def lit_junctions(network):
    """Place and name of each junction with lights of a network in SUMO's form."""
    found = ET.parse(network).getroot().iter("junction")
    return [((float(j.get("x")), float(j.get("y"))), j.get("id")) for j in found if j.get("type", "").startswith("traffic_light")]


def gap(a, b):
    return ((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5


def pair(mine, their):
    """Pairs of the nearest of both, each in one pair at most, and those that are left."""
    links = sorted((gap(a[0], b[0]), i, j) for i, a in enumerate(mine) for j, b in enumerate(their) if gap(a[0], b[0]) < NEAR)
    ours, theirs = set(), set()
    for _, i, j in links:
        if i not in ours and j not in theirs:
            ours.add(i)
            theirs.add(j)
    return [a for i, a in enumerate(mine) if i not in ours], [b for j, b in enumerate(their) if j not in theirs]


def nodes(name):
    """The nodes of OpenStreetMap in the name of a junction of netconvert's."""
    return {int(word) for word in re.findall(r"\d{3,}", name)}


def changed(options, change):
    """Options of netconvert after a change."""
    words = [word for word in change if word != "tags"]
    if words[0] == "+":
        return [*options, *words[1:]]
    return [word for word in options if word not in words]


def with_tags(file):
    """A copy of a file in which a crossing with lights has the tag of a signal."""
    copy = file.with_suffix(".tags.osm")
    root = ET.parse(file)
    for node in root.getroot().iter("node"):
        tags = {tag.get("k"): tag for tag in node.iter("tag")}
        crossing = tags.get("crossing")
        if crossing is not None and "traffic_signals" in crossing.get("v") and "highway" in tags:
            tags["highway"].set("v", "traffic_signals")
    root.write(copy)
    return copy


class Causes:
    """Explains differences of lights; `convert(file, options, output)` lets netconvert read a file."""

    def __init__(self, file, options, convert, account):
        self.file, self.options, self.convert, self.account = file, options, convert, account

    @functools.cache
    def variant(self, change):
        output = self.file.with_suffix(".variant.net.xml")
        self.convert(with_tags(self.file) if "tags" in change else self.file, changed(self.options, change), output)
        return lit_junctions(output)

    @functools.cached_property
    def ends(self):
        """Places of netconvert's junctions at which streets end, in its own import."""
        root = ET.parse(self.file.with_name("own.net.xml")).getroot()
        streets = [edge for edge in root.iter("edge") if re.search(STREET, edge.get("type", ""))]
        meets = {edge.get(end) for edge in streets for end in ["from", "to"]}
        dead = [j for j in root.iter("junction") if j.get("type") == "dead_end" and j.get("id") in meets]
        return [(float(j.get("x")), float(j.get("y"))) for j in dead]

    def told(self, numbers):
        """A line of our account on one of some nodes that is about lights."""
        lines = [line for line in self.account if re.search(r"light|signal", line)]
        return next((line for line in lines if numbers & {int(word) for word in re.findall(r"node (\d+)", line)}), None)

    def of_ours(self, place, numbers, mine, their):
        one = next((name for _, name in their if numbers & nodes(name)), None)
        if one is not None:
            return f"one with others in netconvert's {one}"
        for change, why in FOR_OURS:
            # As many as there are of ours, since others may stand near.
            def count(found):
                return sum(gap(place, other[0]) < NEAR for other in found)

            if count(self.variant(change)) > count(their):
                return why
        end = min((gap(place, other) for other in self.ends), default=math.inf)
        return f"the street ends {end:.0f} m on, at the edge: netconvert rules no dead end" if end < END else None

    def of_theirs(self, place, name, mine):
        own = next((numbers for _, numbers in mine if numbers & nodes(name)), None)
        if own is not None:
            return f"one with others at our junction of nodes {sorted(own)[:4]}"
        line = self.told(nodes(name))
        if line is not None:
            return f"our account: {line}"
        for change, why in FOR_THEIRS:
            if not any(gap(place, other) < 5.0 for other, _ in self.variant(change)):
                return why
        return None

    def explain(self, mine, their):
        """A line for each junction with lights that one side has alone, and the number of those without a cause."""
        alone, others = pair(mine, their)
        causes = [("here", place, self.of_ours(place, numbers, mine, their)) for place, numbers in alone]
        causes += [("there", place, self.of_theirs(place, name, mine)) for place, name in others]
        lines = [f"    only {side}, {x:.0f} {y:.0f}: {why or 'unexplained'}" for side, (x, y), why in causes]
        return lines, sum(why is None for *_, why in causes)
