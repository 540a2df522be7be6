# SPDX-License-Identifier: Apache-2.0
"""The arrows between the rooms, and one namespace for each folder.

    common <- {reference, cuda, analytic, output} <- verification <- app, and tests and benchmarks

reference, cuda, analytic and output never include one another, so that an error has to be made three times to stay
hidden. The checks of the suite see a backend through its interface and bounds through comparisons only. GSL is for
what compares: analytic and verification.
"""
import re

import guard

MIDDLE = ("reference", "cuda", "analytic", "output")
# The longest folder that a file is in says what it may include.
MAY_INCLUDE = {
    "common": ("common",),
    **{room: ("common", room) for room in MIDDLE},
    "verification": ("common", *MIDDLE, "verification"),
    "verification/bounds": ("common", "reference", "analytic", "verification/bounds"),
    "verification/checks": (
        "common",
        "analytic",
        "verification/backends",
        "verification/checks",
        "verification/comparison",
        "verification/suite",
    ),
    "app": ("common", *MIDDLE, "verification", "app"),
    "benchmarks": ("common", *MIDDLE, "verification", "benchmarks"),
    "tests": ("common", *MIDDLE, "verification", "app", "tests"),
}
WITHOUT_GSL = {"common", "reference", "cuda", "output", "app"}
# What is in a folder stands in its namespace, or in one inside it.
NAMESPACES = {
    "common": "aneurysm",
    "reference": "aneurysm::reference",
    "cuda": "aneurysm::device",
    "analytic": "aneurysm::analytic",
    "output": "aneurysm::output",
    "output/report": "aneurysm::report",
    "output/pictures": "aneurysm::pictures",
    **{
        f"verification/{room}": f"aneurysm::{room}"
        for room in ("backends", "bounds", "checks", "comparison", "reproduction", "sensitivity", "suite")
    },
    "app": "aneurysm::app",
    "benchmarks": "aneurysm::benchmarks",
    "tests": "aneurysm::test",
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
NAMESPACE = re.compile(r"^namespace (aneurysm[\w:]*)", re.MULTILINE)


def is_in(name, folder):
    return name.startswith(folder + "/")


def of_folder(name, table):
    """The entry of the longest folder that the file is in."""
    return table[max((folder for folder in table if is_in(name, folder)), key=len)]


def is_inside(namespace, outer):
    """Whether a namespace is `outer` or in it, and no other folder's."""
    others = set(NAMESPACES.values()) - {outer}
    return namespace == outer or (namespace.startswith(outer + "::") and namespace not in others)


def check(root):
    findings = []
    for room in sorted({folder.split("/")[0] for folder in MAY_INCLUDE}):
        for file in guard.sources(root, room):
            name = file.relative_to(root).as_posix()
            text = file.read_text(encoding="utf-8")
            for quote, target in INCLUDE.findall(text):
                head = target.split("/")[0]
                if quote == '"' and head not in guard.ROOMS:
                    findings.append(f"{name}: include {target!r} must start with a room of the repository root")
                elif head in guard.ROOMS and not any(is_in(target, to) for to in of_folder(name, MAY_INCLUDE)):
                    findings.append(f"{name}: must not include {target!r}")
                elif head == "gsl" and room in WITHOUT_GSL:
                    findings.append(f"{name}: {room} must not use GSL ({target!r})")
            if file.suffix in {".hpp", ".cpp"} and not is_in(name, "tests/emulated_gpu"):
                namespace = of_folder(name, NAMESPACES)
                for opened in NAMESPACE.findall(text):
                    if not is_inside(opened, namespace):
                        findings.append(f"{name}: opens namespace {opened}, its folder's is {namespace}")
    return findings


FIRST = "#pragma once"
FAULTS = [
    ("common/vec3.hpp", FIRST, '#include "reference/growth.hpp"', "vec3.hpp: must not include"),
    ("reference/growth.hpp", FIRST, '#include "analytic/growth.hpp"', "reference/growth.hpp: must not include"),
    ("reference/growth.hpp", FIRST, "#include <analytic/growth.hpp>", "reference/growth.hpp: must not include"),
    ("reference/growth.hpp", FIRST, "# include <gsl/gsl_math.h>", "reference must not use GSL"),
    ("reference/growth.hpp", FIRST, '#include "output/file.hpp"', "reference/growth.hpp: must not include"),
    ("reference/growth.hpp", FIRST, '#include "cuda/growth.hpp"', "reference/growth.hpp: must not include"),
    ("cuda/growth.hpp", FIRST, '#include "reference/growth.hpp"', "cuda/growth.hpp: must not include"),
    ("analytic/growth.hpp", FIRST, '#include "reference/growth.hpp"', "analytic/growth.hpp: must not include"),
    ("analytic/growth.hpp", FIRST, '#include "tests/support.hpp"', "analytic/growth.hpp: must not include"),
    ("analytic/growth.hpp", FIRST, '#include "../reference/growth.hpp"', "must start with a room"),
    ("output/report", FIRST, '#include "verification/suite/check.hpp"', "must not include 'verification/suite"),
    ("app/run.hpp", FIRST, "#include <gsl/gsl_math.h>", "app must not use GSL"),
    ("verification/suite", FIRST, '#include "app/run.hpp"', "must not include 'app/run.hpp'"),
    ("verification/bounds", FIRST, '#include "cuda/growth.hpp"', "must not include 'cuda/growth.hpp'"),
    ("verification/checks/box.hpp", FIRST, '#include "reference/growth.hpp"', "box.hpp: must not include"),
    ("verification/checks/box.hpp", FIRST, '#include "cuda/growth.hpp"', "box.hpp: must not include"),
    ("verification/checks/box.hpp", FIRST, '#include "verification/bounds/inexact.hpp"', "box.hpp: must not include"),
    ("cuda/growth.hpp", "namespace aneurysm::device", "namespace aneurysm::reference", "opens namespace"),
    ("common/vec3.hpp", "namespace aneurysm\n", "namespace aneurysm::output\n", "opens namespace"),
    ("output/report", "namespace aneurysm::report", "namespace aneurysm::output", "opens namespace"),
    ("verification/checks", "namespace aneurysm::checks", "namespace aneurysm::suite", "opens namespace"),
]

if __name__ == "__main__":
    guard.main(check, FAULTS)
