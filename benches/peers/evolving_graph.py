"""Times VirtualHome's symbolic simulator, evolving_graph, on VirtualHome's scene 1.

    pip install --target peers --no-deps virtualhome==2.3.0
    pip install --target peers numpy termcolor networkx
    PYTHONPATH=peers python3 benches/peers/evolving_graph.py ../shared/data/virtualhome/scene1.json.gz

Prints medians in milliseconds of CPU time. Each row names the timed work.
"""

import gzip
import json
import statistics
import sys
import time
import types

# The package's __init__ imports its Unity client, which is not needed here.
for name in ("virtualhome", "virtualhome.simulation"):
    module = types.ModuleType(name)
    module.__path__ = [folder + "/" + name.replace(".", "/") for folder in sys.path]
    sys.modules[name] = module

from virtualhome.simulation.evolving_graph import scripts  # noqa: E402
from virtualhome.simulation.evolving_graph.environment import EnvironmentGraph, EnvironmentState  # noqa: E402
from virtualhome.simulation.evolving_graph.execution import ScriptExecutor  # noqa: E402

# The ten actions of the bench `ten actions in place`.
ACTIONS = [
    "[WALK] <fridge> ({fridge})",
    "[OPEN] <fridge> ({fridge})",
    "[WALK] <plate> ({plate})",
    "[GRAB] <plate> ({plate})",
    "[WALK] <fridge> ({fridge})",
    "[PUTIN] <plate> ({plate}) <fridge> ({fridge})",
    "[GRAB] <plate> ({plate})",
    "[CLOSE] <fridge> ({fridge})",
    "[WALK] <bed> ({bed})",
    "[PUTBACK] <plate> ({plate}) <bed> ({bed})",
]


def median(repeat, call):
    times = []
    for _ in range(repeat):
        start = time.process_time()
        call()
        times.append((time.process_time() - start) * 1e3)
    return statistics.median(times)


def main(path):
    text = gzip.open(path, "rt").read()
    graph = json.loads(text)
    ids = {c: next(n["id"] for n in graph["nodes"] if n["class_name"] == c) for c in ("fridge", "plate", "bed")}
    print(f"json.loads                 {median(20, lambda: json.loads(text)):8.2f} ms")

    def build():
        return EnvironmentState(EnvironmentGraph(graph), {}, instance_selection=True)

    print(f"build the graph object     {median(20, build):8.2f} ms")
    executor = ScriptExecutor(EnvironmentGraph(graph), {})
    lines = [scripts.parse_script_line(a.format(**ids), i) for i, a in enumerate(ACTIONS)]
    for in_place in (False, True):
        runs = []
        for _ in range(10):
            state = build()
            start = time.process_time()
            for line in lines:
                done, state = executor.execute_one_step(scripts.Script([line]), state, in_place=in_place)
                assert done, line
            runs.append((time.process_time() - start) * 1e3)
        name = "ten actions, in place" if in_place else "ten actions, copying"
        print(f"{name:26} {statistics.median(runs):8.2f} ms")


if __name__ == "__main__":
    main(sys.argv[1])
