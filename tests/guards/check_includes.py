# SPDX-License-Identifier: Apache-2.0
"""The arrows between the rooms, one namespace for each folder, and where a header's functions are defined.

    common <- {reference, cuda, analytic, output} <- verification <- app, and tests and benchmarks

reference, cuda, analytic and output never include one another, so that an error has to be made three times to stay
hidden. The checks of the suite see a backend through its interface and bounds through comparisons only. GSL is for
what compares: analytic and verification. What an X.cpp or X_part.cpp defines for others is declared in X.hpp, or in the
header that is the table of contents of its folder.
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
# Headers that list what the files of a folder define.
CONTENTS = {
    "common/scenario": "scenario.hpp",
    "verification/checks": "checks.hpp",
    "verification/reproduction": "items.hpp",
    "verification/sensitivity": "sensitivity.hpp",
}
UNNAMED = re.compile(r"^namespace\n\{\n.*?^\} // namespace\n", re.MULTILINE | re.DOTALL)
# At the beginning of a line: the type, then the name of the function, or of the class that it is a member of.
DEFINED = re.compile(r"^(?!namespace|struct|class|enum|static|#|/|\}|\s)[^\n;={}]*?\b(\w+)(?:::~?\w+)?\(", re.MULTILINE)
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


def headers_of(root, file):
    """The text of the headers that may declare what a .cpp defines."""
    words = file.stem.split("_")
    own = [file.with_name("_".join(words[:count]) + ".hpp") for count in range(1, len(words) + 1)]
    folder = file.relative_to(root).as_posix()
    own += [root / name / header for name, header in CONTENTS.items() if is_in(folder, name)]
    return "\n".join(header.read_text(encoding="utf-8") for header in own if header.exists())


def undeclared(root, file, text):
    """The functions that a .cpp defines, for others, without its header."""
    declared = set(re.findall(r"\w+", headers_of(root, file)))
    return sorted(set(DEFINED.findall(UNNAMED.sub("", text))) - declared - {"main"})


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
            if file.suffix == ".cpp" and room != "tests":
                for function in undeclared(root, file, text):
                    findings.append(f"{name}: defines {function}, which no header of its name declares")
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
    ("common/vessel/sampling.hpp", "Lattice sample_count(", "Lattice other(", "sampling.cpp: defines sample_count"),
    ("verification/suite/report.hpp", "suite_junit(", "other(", "report_junit.cpp: defines suite_junit"),
    ("verification/checks/checks.hpp", "rupture_checks()", "other_checks()", "rupture.cpp: defines rupture_checks"),
]

if __name__ == "__main__":
    guard.main(check, FAULTS)
