# SPDX-License-Identifier: Apache-2.0
"""A copy of reference/ and cuda/ with a hook for mutants at each place of mutants.txt.

    plant.py ROOT OUT   writes OUT/reference, OUT/cuda and OUT/verification/sensitivity/places.inc

A row of the table is a place: `name part backends: what it is`. A name starts with its equation, or with fig1
(collisions) or sec34 (the particle controller); for the parts see hook.hpp; the backends are `both`, or `cuda` alone.
Under it is a line for each site: the file, and a piece of its text with the part that is hooked between backticks:

    eq22_radius factor both: R
        reference,cuda/growth.hpp: return h - h / `R` * sigma * dR;

A site `clean => hooked` replaces text, where a hook around a part of it isn't enough. Blanks, line ends and comments don't
count. The clean text must be in the file exactly once, so that no formula changes without its mutants.
"""
import re
import sys
from pathlib import Path
from typing import NamedTuple

TABLE = "verification/sensitivity/mutants.txt"
ROOMS = ("reference", "cuda")
INCLUDE = '#include "verification/sensitivity/hook.hpp"\n'
ROW = re.compile(r"(\w+) (\w+) (both|cuda): (.+)")
SITE = re.compile(r" +([\w,]+)(/[\w./]+): (.+)")


class Row(NamedTuple):
    name: str
    part: str
    backends: str
    what: str
    sites: list  # of file and text


class Edit(NamedTuple):
    begin: int
    end: int
    before: str  # inserted; or, without `after`, what replaces the text
    after: str


class Unfit(Exception):
    """A row that doesn't fit the sources."""


def table(root):
    rows = []
    for line in (root / TABLE).read_text(encoding="utf-8").splitlines():
        site, row = SITE.fullmatch(line), ROW.fullmatch(line)
        if site and rows:
            rows[-1].sites.extend((room + site[2], site[3]) for room in site[1].split(","))
        elif row:
            rows.append(Row(*row.groups(), []))
        elif line and not line.startswith("#"):
            raise Unfit(f"{TABLE}: neither a row nor a site: {line}")
    return rows


def squeezed(text):
    """The text without blanks and comments, and where each of its characters was."""
    found = [(m.start(), m[1]) for m in re.finditer(r"//[^\n]*|(\S)", text) if m[1]]
    return "".join(c for _, c in found), [at for at, _ in found]


def call(file, name):
    """What a hook is before its argument."""
    side = "in_reference" if file.startswith("reference/") else "in_device"
    return f"sensitivity::{side}(sensitivity::{name}, "


def edits(file, source, name, site):
    clean, _, replacement = site.partition(" => ")
    parts = [squeezed(part)[0] for part in clean.split("`")]
    clean_text, hook = "".join(parts), call(file, name)
    text, at = squeezed(source)
    count = text.count(clean_text)
    marked = (replacement or clean).count("`")
    if count != 1 or marked == 0 or marked % 2 != 0 or (replacement and len(parts) > 1):
        raise Unfit(f"{name}: {file} has this text {count} times, needed: once, with parts between backticks: {site}")
    begin = text.index(clean_text)
    if replacement:
        return [Edit(at[begin], at[begin + len(clean_text) - 1] + 1, re.sub(r"`(.*?)`", rf"{hook}\1)", replacement), "")]
    found = []
    for k, part in enumerate(parts):
        if k % 2 == 1:
            found.append(Edit(at[begin], at[begin + len(part) - 1] + 1, hook, ")"))
        begin += len(part)
    return found


def applied(file, source, changes):
    """The source with all changes; one may lie within another, unless that replaces text."""
    changes = sorted(changes, key=lambda e: (e.begin, -e.end))
    for outer, inner in ((a, b) for k, a in enumerate(changes) for b in changes[k + 1:] if b.begin < a.end):
        if inner.end > outer.end or not outer.after or (inner.begin, inner.end) == (outer.begin, outer.end):
            raise Unfit(f"{file}: two hooks overlap: {source[outer.begin:outer.end]} and {source[inner.begin:inner.end]}")
    inserted = [(e.end, 0, -e.begin, e.after) for e in changes if e.after]  # at one position the inner one ends first,
    inserted += [(e.begin, 1, -e.end, e.before) for e in changes]  # and the outer one begins first
    replaced = {e.begin: e.end for e in changes if not e.after}
    text, done = "", 0
    for position, _, _, piece in sorted(inserted):
        text += source[done:position] + piece
        done = replaced.get(position, position)
    text += source[done:]
    first = text.index("#pragma once\n") + len("#pragma once\n") if "#pragma once\n" in text else text.index("#include")
    return text[:first] + INCLUDE + text[first:]


def planted(root):
    """The texts of the copy, by file, and the rows."""
    texts = {p.relative_to(root).as_posix(): p.read_text(encoding="utf-8")
             for room in ROOMS for p in sorted((root / room).rglob("*.?pp"))}
    rows = table(root)
    changes = {}
    for row in rows:
        rooms = {file.split("/")[0] for file, _ in row.sites}
        if rooms != ({"cuda"} if row.backends == "cuda" else set(ROOMS)):
            raise Unfit(f"{row.name}: for {row.backends}, hooked in {', '.join(sorted(rooms)) or 'none'}")
        for file, site in row.sites:
            if file not in texts:
                raise Unfit(f"{row.name}: there is no {file}")
            changes.setdefault(file, []).extend(edits(file, texts[file], row.name, site))
    return {file: applied(file, text, changes[file]) if file in changes else text for file, text in texts.items()}, rows


def write(file, text):
    """Leaves a file that says so already as it is, so that nothing is compiled again for it."""
    if not file.exists() or file.read_text(encoding="utf-8") != text:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


def main(root, out):
    texts, rows = planted(root)
    for room in ROOMS:
        for file in [p for p in (out / room).rglob("*.?pp") if p.relative_to(out).as_posix() not in texts]:
            file.unlink()
    for file, text in texts.items():
        write(out / file, text)
    write(out / "verification/sensitivity/places.inc",
          "".join(f'ANEURYSM_PLACE({r.name}, {r.part}, {r.backends}, "{r.what}")\n' for r in rows))


if __name__ == "__main__":
    try:
        main(Path(sys.argv[1]), Path(sys.argv[2]))
    except Unfit as error:
        sys.exit(f"{TABLE}: {error}")
