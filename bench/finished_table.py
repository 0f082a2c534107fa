#!/usr/bin/env python3
"""Tables of finished pictures, from the CSV file of ajar_finished_bench.

    python3 bench/finished_table.py finished.csv

Means over seeds; first `selective` beside the best of the others. Filters with "+mix" are what `ajar render` shows: mixed from several estimates.
"""
import csv
import math
import statistics
import sys

RAW = [("relmse", "relMSE"), ("trimmed", "trimmed"), ("p999", "p99.9"), ("e4", "E_4"),
       ("flip", "ꟻLIP")]
FILTERED = [("filtered_relmse", "relMSE"), ("filtered_trimmed", "trimmed"),
            ("filtered_flip", "ꟻLIP")]


# 97.5 % of Student's t, by degrees of freedom from 1.
STUDENT = [12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26, 2.23, 2.20, 2.18, 2.16, 2.14]


def mean_of(rows, column):
    return f"{statistics.mean(float(row[column]) for row in rows):.3g}"


def interval_of(ours, others):
    """Ratio of two means with the ends of its 95 % interval, as `ajar study` has it: its logarithm is taken as normal, with
    Welch's degrees of freedom."""
    ratio = statistics.mean(ours) / statistics.mean(others)
    parts = [statistics.variance(values) / (len(values) * statistics.mean(values) ** 2) if len(values) > 1 else 0.0
             for values in (ours, others)]
    variance = sum(parts)
    if variance == 0.0:
        return ratio, ratio, ratio
    freedom = variance ** 2 / sum(part ** 2 / (len(values) - 1) for part, values in zip(parts, (ours, others)) if part > 0.0)
    width = STUDENT[min(int(freedom), len(STUDENT)) - 1] * math.sqrt(variance)
    return ratio, ratio * math.exp(-width), ratio * math.exp(width)


def ratio_of(ours, others):
    ratio, low, high = interval_of(ours, others)
    return f"{ratio:.2f}" if low == high else f"{ratio:.2f} ({low:.2f}–{high:.2f})"


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


def print_summary(rows, filter, ours="selective"):
    """One method over the best of the others in each scene, by what people look at first."""
    columns = [("filtered_trimmed", "relMSE trimmed"), ("filtered_flip", "ꟻLIP")]
    names = ["scene", "seeds"]
    for _, name in columns:
        names += [name, "best other", "ratio"]
    print(f"Finished by {filter.removesuffix('+mix')}: `{ours}`, and the best of the others; ratios with 95 % intervals\n")
    print("| " + " | ".join(names) + " |")
    print("|" + "---|" * len(names))
    lines = []
    for scene in dict.fromkeys(row["scene"] for row in rows):
        by_method = {}
        for row in rows:
            if row["scene"] == scene and row["filter"] == filter:
                by_method.setdefault(row["method"], []).append(row)
        if ours not in by_method or len(by_method) < 2:
            continue
        own = by_method.pop(ours)
        cells = [scene, str(len(own))]
        for column, _ in columns:
            values = {method: [float(row[column]) for row in of_method] for method, of_method in by_method.items()}
            best = min(values, key=lambda method: statistics.mean(values[method]))
            ours_here = [float(row[column]) for row in own]
            mean, of_best = statistics.mean(ours_here), statistics.mean(values[best])
            cells += [f"{mean:.2g}", f"{of_best:.2g} (`{best}`)", ratio_of(ours_here, values[best])]
            if column == columns[0][0]:
                order = mean / of_best
        lines.append((order, "| " + " | ".join(cells) + " |"))
    for _, line in sorted(lines):
        print(line)


def main():
    with open(sys.argv[1], newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    filters = [name for name in dict.fromkeys(row["filter"] for row in rows)
               if name.endswith("+mix")]
    for filter in filters:
        for seconds in dict.fromkeys(row["cpu_seconds"] for row in rows):
            print(f"\n## After {seconds} seconds\n")
            print_summary([row for row in rows if row["cpu_seconds"] == seconds], filter)
    tables = {}
    for row in rows:
        tables.setdefault((row["scene"], row["cpu_seconds"]), []).append(row)
    for (scene, _), own in tables.items():
        print_table(scene, own, filters)


if __name__ == "__main__":
    main()
