"""Lets planners of others solve the problems of the example pddl_problems.

    pip install pyperplan up-fast-downward unified-planning
    cargo run --release -p vc-tasks --example pddl_problems -- write FOLDER
    python3 vc-tasks/peers/pddl_plans.py FOLDER
    cargo run --release -p vc-tasks --example pddl_problems -- check FOLDER

Each planner that is installed solves every problem; a plan is put beside the problem
as `NAME.plan`. unified-planning's validator judges the plans, and VAL where its
`Validate` is on the path. What is not installed is said and passed over. Times are
wall clock, with start-up. Exits with 1 if a planner refuses a problem or a plan is
not valid.
"""

import importlib.util
import pathlib
import shutil
import subprocess
import sys
import time
import warnings
from collections import Counter

LIMIT = 120


def fast_downward():
    found = importlib.util.find_spec("up_fast_downward")
    if not found:
        return None
    script = pathlib.Path(found.origin).parent / "downward" / "fast-downward.py"
    return lambda folder, plan: [
        sys.executable, str(script), "--plan-file", str(plan), str(folder / "domain.pddl"),
        str(folder / "problem.pddl"), "--search", "eager_greedy([ff()])",
    ]


def pyperplan():
    if not importlib.util.find_spec("pyperplan"):
        return None
    return lambda folder, plan: [
        sys.executable, "-m", "pyperplan", "-H", "hff", "-s", "gbf", str(folder / "domain.pddl"),
        str(folder / "problem.pddl"),
    ]


PLANNERS = {"fast-downward": fast_downward(), "pyperplan": pyperplan()}


def judged_by_val(folder, plan):
    files = [str(folder / "domain.pddl"), str(folder / "problem.pddl"), str(plan)]
    done = subprocess.run(["Validate", *files], capture_output=True, text=True, cwd=folder)
    return "Plan valid" in done.stdout


def judged_by_unified_planning(folder, plan):
    from unified_planning.engines import SequentialPlanValidator
    from unified_planning.environment import get_environment
    from unified_planning.io import PDDLReader

    # In PDDL a predicate and an action may have one name.
    get_environment().error_used_name = False
    warnings.simplefilter("ignore")
    reader = PDDLReader()
    problem = reader.parse_problem(str(folder / "domain.pddl"), str(folder / "problem.pddl"))
    return bool(SequentialPlanValidator().validate(problem, reader.parse_plan(problem, str(plan))))


JUDGES = {
    "VAL": judged_by_val if shutil.which("Validate") else None,
    "unified-planning": judged_by_unified_planning if importlib.util.find_spec("unified_planning") else None,
}


def solve(name, command, folder, counts):
    plan = folder / f"{name}.plan"
    plan.unlink(missing_ok=True)
    start = time.time()
    try:
        done = subprocess.run(command(folder, plan), capture_output=True, text=True, timeout=LIMIT, cwd=folder)
    except subprocess.TimeoutExpired:
        counts["time out"] += 1
        return f"no plan in {LIMIT} s"
    spent = time.time() - start
    if name == "pyperplan" and (folder / "problem.pddl.soln").exists():
        (folder / "problem.pddl.soln").rename(plan)
    if not plan.exists():
        counts["WITHOUT A PLAN"] += 1
        return f"NO PLAN: {(done.stderr or done.stdout).strip().splitlines()[-1:]}"
    counts["solved"] += 1
    steps = sum(line.startswith("(") for line in plan.read_text().splitlines())
    said = [f"{steps} steps in {spent:.2f} s"]
    for judge in filter(JUDGES.get, JUDGES):
        verdict = "valid" if JUDGES[judge](folder, plan) else "NOT VALID"
        counts[f"{verdict} by {judge}"] += 1
        said.append(f"{judge}: {verdict}")
    return ", ".join(said)


def main(root):
    root = pathlib.Path(root).resolve()
    for name, tool in [*JUDGES.items(), *PLANNERS.items()]:
        if not tool:
            print(f"SKIPPED: {name} is not installed")
    failed = False
    for name, command in PLANNERS.items():
        counts = Counter()
        for problem in sorted(root.glob("**/problem.pddl")) if command else []:
            said = solve(name, command, problem.parent, counts)
            print(f"{name} {problem.parent.relative_to(root)}: {said}", flush=True)
        if command:
            print(f"{name}:", *(f"{number} {what}," for what, number in sorted(counts.items())))
        failed |= any(what.isupper() or what.startswith("NOT") for what in counts)
    sys.exit(failed)


if __name__ == "__main__":
    main(sys.argv[1])
