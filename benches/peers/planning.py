"""Compares VirtualCity's plans with Fast Downward's, and validates them with unified-planning.

    cargo run --release -p vc-planner --example instances -- target/instances
    pip install --target peers up-fast-downward unified-planning
    PYTHONPATH=peers python3 benches/peers/planning.py target/instances [--lama SECONDS] [--only PREFIX] [--speed]

Fast Downward's results are stored in the folder (`references.csv`) under the digest of the
problem, so that an interrupted run can be continued, and new plans are compared at once.
With --speed the time of VirtualCity's first plan is compared with that of LAMA's on the same
instances, pruned in the same way: LAMA's search alone, and the search with its own
preparations, without the translation.

For instances of up to six predicates the optimum is that of A* with LM-cut, and VirtualCity's
plans must equal it; for twelve LAMA has 60 seconds of CPU time. Each plan of VirtualCity is
completed to PDDL steps by searching for the omitted parameters, and validated by
unified-planning's SequentialPlanValidator, which must also reject it with any one step deleted.

The script prints a failure and exits with 1 if a plan is longer than the optimum, if plans for
12 predicates cost more than 0.92 of LAMA's on average or more than LAMA's anywhere, if a plan is
invalid, or if one with a step deleted is not rejected. If a package that it needs is missing, it
is skipped, which is not a failure.
"""

import argparse
import csv
import hashlib
import importlib.util
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import warnings

MISSING = [m for m in ("up_fast_downward", "unified_planning") if importlib.util.find_spec(m) is None]
if MISSING:
    print(f"SKIPPED: {' and '.join(MISSING)} not installed; see the head of this file")
    sys.exit(0)

from unified_planning.engines import SequentialPlanValidator  # noqa: E402
from unified_planning.environment import get_environment  # noqa: E402
from unified_planning.io import PDDLReader  # noqa: E402

get_environment().credits_stream = None
# A predicate and an action may have the same name in PDDL.
get_environment().error_used_name = False
warnings.simplefilter("ignore")
# Largest mean ratio to LAMA's cost for plans of 12 predicates.
MEAN_OF_LAMA = 0.92
DOWNWARD = pathlib.Path(importlib.util.find_spec("up_fast_downward").origin).parent / "downward" / "fast-downward.py"


def parse(text):
    """An s-expression as nested lists."""
    stack = [[]]
    for token in re.findall(r"[()]|[^\s()]+", re.sub(r";.*", "", text).lower()):
        if token == "(":
            stack.append([])
        elif token == ")":
            last = stack.pop()
            stack[-1].append(last)
        else:
            stack[-1].append(token)
    return stack[0][0]


def section(tree, name):
    return next((part[1:] for part in tree if isinstance(part, list) and part and part[0] == name), [])


def conjuncts(formula):
    return formula[1:] if formula and formula[0] == "and" else [formula] if formula else []


class Operator:
    def __init__(self, tree):
        self.name = tree[1]
        fields = dict(zip(tree[2::2], tree[3::2]))
        names = fields.get(":parameters", [])
        self.parameters = [n for n in names if n.startswith("?")]
        self.needs = [tuple(a) for a in conjuncts(fields.get(":precondition", []))]
        effects = conjuncts(fields[":effect"])
        self.adds = [tuple(e) for e in effects if e[0] != "not"]
        self.deletes = [tuple(e[1]) for e in effects if e[0] == "not"]


def bindings(needs, facts, bound):
    """All bindings of the free parameters with which the preconditions hold."""
    if not needs:
        yield bound
        return
    # The precondition with the fewest free parameters first.
    need = min(needs, key=lambda n: sum(a.startswith("?") and a not in bound for a in n[1:]))
    rest = [n for n in needs if n is not need]
    wanted = [bound.get(a, a) for a in need[1:]]
    for fact in facts.get(need[0], ()):
        new = dict(bound)
        if len(fact) == len(wanted) and all(
            new.setdefault(w, f) == f if w.startswith("?") else w == f for w, f in zip(wanted, fact)
        ):
            yield from bindings(rest, facts, new)


