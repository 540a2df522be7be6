# SPDX-License-Identifier: Apache-2.0
"""Runs the fuzz targets of a build (cmake --preset fuzz && cmake --build --preset fuzz), each from its corpus, and says
what they did. What crashes or hangs one, or is taken without being sane, stays in FOLDER, and is an error.

usage: run.py BUILD (--seconds S | --runs N) [--seed N] [--only X,Y] [--record FILE] [--found FOLDER]
  --seconds   of all targets together
  --runs      executions of each target
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

here = pathlib.Path(__file__).resolve().parent
data = here.parent.parent / "data"
longest = {"checkpoint": 1 << 16, "frames": 1 << 12, "hashes": 1 << 12, "scenario": 1 << 13, "waveform": 1 << 10}  # bytes
limits = ("-timeout=60", "-rss_limit_mb=2048", "-malloc_limit_mb=1000000000", "-print_final_stats=1", "-verbosity=1")
statistics = {"executions": "number_of_executed_units", "kept": "new_units_added", "slowest [s]": "slowest_unit_time_sec",
              "memory [MB]": "peak_rss_mb"}


def words_of(value):
    """The keys and the choices of a JSON Schema."""
    if isinstance(value, dict):
        own = list(value.get("properties", {})) + [w for w in value.get("enum", []) if isinstance(w, str)]
        return own + [word for member in value.values() for word in words_of(member)]
    return [word for member in value for word in words_of(member)] if isinstance(value, list) else []


def write_dictionary(file):
    """What is worth to be put into an input: keys of scenarios, numbers at the edge of something."""
    words = {f'"{word}"' for word in words_of(json.loads((data / "scenario.schema.json").read_text()))}
    words |= {"0", "-1", "1e308", "1e-400", "-0", "1e999", "nan", "inf", "null", "true", "{}", "[]", "[[", "9223372036854775807",
              "9223372036854775808", "0.8", "\\x00", "\\xff\\xfe", "\\x1b[", "\\x0d\\x0a", ",", '"base"', '"quick.json"'}
    escaped = (word.replace('"', '\\"') for word in sorted(words))
    file.write_text("".join(f'"{word}"\n' for word in escaped))


def run(target, arguments, scratch, limit, found):
    """One target. Its numbers; "failed" has what it said when it didn't come to its end."""
    name = target.name.removeprefix("fuzz_")
    kept = scratch / name
    kept.mkdir()
    command = [target, *limits, *limit, f"-seed={arguments.seed}", f"-max_len={longest[name]}", f"-dict={scratch / 'words'}",
               f"-artifact_prefix={found}/{name}-", kept, here / "corpus" / name]
    # HDF5 asks for as much memory as a file says, and takes a no; and it forgets some of a file that it refuses.
    options = "allocator_may_return_null=1:detect_leaks=0" if name == "checkpoint" else ""
    begun = time.monotonic()
    done = subprocess.run(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace",
                          cwd=scratch, env={**os.environ, "ASAN_OPTIONS": options})
    row = {"target": name, "seconds": round(time.monotonic() - begun)}
    for label, key in statistics.items():
        match = re.search(rf"stat::{key}:\s+(\d+)", done.stderr)
        row[label] = int(match[1]) if match else 0
    covered = re.findall(r"cov: (\d+)", done.stderr)
    row["branches reached"] = int(covered[-1]) if covered else 0
    if done.returncode or not row["executions"]:
        row["failed"] = done.stderr[-4000:]
    return row


def table(rows, words):
    columns = [key for key in rows[0] if key != "failed"]
    lines = ["| " + " | ".join(columns) + " | result |", "|" + " --- |" * (len(columns) + 1)]
    lines += ["| " + " | ".join(str(row[key]) for key in columns) + f" | {'FAILED' if 'failed' in row else 'no finding'} |"
              for row in rows]
    return f"{words}\n\n" + "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--seconds", type=int)
    parser.add_argument("--runs", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=lambda text: text.split(","))
    parser.add_argument("--record", type=pathlib.Path)
    parser.add_argument("--found", type=pathlib.Path, default=pathlib.Path.cwd())
    arguments = parser.parse_args()
    names = arguments.only or list(longest)
    targets = [arguments.build.resolve() / "tests/fuzz" / f"fuzz_{name}" for name in names]
    limit = ([f"-runs={arguments.runs}"] if arguments.runs else
             [f"-max_total_time={max(1, (arguments.seconds or 60) // len(targets))}"])
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        write_dictionary(pathlib.Path(scratch, "words"))
        for target in targets:
            rows.append(run(target, arguments, pathlib.Path(scratch), limit, arguments.found.resolve()))
            print({key: value for key, value in rows[-1].items() if key != "failed"}, flush=True)
            print(rows[-1].get("failed", ""), end="", flush=True)
    compiler = subprocess.run(["clang++", "--version"], capture_output=True, text=True).stdout.split("\n")[0]
    how = f"--runs {arguments.runs}" if arguments.runs else f"--seconds {arguments.seconds or 60}"
    how += f" --seed {arguments.seed}" + (f" --only {','.join(arguments.only)}" if arguments.only else "")
    report = table(rows, f"`python3 tests/fuzz/run.py build/fuzz {how}` with {compiler or 'clang'}, address and"
                         " undefined-behavior sanitizers:")
    print(report)
    if arguments.record:
        arguments.record.write_text("# Fuzzing\n\n" + report)
    sys.exit(any("failed" in row for row in rows))


if __name__ == "__main__":
    main()
