#!/usr/bin/env python3
"""Tables of finished pictures, from the CSV file of ajar_finished_bench.

    python3 bench/finished_table.py finished.csv

Means over seeds. Filters with "+mix" are what `ajar render` shows: mixed from several estimates.
"""
import csv
import statistics
import sys

RAW = [("relmse", "relMSE"), ("trimmed", "trimmed"), ("p999", "p99.9"), ("e4", "E_4"),
       ("flip", "ꟻLIP")]
FILTERED = [("filtered_relmse", "relMSE"), ("filtered_trimmed", "trimmed"),
            ("filtered_flip", "ꟻLIP")]


def mean_of(rows, column):
    return f"{statistics.mean(float(row[column]) for row in rows):.3g}"


def print_table(scene, rows, filters):
    """A line for each method."""
    floor = float(rows[0]["reference_relmse"])
    print(f"\n### {scene}, {rows[0]['cpu_seconds']} s (reference's own relMSE {floor:.2g})\n")
    names = ["method", "seeds"] + [name for _, name in RAW]
    names += [f"{filter}: {name}" for filter in filters for _, name in FILTERED]
    print("| " + " | ".join(names) + " |")
    print("|" + "---|" * len(names))
    for method in dict.fromkeys(row["method"] for row in rows):
        own = [row for row in rows if row["method"] == method]
        by_filter = {name: [row for row in own if row["filter"] == name] for name in filters}
        first = by_filter[filters[0]]
        cells = [method, str(len(first))] + [mean_of(first, column) for column, _ in RAW]
        cells += [mean_of(by_filter[name], column) for name in filters for column, _ in FILTERED]
        print("| " + " | ".join(cells) + " |")


def main():
    with open(sys.argv[1], newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    filters = [name for name in dict.fromkeys(row["filter"] for row in rows)
               if name.endswith("+mix")]
    tables = {}
    for row in rows:
        tables.setdefault((row["scene"], row["cpu_seconds"]), []).append(row)
    for (scene, _), own in tables.items():
        print_table(scene, own, filters)


main()