def complete(plan, domain, problem):
    """PDDL steps for VirtualCity's actions: `grab cup.12` gives verb and objects, the rest is searched for."""
    operators = [Operator(part) for part in domain if isinstance(part, list) and part[0] == ":action"]
    facts = {}
    for atom in section(problem, ":init"):
        facts.setdefault(atom[0], set()).add(tuple(atom[1:]))
    steps = []

    def extend(index, facts):
        if index == len(plan):
            # The goal may be expressed by an operator that marks it as met.
            for operator in (o for o in operators if o.name.startswith("met")):
                for bound in bindings(operator.needs, facts, {}):
                    return [(operator.name, [bound[p] for p in operator.parameters])]
            return []
        verb, *things = plan[index].split()
        things = [re.sub(r"[^a-z0-9_]", "_", t.lower()) for t in things]
        for operator in operators:
            if operator.name.split("-")[0] != verb:
                continue
            start = dict(zip(operator.parameters, things))
            for bound in bindings(operator.needs, facts, start):
                after = {name: set(atoms) for name, atoms in facts.items()}
                ground = lambda atom: tuple(bound.get(a, a) for a in atom[1:])  # noqa: E731
                for atom in operator.deletes:
                    after.get(atom[0], set()).discard(ground(atom))
                for atom in operator.adds:
                    after.setdefault(atom[0], set()).add(ground(atom))
                rest = extend(index + 1, after)
                if rest is not None:
                    return [(operator.name, [bound[p] for p in operator.parameters]), *rest]
        return None

    sys.setrecursionlimit(10_000)
    return extend(0, facts)


def valid(reader, problem, steps):
    text = "\n".join(f"({name} {' '.join(things)})" for name, things in steps)
    plan = reader.parse_plan_string(problem, text)
    return SequentialPlanValidator().validate(problem, plan).status.name == "VALID"


def with_constants(domain, problem):
    """Makes the objects in the domain its constants, as unified-planning requires."""
    objects = re.search(r"\(:objects(.*?)\)", problem, re.S)
    if objects is None:
        return domain, problem
    return domain.replace("(:constants", "(:constants" + objects[1], 1), problem.replace(objects[0], "")


def downward(domain, problem, arguments, seconds):
    """The cost of the best plan found, without the steps that mark the goal as met."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "plan"
        texts = with_constants(domain.read_text(), problem.read_text())
        domain, problem = (pathlib.Path(folder) / name for name in ("domain.pddl", "problem.pddl"))
        domain.write_text(texts[0])
        problem.write_text(texts[1])
        command = [sys.executable, DOWNWARD, "--overall-time-limit", f"{seconds}s", "--plan-file", out, *arguments]
        if "--alias" in arguments:
            command += [domain, problem]
        else:
            command = command[:-2] + [domain, problem] + arguments
        subprocess.run(list(map(str, command)), cwd=folder, capture_output=True, check=False)
        costs = []
        for path in pathlib.Path(folder).glob("plan*"):
            lines = [line for line in path.read_text().splitlines() if line.startswith("(")]
            costs.append(sum(not line.startswith("(met") for line in lines))
        return min(costs, default=None)


def first_plan(domain, problem):
    """Seconds of LAMA's first iteration: the search alone, and its whole search component."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for name, text in zip(("domain.pddl", "problem.pddl"), with_constants(domain.read_text(), problem.read_text())):
            (folder / name).write_text(text)
        command = [sys.executable, DOWNWARD, "--alias", "lama-first", "domain.pddl", "problem.pddl"]
        told = subprocess.run(list(map(str, command)), cwd=folder, capture_output=True, text=True, check=False).stdout
        times = [re.search(rf"{what} time: ([0-9.e-]+)s", told) for what in ("Search", "Total")]
        return [float(t[1]) for t in times] if all(times) else None


def compare_speed(folder, rows):
    """Prints the median ratio of LAMA's times to VirtualCity's, by the number of predicates."""
    by_number = {}
    for row in rows:
        domain, problem = (folder / f"{row['name']}.{what}.pddl" for what in ("domain", "problem"))
        times = first_plan(domain, problem)
        if times:
            ours = float(row["first"]) * 1e-6
            by_number.setdefault(int(row["predicates"]), []).append([t / ours for t in times])
    for number, ratios in sorted(by_number.items()):
        search, total = (statistics.median(column) for column in zip(*ratios))
        print(f"{number:>2} predicates, {len(ratios)} instances: LAMA's first plan takes {search:.0f} times as long as"
              f" ours by its search alone, {total:.0f} times with its preparations")


