#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws what `aneurysm reproduce` asks for: plot.py SPEC.json PICTURE.png

SPEC: {"columns": n, "panels": [{"title", "x_label", "y_label", "log_y", "series": [{"name", "x", "y", "style", "color"}]}]};
style: line, thin, points or dots. Needs Debian's python3-matplotlib."""

import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import LogLocator, NullLocator

PALETTE = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#404040"]
STYLES = {
    "line": {"lw": 1.5},
    "thin": {"lw": 0.5, "alpha": 0.75},
    "dots": {"ls": "", "marker": "o", "ms": 3, "alpha": 0.6},
    "points": {"ls": "", "marker": "^", "ms": 8, "mec": "black", "mew": 0.6, "zorder": 5},
}


def draw(axes, panel):
    for series in panel["series"]:
        axes.plot(series["x"], series["y"], color=PALETTE[series["color"] % len(PALETTE)],
                  label=series["name"] or None, **STYLES[series["style"]])
    axes.set(title=panel["title"], xlabel=panel["x_label"], ylabel=panel["y_label"])
    if panel["log_y"]:
        axes.set_yscale("log")
        axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.yaxis.set_major_formatter("{x:.0f}")
        axes.yaxis.set_minor_locator(NullLocator())
    elif not panel["y_label"].endswith("[m]"):  # R and h change by a part of themselves
        axes.set_ylim(0)
    marks = any(series["style"] in ("points", "dots") for series in panel["series"])
    axes.margins(x=0.02 if marks else 0)
    axes.grid(color="0.9", lw=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(fontsize=8, frameon=False)


def main():
    spec_file, picture = sys.argv[1:]
    with open(spec_file, encoding="utf-8") as file:
        spec = json.load(file)
    columns = min(spec["columns"], len(spec["panels"]))
    rows = -(-len(spec["panels"]) // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(5.2 * columns, 3.8 * rows), squeeze=False,
                                layout="constrained")
    for axes in grid.flat:
        axes.set_visible(False)
    for axes, panel in zip(grid.flat, spec["panels"]):
        axes.set_visible(True)
        draw(axes, panel)
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    main()
