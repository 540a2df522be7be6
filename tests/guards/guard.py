# SPDX-License-Identifier: Apache-2.0
"""What the guards share: how a check is run, and how it is shown that it can fail.

    check_x.py ROOT             fails when the check finds anything
    check_x.py ROOT --planted   plants each fault in a copy of ROOT and fails when the check stays silent
"""
import shutil
import sys
import tempfile
from pathlib import Path

ROOMS = ("common", "reference", "cuda", "analytic", "output", "verification", "app", "benchmarks", "tests")
ROOT_FILES = ("CITATION.cff", "CMakeLists.txt", ".zenodo.json", "codemeta.json")
SOURCES = {".hpp", ".cpp", ".h", ".cuh", ".cu"}


def sources(root, room):
    """The C++ and CUDA files of a room, in a fixed order."""
    return sorted(p for p in (root / room).rglob("*") if p.suffix in SOURCES)


def planted(root, check, faults):
    """Findings about `check` itself: faults (file or room, old text, new text, expected in the finding) it misses."""
    missed = []
    for place, old, new, expected in faults:
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder)
            for room in (*ROOMS, "data", "docs", "cmake"):
                if (root / room).is_dir():
                    shutil.copytree(root / room, copy / room)
            for file in (*root.glob("*.md"), *(root / name for name in ROOT_FILES)):
                shutil.copy(file, copy)
            texts = {p: p.read_text(encoding="utf-8") for p in (sources(copy, place) or [copy / place])}
            if not any(old in text for text in texts.values()):
                missed.append(f"{place}: nothing to plant a fault in: {old!r}")
                continue
            for file, text in texts.items():
                file.write_text(text.replace(old, new), encoding="utf-8")
            if not any(expected in finding for finding in check(copy)):
                missed.append(f"{place}: {old!r} -> {new!r} was not found")
    return missed


def main(check, faults):
    if len(sys.argv) < 2 or sys.argv[2:] not in ([], ["--planted"]):
        sys.exit(__doc__)
    root = Path(sys.argv[1])
    findings = planted(root, check, faults) if sys.argv[2:] else check(root)
    for finding in findings:
        print(finding)
    sys.exit(1 if findings else 0)
