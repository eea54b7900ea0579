"""Lets planners of others solve the problems of the example pddl_problems.

    pip install pyperplan up-fast-downward
    cargo run --release -p vc-tasks --example pddl_problems -- write FOLDER
    python3 vc-tasks/peers/pddl_plans.py FOLDER
    cargo run --release -p vc-tasks --example pddl_problems -- check FOLDER

Each planner that is installed solves every problem; a plan is put beside the problem
as `NAME.plan`. Where VAL's `Validate` is on the path, it judges the plans as well.
What is not installed is said and passed over. Times are wall clock, with start-up.
"""

import importlib.util
import pathlib
import shutil
import subprocess
import sys
import time

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


def solve(name, command, folder):
    plan = folder / f"{name}.plan"
    plan.unlink(missing_ok=True)
    start = time.time()
    try:
        done = subprocess.run(command(folder, plan), capture_output=True, text=True, timeout=LIMIT, cwd=folder)
    except subprocess.TimeoutExpired:
        return "time out"
    if name == "pyperplan" and (folder / "problem.pddl.soln").exists():
        (folder / "problem.pddl.soln").rename(plan)
    if not plan.exists():
        return f"no plan: {(done.stderr or done.stdout).strip().splitlines()[-1:]}"
    steps = sum(line.startswith("(") for line in plan.read_text().splitlines())
    verdict = f"{steps} steps in {time.time() - start:.2f} s"
    if shutil.which("Validate"):
        files = [str(folder / "domain.pddl"), str(folder / "problem.pddl"), str(plan)]
        valid = subprocess.run(["Validate", *files], capture_output=True, text=True, cwd=folder)
        verdict += ", VAL: " + ("valid" if "Plan valid" in valid.stdout else "NOT VALID")
    return verdict


def main(root):
    if not shutil.which("Validate"):
        print("SKIPPED: VAL, there is no `Validate` on the path")
    for name, command in PLANNERS.items():
        if not command:
            print(f"SKIPPED: {name} is not installed")
            continue
        for problem in sorted(pathlib.Path(root).resolve().glob("**/problem.pddl")):
            print(f"{name} {problem.parent.relative_to(pathlib.Path(root).resolve())}: "
                  f"{solve(name, command, problem.parent)}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
