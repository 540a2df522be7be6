#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws a run: the load of the wall against P_c, R and h over the frames, and a slice through the blood. Needs python3-matplotlib and
python3-h5py."""

import argparse
import csv
import json
import pathlib

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

PHASE_COLORS = {"warm-up": "0.9", "growing": "#e8f1fa", "fully developed": "#fdf0dd", "ruptured": "#fbe3e3"}


def read_columns(run):
    with open(run / "frames.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    columns = {name: [row[name] for row in rows] for name in rows[0]}
    return {name: values if name == "phase" else [float(v) for v in values] for name, values in columns.items()}


def shade_phases(axes, data):
    start = 0
    for i in range(1, len(data["phase"]) + 1):
        if i == len(data["phase"]) or data["phase"][i] != data["phase"][start]:
            axes.axvspan(start, i, color=PHASE_COLORS[data["phase"][start].replace("_", " ")], zorder=0)
            start = i


def draw_force(axes, data):
    shade_phases(axes, data)
    axes.plot(data["frame"], data["wall_load_n"], lw=0.6, label="load [N]")
    if max(data["critical_pressure_pa"]) > 0:
        axes.plot(data["frame"], data["critical_pressure_pa"], lw=1.2, label="$P_c$ [Pa]")
    settled = data["wall_load_n"][100:] or data["wall_load_n"]
    axes.set(ylabel="impact", ylim=(0, 1.15 * max(settled + data["critical_pressure_pa"])))
    axes.legend(loc="upper right", fontsize=8)


def draw_wall(axes, data):
    shade_phases(axes, data)
    axes.plot(data["frame"], data["radius_m"], color="tab:green", label="$R$ [m]")
    axes.set(xlabel="frame", ylabel="R [m]")
    thickness = axes.twinx()
    thickness.plot(data["frame"], [1000 * h for h in data["thickness_m"]], color="tab:purple", label="$h$ [mm]")
    thickness.set_ylabel("h [mm]")
    axes.legend(loc="lower left", fontsize=8)
    thickness.legend(loc="lower right", fontsize=8)


def particle_file(run, frame):
    series = json.loads((run / "particles.hdf.series").read_text())["files"]
    if frame is None:
        return run / series[-1]["name"]
    names = [run / entry["name"] for entry in series if f"{frame:06d}" in entry["name"]]
    if not names:
        raise SystemExit(f"{run}: no particles were written for frame {frame}")
    return names[0]


def draw_slice(figure, axes, file):
    with h5py.File(file) as h5:
        points = h5["VTKHDF/Points"][:]
        velocity = h5["VTKHDF/PointData/velocity"][:]
        kind = h5["VTKHDF/PointData/kind"][:]
    extent = points[:, 0].max() - points[:, 0].min()
    near = (abs(points[:, 2]) < 0.03 * extent) & (kind > 0)
    speed = (velocity[near] ** 2).sum(axis=1) ** 0.5
    picture = axes.scatter(points[near, 0], points[near, 1], c=speed, s=9, cmap="viridis", linewidths=0)
    axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title=f"speed at z = 0, {file.stem}")
    figure.colorbar(picture, ax=axes, label="m/s", shrink=0.7)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, epilog="Example: python3 output/plot_run.py results/paper_tc1 2800 --out run.png"
    )
    parser.add_argument("run", type=pathlib.Path, help="run directory, as of `aneurysm run --out`")
    parser.add_argument("frame", type=int, nargs="?", help="of the slice; one with particles (default: the last)")
    parser.add_argument("--out", type=pathlib.Path, help="picture to write (default: run.png in the run directory)")
    arguments = parser.parse_args()
    data = read_columns(arguments.run)
    figure = plt.figure(figsize=(11, 5.5), layout="constrained")
    grid = figure.add_gridspec(2, 2, width_ratios=[1.5, 1])
    draw_force(figure.add_subplot(grid[0, 0]), data)
    draw_wall(figure.add_subplot(grid[1, 0]), data)
    draw_slice(figure, figure.add_subplot(grid[:, 1]), particle_file(arguments.run, arguments.frame))
    out = arguments.out or arguments.run / "run.png"
    figure.savefig(out, dpi=110)
    print(out)


if __name__ == "__main__":
    main()
