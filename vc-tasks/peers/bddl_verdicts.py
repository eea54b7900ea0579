"""Compares our verdicts on BEHAVIOR's activities with those of the PyPI package bddl.

    pip install bddl==3.6.0 numpy future
    cargo run --release -p vc-tasks --example bddl_verdicts -- FOLDER 10 > verdicts.jsonl
    python3 vc-tasks/peers/bddl_verdicts.py verdicts.jsonl

FOLDER is where the packages' activities lie. Each line of the file is a state; the
package's evaluator judges the same facts. In compatible mode the verdict and the set
of satisfied heads must be equal. In strict mode a head may differ only where things
cannot be paired off: that is looked up with a matching of this script's own.
Exits with 1 if anything differs otherwise.
"""

import json
import sys
import time
from collections import Counter

try:
    from bddl import condition_evaluation as ce
    from bddl.logic_base import BinaryAtomicFormula, UnaryAtomicFormula
    from bddl.parsing import parse_problem
except ImportError as missing:
    print(f"SKIPPED: {missing}; pip install bddl==3.6.0 numpy future")
    sys.exit(0)

FACTS = set()
# Two words for what is one relation here.
WORDS = {"onfloor": "ontop"}


class Thing:
    def __init__(self, name):
        self.name = name


def truth(word, *things):
    if word == "real":
        return not truth("future", *things)
    return " ".join((WORDS.get(word, word), *things)) in FACTS


def predicate(word, binary):
    if binary:
        def evaluate(self, a, b):
            return truth(word, a.name, b.name)
    else:
        def evaluate(self, a):
            return truth(word, a.name)
    base = BinaryAtomicFormula if binary else UnaryAtomicFormula
    return type(word, (base,), {"STATE_NAME": word, "_evaluate": evaluate, "_sample": lambda *_: None})


UNARY = """cooked frozen open folded unfolded toggled_on hot on_fire future real broken dusty stained soaked
    sliced""".split()


class Backend:
    known = {}

    def get_predicate_class(self, word):
        return self.known.setdefault(word, predicate(word, word not in UNARY))


def cells(pairs, label):
    """Which second things go with each first one, by the second one's name."""
    return [{c.scope[label] for c in row if c.evaluate()} for row in pairs.children]


def matching(rows):
    partner = {}

    def place(row, seen):
        for column in rows[row]:
            if column not in seen:
                seen.add(column)
                if column not in partner or place(partner[column], seen):
                    partner[column] = row
                    return True
        return False

    return sum(place(row, set()) for row in range(len(rows)))


def strict_pairs(self):
    first, second, _ = self.body
    objects = [self.object_map[iterable[2]] for iterable in (first, second)]
    return matching(cells(self, second[0].strip("?"))) >= min(len(set(o)) for o in objects)


def strict_number(self):
    _, _, second, _ = self.body
    return matching(cells(self, second[0].strip("?"))) == self.N


def compiled(path):
    text = open(path).read()
    domain = "omnigibson" if "(:domain omnigibson)" in text else "igibson"
    _, objects, _, goal = parse_problem("", 0, domain, predefined_problem=text)
    scope = {name: Thing(name) for name in ce.create_scope(objects)}
    return ce.compile_state(goal, Backend(), scope=scope, object_map=objects, generate_ground_options=False)


def satisfied(goal):
    start = time.process_time()
    met = set(ce.evaluate_state(goal)[1]["satisfied"])
    return met, time.process_time() - start


def indices(flags):
    return {i for i, flag in enumerate(flags) if flag}


def main(path):
    goals, counts, faults, spent = {}, Counter(), [], 0.0
    loose = (ce.ForPairs.evaluate, ce.ForNPairs.evaluate)
    for line in open(path):
        state = json.loads(line)
        file = state["file"]
        if file not in goals:
            goals[file] = compiled(file)
        FACTS.clear()
        FACTS.update(state["facts"])
        ours, strictly = indices(state["marginal"]), indices(state["matching"])
        theirs, seconds = satisfied(goals[file])
        spent += seconds
        ce.ForPairs.evaluate, ce.ForNPairs.evaluate = strict_pairs, strict_number
        paired, _ = satisfied(goals[file])
        ce.ForPairs.evaluate, ce.ForNPairs.evaluate = loose
        counts["states"] += 1
        counts["met in full"] += len(theirs) == len(goals[file])
        counts["heads met"] += len(theirs)
        counts["met only where pairs are not matched"] += ours != strictly
        if ours != theirs:
            faults.append(f"{file}: heads {sorted(ours)}, the package says {sorted(theirs)}")
        if strictly != paired:
            faults.append(f"{file}: strictly {sorted(strictly)}, by matching {sorted(paired)}")
    print(f"{len(goals)} activities", *(f"{number} {what}" for what, number in counts.items()), sep=", ")
    print(f"{len(faults)} differences; the package took {spent * 1e3:.1f} ms")
    print(*faults[:20], sep="\n")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main(sys.argv[1])
