#!/usr/bin/env python3
"""seeds.py STUDY.JSON...: how far the seeds of a study's methods are apart.

Efficiency is 1/(trimmed relMSE x rays): rays, unlike seconds, are the same on every machine.
"""
import json
import statistics
import sys
from collections import defaultdict

for path in sys.argv[1:]:
    with open(path, encoding="utf-8") as file:
        runs = json.load(file)["runs"]
    methods = defaultdict(dict)
    for run in runs:
        key = run["scene"], run["method"], run["budget"]
        cost = run["statistics"]["rays"]
        methods[key][run["seed"]] = 1.0 / (run["metrics"]["relmse-trimmed"] * cost)
    for (scene, method, budget), seeds in methods.items():
        median = statistics.median(seeds.values())
        worst = min(seeds, key=seeds.get)
        best = max(seeds, key=seeds.get)
        print(f"{scene}, {method}, {budget}: {len(seeds)} seeds; over the median, "
              f"the worst (seed {worst}) has {seeds[worst] / median:.2f}, "
              f"the best (seed {best}) {seeds[best] / median:.2f}")
