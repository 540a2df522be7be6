# SPDX-License-Identifier: Apache-2.0
"""README.md, ARTIFACT.md, CONTRIBUTING.md and docs/ say nothing of what isn't there.

  - a link leads to a file, and a file of the project that is named in backticks exists;
  - a bound that a check cites, as in (docs/bounds.md, B7), has its section;
  - README.md has at most 150 lines.
"""
import re

import guard

PAGES = ("README.md", "ARTIFACT.md", "CONTRIBUTING.md")
LINK = re.compile(r"\]\((?!https?:)([^)#]+)")
PATH = re.compile(r"`((?:%s|data|docs|cmake)/[\w./]*\w)/?`" % "|".join(guard.ROOMS))
EXAMPLE = re.compile(r"[A-Z]{4}|/mine\.json")  # a name that stands for others, or for the reader's
CITED = re.compile(r"docs/bounds\.md, (B\d+)")
DERIVED = re.compile(r"^### (B\d+)\.", re.MULTILINE)
LONGEST = 150  # lines of README.md


def check(root):
    findings = []
    for file in [*(root / page for page in PAGES), *sorted((root / "docs").glob("*.md"))]:
        text = file.read_text(encoding="utf-8")
        name = file.relative_to(root)
        findings += [f"{name}: no file {link}" for link in LINK.findall(text) if not (file.parent / link).exists()]
        findings += [f"{name}: no file {path}" for path in PATH.findall(text)
                     if not (root / path).exists() and not EXAMPLE.search(path)]
    derived = DERIVED.findall((root / "docs/bounds.md").read_text(encoding="utf-8"))
    for file in guard.sources(root, "verification"):
        cited = CITED.findall(re.sub(r'"\s*"', "", file.read_text(encoding="utf-8")))
        findings += [f"{file.relative_to(root)}: no bound {bound}" for bound in cited if bound not in derived]
    if (root / "README.md").read_text(encoding="utf-8").count("\n") > LONGEST:
        findings.append(f"README.md: more than {LONGEST} lines")
    return findings


FAULTS = [
    ("README.md", "docs/bounds.md)", "docs/bound.md)", "no file docs/bound.md"),
    ("docs/model.md", "`common/equations.hpp`", "`common/equation.hpp`", "no file common/equation.hpp"),
    ("docs/bounds.md", "### B5.", "### B500.", "no bound B5"),
    ("README.md", "# Aneurysm\n", "# Aneurysm\n" + 150 * "\n", "more than 150 lines"),
]

if __name__ == "__main__":
    guard.main(check, FAULTS)
