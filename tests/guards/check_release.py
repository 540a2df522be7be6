# SPDX-License-Identifier: Apache-2.0
"""All that names the release names the same: version, date, title, author, license, and the paper.

  - CMakeLists.txt, CITATION.cff, codemeta.json, .zenodo.json, the first heading of CHANGELOG.md, app/cite.cpp;
  - the baseline was recorded by a version that CHANGELOG.md has, and its files of hashes by the same;
  - ARTIFACT.md is of this version.
"""
import json
import re

import guard

def found(pattern, text):
    match = re.search(pattern, text, re.MULTILINE)
    return match[1] if match else None


def read(root, name):
    return (root / name).read_text(encoding="utf-8")


def facts(root):
    """What each file says, by fact and file."""
    cff, code = read(root, "CITATION.cff"), read(root, "app/cite.cpp")
    meta, zenodo = (json.loads(read(root, name)) for name in ("codemeta.json", ".zenodo.json"))
    heading = r"\A# Changelog\n\n## %s$"
    return {
        "version": {
            "CMakeLists.txt": found(r"^project\(aneurysm VERSION (\S+)", read(root, "CMakeLists.txt")),
            "CITATION.cff": found(r"^version: (.*)$", cff),
            "codemeta.json": meta["version"],
            ".zenodo.json": zenodo["version"],
            "CHANGELOG.md": found(heading % r"(\S+) \(.*\)", read(root, "CHANGELOG.md")),
            "ARTIFACT.md": found(r"\A# .* (\S+)$", read(root, "ARTIFACT.md")),
        },
        "date": {
            "CITATION.cff": found(r"^date-released: (\S+)$", cff),
            "codemeta.json": meta["datePublished"],
            ".zenodo.json": zenodo["publication_date"],
            "CHANGELOG.md": found(heading % r"\S+ \((.*)\)", read(root, "CHANGELOG.md")),
        },
        "year": {"CITATION.cff": found(r"^date-released: (\d+)", cff), "app/cite.cpp": found(r'year = "(.*)";', code)},
        "title": {
            "CITATION.cff": found(r'^title: "(.*)"$', cff),
            "codemeta.json": meta["name"],
            ".zenodo.json": zenodo["title"],
            "app/cite.cpp": found(r'title =\s+"(.*)";', code),
        },
        "author": {
            "CITATION.cff": found(r"^authors:\n  - name: (.*)$", cff),
            "codemeta.json": meta["author"][0]["name"],
            ".zenodo.json": zenodo["creators"][0]["name"],
            "app/cite.cpp": found(r'author = "(.*)";', code),
        },
        "license": {
            "CITATION.cff": found(r"^license: (\S+)", cff),
            "codemeta.json": meta["license"].removeprefix("https://spdx.org/licenses/"),
            ".zenodo.json": zenodo["license"],
        },
        "paper": {
            "CITATION.cff, references": found(r"(?s)^references:.*^    doi: (\S+)$", cff),
            "codemeta.json": meta["referencePublication"][0]["identifier"].removeprefix("https://doi.org/"),
            ".zenodo.json": zenodo["related_identifiers"][0]["identifier"],
            "app/cite.cpp": found(r"doi     = \{(.*)\}", code),
            "README.md": found(r"https://doi\.org/([^>\s]+)", read(root, "README.md")),
        },
    }


def check(root):
    findings = []
    for fact, said in facts(root).items():
        if None in said.values() or len(set(said.values())) > 1:
            findings.append(f"{fact}: {', '.join(f'{file} says {value}' for file, value in said.items())}")
    if "preferred-citation" in read(root, "CITATION.cff"):
        findings.append("CITATION.cff: preferred-citation hides this software behind another work")
    recorded = json.loads(read(root, "data/baseline.json"))["version"]
    if not re.search(rf"^## {re.escape(recorded)} ", read(root, "CHANGELOG.md"), re.MULTILINE):
        findings.append(f"data/baseline.json: of version {recorded}, which CHANGELOG.md doesn't have")
    for file in sorted((root / "data/hashes").glob("*.csv")):
        version = found(r"^# version (\S+)$", file.read_text(encoding="utf-8")[:400])
        if version != recorded:
            findings.append(f"data/hashes/{file.name}: of version {version}, the baseline of {recorded}")
    return findings


FAULTS = [
    ("CMakeLists.txt", "project(aneurysm VERSION ", "project(aneurysm VERSION 9.", "version: CMakeLists.txt says 9."),
    ("CITATION.cff", "\nversion: ", "\nversion: 9", "CITATION.cff says 9"),
    ("codemeta.json", '"version": "', '"version": "9', "codemeta.json says 9"),
    (".zenodo.json", '"version": "', '"version": "9', ".zenodo.json says 9"),
    ("CHANGELOG.md", "# Changelog\n\n## ", "# Changelog\n\n## 9", "CHANGELOG.md says 9"),
    ("ARTIFACT.md", "# Artifact of aneurysm ", "# Artifact of aneurysm 9", "ARTIFACT.md says 9"),
    ("CITATION.cff", "date-released: ", "date-released: 1", "date: CITATION.cff says 1"),
    ("CITATION.cff", "\nreferences:", "\npreferred-citation:", "preferred-citation hides"),
    ("app/cite.cpp", "10.3390", "10.3391", "paper: "),
    ("app/cite.cpp", 'year = "2', 'year = "1', "year: "),
    (".zenodo.json", '"title": "A', '"title": "An a', "title: "),
    ("data/baseline.json", '"version": "', '"version": "9', "of version 9"),
    ("data/hashes/quick.float.csv", "# version ", "# version 9", "quick.float.csv: of version 9"),
]

if __name__ == "__main__":
    guard.main(check, FAULTS)
