# SPDX-License-Identifier: Apache-2.0
"""What the tests of runs that are cut short share: a short scenario, how far a run is, and that it ended at the bits of
one that nobody disturbed."""
import json

import program
from program import expect, read_json


def write_scenario(file, **changes):
    scenario = program.changed(program.quick, **changes)
    file.write_text(json.dumps({"name": "short", "output": {"particles_every_frames": 20, "checkpoint_every_frames": 25},
                                **scenario}))
    return file


def rows(directory):
    """Complete rows of frames.csv."""
    file = directory / "frames.csv"
    return max(0, file.read_text().count("\n") - 1) if file.exists() else 0


def manifest(directory):
    return read_json(directory / "manifest.json")


def same_bytes(one, other, names, label):
    for name in names:
        expect((one / name).read_bytes() == (other / name).read_bytes(), f"{label}: the same bytes expected in {name}")


def same_files(directory, whole, label, but=("manifest.json",)):
    """The same names and the same bytes, but for files that say when and by which process they were made."""
    names = sorted(path.relative_to(whole) for path in whole.rglob("*") if path.is_file())
    found = sorted(path.relative_to(directory) for path in directory.rglob("*") if path.is_file())
    expect(found == names, f"{label}: the same files expected: {set(names) ^ set(found)}")
    same_bytes(directory, whole, [name for name in names if name in found and name.name not in but], label)
