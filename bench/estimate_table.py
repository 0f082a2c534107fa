#!/usr/bin/env python3
"""Tables of estimated over true errors, from the CSV file of ajar_estimate_bench.

    python3 bench/estimate_table.py estimates.csv

A ratio counts if the render said that it knows its error, and if the reference is good enough to
check it: its own error below half of the true one.
"""
import csv
import statistics
import sys

LEAST, MOST = 0.7, 1.4
LOUD = 0.5


class Group:
    """Renders that have something in common."""

    def __init__(self):
        self.runs = 0
        self.unchecked = 0
        self.bounds = 0
        self.ratios = []

    def add(self, row):
        self.runs += 1
        if not row["estimated"] or row["fireflies"] == "1" or row["misses_light"] == "1":
            self.bounds += 1
        elif float(row["reference_error"]) > LOUD * float(row["true_error"]):
            self.unchecked += 1
        else:
            self.ratios.append(float(row["estimated"]) / float(row["true_error"]))

    def cells(self):
        inside = sum(LEAST <= ratio <= MOST for ratio in self.ratios)
        checked = self.runs - self.unchecked
        known = len(self.ratios)
        return [
            str(self.runs),
            share(self.bounds, self.runs),
            str(self.unchecked),
            f"{statistics.median(self.ratios):.2f}" if known else "-",
            f"{min(self.ratios):.2f}–{max(self.ratios):.2f}" if known else "-",
            share(inside, known),
            share(inside + self.bounds, checked),
        ]


def share(part, whole):
    return f"{100 * part / whole:.0f} %" if whole else "-"


def print_table(title, rows, keys):
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[key] for key in keys), Group()).add(row)
    names = ["runs", "said so", "not checked", "median", "range", f"within {LEAST}–{MOST}",
             "within, or said so"]
    print(f"\n### {title}\n")
    print("| " + " | ".join([key.replace("cpu_seconds", "CPU seconds") for key in keys] + names) + " |")
    print("|" + "---|" * (len(keys) + len(names)))
    for name in sorted(groups, key=lambda key: [(float(k) if k[0].isdigit() else k) for k in key]):
        print("| " + " | ".join(list(name) + groups[name].cells()) + " |")


def main(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    print_table("By integrator", rows, ["integrator"])
    print_table("By integrator and time", rows, ["integrator", "cpu_seconds"])
    print_table("By scene", rows, ["scene"])


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
