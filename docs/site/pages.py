#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pages for the documentation site: those of the project, with links as Doxygen resolves them, a page of all values of a
scenario from its schema, and the table of equations.

usage: pages.py SOURCES EQUATIONS OUT    EQUATIONS: what `aneurysm info` prints
"""
import json
import pathlib
import re
import sys

PAGES = ("README.md", "ARTIFACT.md", "CHANGELOG.md", "CODE_OF_CONDUCT.md", "CONTRIBUTING.md", "docs/*.md")
LINK = re.compile(r"(!?)\[([^\]]*)\]\((?!https?:)([^)#]*)(?:#([^)]*))?\)")
HEADING = re.compile(r"^(#+) (.*)$", re.MULTILINE)
FENCE = re.compile(r"(^```.*?^```$)", re.MULTILINE | re.DOTALL)
EQUATION = re.compile(r"^  (\S+) +(\d\S*) +(.{15})(.{14})(.*?)  \[(.*)\]$")


def identifier(page, anchor=""):
    """Of a page, or of a heading in it, by the anchor that other renderers give it."""
    return "page_" + re.sub(r"\W", "_", pathlib.Path(page).stem + ("_" + anchor if anchor else "")).lower()


def anchor_of(title):
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def with_identifiers(text, page, pages):
    """A page whose headings have identifiers, and whose links name them; a link to what is no page of the site becomes its
    text. Code in fences stays."""
    first = True

    def heading(match):
        nonlocal first
        anchor, first = "" if first else anchor_of(match[2]), False
        return f"{match[1]} {match[2]} {{#{identifier(page, anchor)}}}"

    def link(match):
        name = pathlib.Path(match[3] or page).name
        if match[1]:
            return f"![{match[2]}]({name})"
        return f"[{match[2]}](@ref {identifier(name, match[4] or '')})" if name in pages else match[2]

    parts = FENCE.split(text)
    return "".join(p if FENCE.match(p) else LINK.sub(link, HEADING.sub(heading, p)) for p in parts)


def cell(text):
    return str(text).replace("|", "\\|").replace("<", "&lt;")


def row(*cells):
    return "| " + " | ".join(map(cell, cells)) + " |\n"


def allowed(field):
    if "enum" in field:
        return ", ".join(map(str, field["enum"]))
    if field["type"] == "array":
        count = f"{field['minItems']} numbers, each " if "minItems" in field else "numbers, each "
        return count + allowed(field["items"])
    ends = {"minimum": "from {}", "exclusiveMinimum": "above {}", "maximum": "to {}", "exclusiveMaximum": "below {}"}
    limits = " ".join(words.format(f"{field[key]:.15g}") for key, words in ends.items() if key in field)
    return f"{field['type']} {limits}".strip()


def parameters(schema, base):
    """All values of a scenario, group by group."""
    text = f"# Values of a scenario {{#{identifier('parameters')}}}\n\n"
    text += ("Made from the schema that `aneurysm info --schema` prints. The last column is the value in\n"
             "`data/scenarios/base.json`. [How to write a scenario](@ref page_readme_your_own_scenario).\n\n")
    for name, group in schema["properties"].items():
        if "properties" not in group:
            continue
        text += f"## {name} {{#{identifier('parameters', name)}}}\n\n| key | is | allowed | base |\n| --- | --- | --- | --- |\n"
        for key, field in group["properties"].items():
            value = base.get(name, {}).get(key, "")
            text += row(f"`{name}.{key}`", field["description"], allowed(field), json.dumps(value) if value != "" else "")
        text += "\n"
    return text


def equations(lines):
    text = f"# The paper's equations {{#{identifier('equations')}}}\n\n"
    text += ("As `aneurysm info` prints it: how each equation is read, whether runs use it, and the function that computes it, in\n"
             "`reference/` and in `cuda/`.\n\n| equation | section | status | in runs | is | function | where the paper differs |\n"
             "| --- | --- | --- | --- | --- | --- | --- |\n")
    found = 0
    for line, following in zip(lines, [*lines[1:], ""]):
        if match := EQUATION.match(line):
            deviation = following.strip() if following.startswith(" " * 41) else ""
            text += row(f"({match[1]})" if match[1].isdigit() else match[1], match[2], match[3].strip(), match[4].strip(),
                        match[5], f"`{match[6]}`", deviation)
            found += 1
    if found == 0:
        raise SystemExit("no equation in what aneurysm info printed")
    return text


def main():
    if len(sys.argv) != 4:
        raise SystemExit(__doc__)
    sources, listing, out = map(pathlib.Path, sys.argv[1:])
    out.mkdir(parents=True, exist_ok=True)
    files = sorted(file for pattern in PAGES for file in sources.glob(pattern))
    for file in files:
        text = with_identifiers(file.read_text(encoding="utf-8"), file.name, {f.name for f in files})
        (out / file.name).write_text(text, encoding="utf-8")
    schema, base = (json.loads((sources / "data" / name).read_text()) for name in ("scenario.schema.json", "scenarios/base.json"))
    (out / "parameters.md").write_text(parameters(schema, base), encoding="utf-8")
    (out / "equations.md").write_text(equations(listing.read_text(encoding="utf-8").splitlines()), encoding="utf-8")


main()