class References:
    """Stored costs of Fast Downward's plans, by problem, search and seconds; None if it found no plan."""

    def __init__(self, path):
        self.path = path
        lines = csv.reader(path.open()) if path.exists() else []
        self.known = {key: int(cost) if cost else None for key, _, cost in lines}

    def cost(self, name, domain, problem, arguments, seconds):
        key = hashlib.sha256()
        for part in (domain.read_text(), problem.read_text(), *arguments, str(seconds)):
            key.update(part.encode())
        key = key.hexdigest()[:24]
        if key not in self.known:
            self.known[key] = downward(domain, problem, arguments, seconds)
            with self.path.open("a", newline="") as file:
                csv.writer(file).writerow([key, name, self.known[key] if self.known[key] is not None else ""])
        return self.known[key]


def main():
    options = argparse.ArgumentParser()
    options.add_argument("folder", type=pathlib.Path)
    options.add_argument("--lama", type=int, default=60)
    options.add_argument("--optimum", type=int, default=300, help="seconds for A* with LM-cut")
    options.add_argument("--only", default="")
    options.add_argument("--no-validation", action="store_true")
    options.add_argument("--speed", action="store_true", help="compare only how long the first plans take")
    options = options.parse_args()
    rows = [r for r in csv.DictReader((options.folder / "instances.csv").open()) if r["name"].startswith(options.only)]
    if options.speed:
        compare_speed(options.folder, rows)
        return 0
    references = References(options.folder / "references.csv")
    equal, compared, ratios, accepted, rejected, mutants, checked = 0, 0, [], 0, 0, 0, 0
    failures = []
    for row in rows:
        domain, problem = (options.folder / f"{row['name']}.{what}.pddl" for what in ("domain", "problem"))
        ours = int(row["cost"])
        if int(row["predicates"]) <= 6:
            search = ["--search", "astar(lmcut())"]
            theirs = references.cost(row["name"], domain, problem, search, options.optimum)
            compared += theirs is not None
            equal += theirs == ours
            if theirs not in (None, ours):
                failures.append(f"{row['name']}: {ours} actions, the optimum has {theirs}")
        else:
            search = ["--alias", "seq-sat-lama-2011"]
            theirs = references.cost(row["name"], domain, problem, search, options.lama)
            # Without a plan by LAMA there is no comparison.
            if theirs:
                ratios.append(ours / theirs)
        verdict = ""
        if not options.no_validation:
            plan = (options.folder / f"{row['name']}.plan").read_text().splitlines()
            steps = complete(plan, parse(domain.read_text()), parse(problem.read_text()))
            checked += 1
            reader = PDDLReader()
            parsed = reader.parse_problem_string(*with_constants(domain.read_text(), problem.read_text()))
            good = steps is not None and valid(reader, parsed, steps)
            accepted += good
            verdict = "valid" if good else "INVALID"
            if not good:
                failures.append(f"{row['name']}: the plan is not valid")
            for i in range(len(plan) if good else 0):
                mutants += 1
                refused = not valid(reader, parsed, steps[:i] + steps[i + 1 :])
                rejected += refused
                if not refused:
                    failures.append(f"{row['name']}: without `{plan[i]}` the plan is valid as well")
        print(f"{row['name']:<16} ours {ours:>3}  theirs {theirs}  {row['microseconds']:>6} us  {verdict}", flush=True)
    print(f"equal to the optimum: {equal} of {compared} that LM-cut solves")
    if ratios:
        mean, most = sum(ratios) / len(ratios), max(ratios)
        print(f"12 predicates: {mean:.3f} of LAMA's cost on average, at most {most:.3f}")
        if mean > MEAN_OF_LAMA or most > 1:
            failures.append(f"12 predicates: at most {MEAN_OF_LAMA} on average and 1 anywhere are wanted")
    if checked:
        print(f"accepted: {accepted} of {checked} plans; rejected with a step deleted: {rejected} of {mutants}")
    if not rows:
        failures.append(f"no instance in {options.folder} begins with `{options.only}`")
    for failure in failures:
        print(f"FAILED: {failure}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
