#!/usr/bin/env python3
"""Writes the tables of docs/results from the CSV files beside the pages.

    python3 bench/results.py            writes them
    python3 bench/results.py --check    says which are not as they would be written
    python3 bench/results.py pictures FILE.csv    prints one table, of any file

A table stands between `<!-- table: KIND FILE [COLUMNS] -->` and `<!-- end -->`. Kinds are the functions of TABLES.
"""
import csv
import math
import pathlib
import re
import statistics
import sys

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "docs" / "results"
TABLE = re.compile(r"(<!-- table: (.*?) -->\n).*?(<!-- end -->)", re.DOTALL)
RAW = [("trimmed", "raw error"), ("flip", "raw ꟻLIP")]
FINISHED = [("filtered_trimmed", "finished error"), ("filtered_flip", "finished ꟻLIP")]
# Above it a mean is that of a few pixels.
LARGEST = 50.0
# 97.5 % of Student's t, by degrees of freedom from 1.
STUDENT = [12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26, 2.23, 2.20, 2.18, 2.16, 2.14]


def groups_of(rows, *keys):
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[key] for key in keys), []).append(row)
    return groups


def values_of(rows, column):
    return [float(row[column]) for row in rows]


def markdown(names, lines):
    return "\n".join("| " + " | ".join(cells) + " |" for cells in [names, *lines]).replace("\n", "\n|" + "---|" * len(names) + "\n", 1)


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


def best_table(rows, columns, ours="selective"):
    """One method over the best of the others in each scene, the best ratio first."""
    names = ["scene"]
    for _, name in columns:
        names += [name, "best other", "ratio"]
    lines = []
    for (scene,), of_scene in groups_of(rows, "scene").items():
        methods = groups_of(of_scene, "method")
        own = methods.pop((ours,))
        cells, order = [scene], None
        for column, _ in columns:
            best = min(methods, key=lambda method: statistics.mean(values_of(methods[method], column)))
            here, there = values_of(own, column), values_of(methods[best], column)
            cells += [f"{statistics.mean(here):.2g}", f"{statistics.mean(there):.2g} (`{best[0]}`)", ratio_of(here, there)]
            order = order or statistics.mean(here) / statistics.mean(there)
        lines.append((order, cells))
    return markdown(names, [cells for _, cells in sorted(lines)])


def finished_table(rows):
    return best_table(rows, FINISHED)


def raw_table(rows):
    return best_table(rows, RAW)


def mean_of(rows, column):
    mean = statistics.mean(values_of(rows, column))
    return f"{mean:.2g}" if mean <= LARGEST else "†"


def pictures_table(rows):
    """Means over seeds, a line for each scene and method."""
    columns = [("relmse", "raw, plain"), RAW[0], ("e4", "E_4"), RAW[1], ("filtered_relmse", "finished, plain"), *FINISHED]
    lines = []
    for (scene, method), own in groups_of(rows, "scene", "method").items():
        samples = f"{statistics.mean(values_of(own, 'samples')):.0f}"
        lines.append([scene, f"`{method}`", str(len(own)), samples] + [mean_of(own, column) for column, _ in columns])
    return markdown(["scene", "method", "seeds", "samples per pixel"] + [name for _, name in columns], lines)


def references_table(rows):
    """The references' own error by scene."""
    lines = []
    for (scene,), own in groups_of(rows, "scene").items():
        errors = sorted({float(row["reference_relmse"]) for row in own if row["reference_relmse"]})
        ends = errors[:1] + errors[1:][-1:]
        lines.append([scene, "–".join(f"{error:.2g}" for error in ends) or "see above"])
    return markdown(["scene", "reference's own relMSE"], lines)


class Estimates:
    """Estimated over true errors of renders that have something in common.

    A ratio counts if the render said that it knows its error, and if the reference is good enough to check it."""

    NAMES = ["renders", "said so", "median", "range", "within 0.7–1.4", "within, or said so"]
    LEAST, MOST = 0.7, 1.4
    # Largest error of a reference, over the true one of the render.
    LOUD = 0.5

    def __init__(self, rows):
        self.runs, self.unchecked, self.bounds, self.ratios = len(rows), 0, 0, []
        for row in rows:
            if not row["estimated"] or row["fireflies"] == "1" or row["misses_light"] == "1":
                self.bounds += 1
            elif float(row["reference_error"]) > self.LOUD * float(row["true_error"]):
                self.unchecked += 1
            else:
                self.ratios.append(float(row["estimated"]) / float(row["true_error"]))

    def cells(self):
        inside = sum(self.LEAST <= ratio <= self.MOST for ratio in self.ratios)
        known = len(self.ratios)
        return [
            str(self.runs),
            share(self.bounds, self.runs),
            f"{statistics.median(self.ratios):.2f}" if known else "-",
            f"{min(self.ratios):.2f}–{max(self.ratios):.2f}" if known else "-",
            share(inside, known),
            share(inside + self.bounds, self.runs - self.unchecked),
        ]


def share(part, whole):
    return f"{100 * part / whole:.0f} %" if whole else "-"


def estimates_table(rows, *keys):
    groups = groups_of(rows, *keys)
    order = sorted(groups, key=lambda group: [(float(key) if key[0].isdigit() else key) for key in group])
    return markdown([key.replace("_", " ") for key in keys] + Estimates.NAMES,
                    [list(group) + Estimates(groups[group]).cells() for group in order])


def smallest_table(rows):
    """Errors of references, and the smallest that was measured against each."""
    lines = [[scene, f"{float(own[0]['reference_error']):.3f}", f"{min(values_of(own, 'true_error')):.3f}"]
             for (scene,), own in sorted(groups_of(rows, "scene").items())]
    return markdown(["scene", "reference's own error", "smallest error measured"], lines)


def rows_table(rows, *columns):
    """The file as it is, or some of its columns."""
    columns = columns or list(rows[0])
    return markdown([name.replace("_", " ") for name in columns], [[row[name] for name in columns] for row in rows])


def wide_table(rows, down, across, cell):
    """One column's values side by side."""
    heads = list(dict.fromkeys(row[across] for row in rows))
    lines = [[name] + [next((row[cell] for row in own if row[across] == head), "") for head in heads]
             for (name,), own in groups_of(rows, down).items()]
    return markdown([down, *heads], lines)


TABLES = {
    "estimates": estimates_table,
    "finished": finished_table,
    "pictures": pictures_table,
    "raw": raw_table,
    "references": references_table,
    "rows": rows_table,
    "smallest": smallest_table,
    "wide": wide_table,
}


def table(kind, file, *columns):
    with open(FOLDER / file, newline="", encoding="utf-8") as text:
        return TABLES[kind](list(csv.DictReader(text)), *columns)


def main(arguments):
    if arguments and arguments[0] in TABLES:
        print(table(arguments[0], pathlib.Path(arguments[1]).resolve(), *arguments[2:]))
        return 0
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    stale = []
    for page in sorted(FOLDER.glob("*.md")):
        text = page.read_text(encoding="utf-8")
        written = TABLE.sub(lambda found: f"{found[1]}\n{table(*found[2].split())}\n\n{found[3]}", text)
        if written != text:
            stale.append(page)
            if not arguments:
                page.write_text(written, encoding="utf-8")
    for page in stale:
        print(f"{page}: " + ("is not what its CSV files say: python3 bench/results.py" if arguments else "written"), file=sys.stderr)
    return 1 if arguments and stale else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
