#!/usr/bin/env python3
"""Counts instructions per particle-step of reference runs under callgrind and holds them to bench/instructions.json.

usage: tools/instructions.py [--accept] [--build DIR]     DIR: build/release, with the target ordo_kernels built

Each count is the difference of two run lengths, so that the start cancels; it is exact and depends on compiler and flags
only, which the file names. Exit code 1: a count is more than 2 % off either way, or a capability that a scene lacks is
not cheaper than one that it has. 4: no valgrind, no program. --accept writes the counts instead.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent
kept = root / "bench" / "instructions.json"
tolerance = 0.02
shapes = {"1D degree 1": (1, 1, 200), "1D degree 2": (1, 2, 200), "2D degree 1": (2, 1, 24),
          "2D degree 2": (2, 2, 24), "3D degree 1": (3, 1, 8)}
capabilities = ["body_force", "damping", "traction", "strain"]  # each must cost
savings = ["fixed_volume"]  # must save


def fail(text):
    print(f"instructions.py: {text}", file=sys.stderr)
    sys.exit(4)


def collected(program, loop, shape, body, steps, simd):
    dim, degree, cells = shape
    words = [program, "run", loop, str(dim), str(degree), body, str(cells), str(steps)]
    tool = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"]
    run = subprocess.run(tool + words, capture_output=True, text=True, env={**os.environ, "ORDO_SIMD": simd})
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or not found:
        fail(f"{' '.join(map(str, words))}: {run.stderr.strip()[-300:]}")
    return int(found[1])


def count(program, loop, shape, body, simd):
    few, many = (2, 29) if body == "crossing" else (2, 6)  # a drifting particle crosses 7 faces in 27 steps
    particles = (2 * shape[2]) ** shape[0]
    both = [collected(program, loop, shape, body, steps, simd) for steps in (few, many)]
    return round((both[1] - both[0]) / (many - few) / particles, 2)


def plan(program):
    loops = subprocess.run([program, "loops"], capture_output=True, text=True).stdout.splitlines()
    wanted = {}
    for name, shape in shapes.items():
        for body in ("staying", "crossing"):
            wanted[f"{name}, {body}: solver readable"] = ("solver readable", shape, body, "baseline")
            if "solver fast" in loops:
                for simd in ("baseline", "avx2"):
                    wanted[f"{name}, {body}: solver fast, {simd}"] = ("solver fast", shape, body, simd)
        wanted[f"{name}, staying: floor, avx2"] = ("floor avx2", shape, "staying", "avx2")
        wanted[f"{name}, staying: scalar"] = ("scalar", shape, "staying", "baseline")
    for kernel in [loop for loop in loops if loop.startswith("solver")]:
        for capability in capabilities + savings:
            loop = f"{kernel} with {capability}"
            wanted[f"2D degree 1, staying: {loop}"] = (loop, shapes["2D degree 1"], "staying", "baseline")
    return wanted


def built_with(build):
    cache = (build / "CMakeCache.txt").read_text()
    value = lambda name: re.search(rf"^{name}:\w+=(.*)$", cache, re.M)[1]
    compiler = subprocess.run([value("CMAKE_CXX_COMPILER"), "--version"], capture_output=True, text=True).stdout
    return {"compiler": compiler.splitlines()[0], "flags": f"{value('CMAKE_CXX_FLAGS_RELEASE')} {value('ORDO_ROUNDING')}"}


def faults_of(now, before):
    for name, value in now.items():
        if name not in before:
            yield f"{name}: {value}, and no count is kept"
        elif abs(value - before[name]) > tolerance * before[name]:
            yield f"{name}: {value}, kept is {before[name]} ({100 * (value / before[name] - 1):+.1f} %)"
        if " with " in name:
            plain = name.split(" with ")[0]
            plain = plain if plain in now else f"{plain}, baseline"
            saves = name.endswith(tuple(savings))
            if plain in now and (now[plain] <= value if saves else now[plain] >= value):
                yield f"{name}: {value}, but {now[plain]} without"
    for name in before.keys() - now.keys():
        yield f"{name}: kept, and not counted any more"


def main(words):
    build = pathlib.Path(words[words.index("--build") + 1]) if "--build" in words else root / "build" / "release"
    programs = [path for path in (build / "bench" / "ordo_kernels", build / "ordo_kernels") if path.exists()]
    if not programs:
        fail(f"no ordo_kernels in {build}: cmake -DORDO_BENCH=ON, and build that target")
    wanted = plan(programs[0])
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = list(pool.map(lambda one: count(programs[0], *one), wanted.values()))
    now = dict(zip(wanted, counts))
    facts = built_with(build)
    if "--accept" in words:
        kept.write_text(json.dumps({**facts, "instructions per particle-step": now}, indent=2) + "\n")
        return 0
    before = json.loads(kept.read_text())
    for key, value in facts.items():
        if before[key] != value:
            print(f"note: {key} is '{value}', counts were kept with '{before[key]}'")
    faults = list(faults_of(now, before["instructions per particle-step"]))
    print("\n".join(faults) if faults else f"{len(now)} counts within {100 * tolerance:.0f} %")
    return 1 if faults else 0


sys.exit(main(sys.argv[1:]))
