#!/usr/bin/env python3
"""seeds.py STUDY.JSON...: how far the seeds of a study's methods are apart.

Efficiency is 1/(trimmed relMSE x rays): rays, unlike seconds, are the same on every machine. Where E_4 was measured,
no seed may have more than three times that of the median: else the exit code is 1.
"""
import json
import statistics
import sys
from collections import defaultdict

MOST = 3.0

apart = False
for path in sys.argv[1:]:
    with open(path, encoding="utf-8") as file:
        runs = json.load(file)["runs"]
    methods = defaultdict(dict)
    for run in runs:
        methods[run["scene"], run["method"], run["budget"]][run["seed"]] = run
    for (scene, method, budget), seeds in methods.items():
        print(f"{scene}, {method}, {budget}: {len(seeds)} seeds; over the median,")
        if all("relmse-trimmed" in run["metrics"] for run in seeds.values()):
            values = {seed: 1.0 / (run["metrics"]["relmse-trimmed"] * run["statistics"]["rays"])
                      for seed, run in seeds.items()}
            median = statistics.median(values.values())
            worst = min(values, key=values.get)
            best = max(values, key=values.get)
            print(f"  efficiency: the worst (seed {worst}) has {values[worst] / median:.2f}, "
                  f"the best (seed {best}) {values[best] / median:.2f}")
        if all("e4" in run["metrics"] for run in seeds.values()):
            values = {seed: run["metrics"]["e4"] for seed, run in seeds.items()}
            median = statistics.median(values.values())
            worst = max(values, key=values.get)
            beyond = sum(value > MOST * median for value in values.values())
            apart = apart or beyond > 0
            print(f"  E_4: the worst (seed {worst}) has {values[worst] / median:.2f}; "
                  f"{beyond} above {MOST:g}")
sys.exit(1 if apart else 0)
