# SPDX-License-Identifier: Apache-2.0
"""Every command that a page tells its reader to type is run by a test, or stands here with the reason why it isn't.

Commands are the lines of blocks marked sh, and code in backticks that begins like one. tests/app/run_commands.py runs
all that isn't in ELSEWHERE; a command that is neither known to it nor here fails there, since it is run. This guard
finds commands that nobody can run as they stand, and reasons that no page needs any more.
"""
import re

import guard

PAGES = ("README.md", "ARTIFACT.md", "CONTRIBUTING.md")
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`([^`]+)`")
STARTS = re.compile(r"(\w+=\S* )?(time )?(\$A |aneurysm(-\w+)? |\./\w+\.sh|build/\S+ |cmake |python3 |grep -|ctest|tests/\w+\.sh "
                    r"|verification/\w+\.sh )")
# What stands for the reader's own, in capitals.
EXAMPLES = {"SCENARIO": "data/scenarios/quick.json", "FILE": "data/scenarios/quick.json", "NAME": "cpu", "ID": "eq13",
            "DIR": "results/dir"}

# Command -> which test runs it, or why none does. Words in "by X" are tests of ctest, or files of tests/.
ELSEWHERE = {
    "./run.sh": "by check_run_sh, with stand-ins for what installs and builds",
    "time ./run.sh --backend cpu --precision float": "by check_run_sh, with stand-ins for what installs and builds",
    "./test.sh": "runs this test itself",
    "./test.sh --tidy": "takes half an hour, and clang-tidy 14; CONTRIBUTING.md asks for it before a commit",
    "ANEURYSM_WERROR=ON ./test.sh": "runs this test itself, in CI",
    "tests/other_system.sh trixie": "takes an hour and root: it makes another Debian",
    "tests/other_system.sh SUITE": "takes an hour and root: it makes another Debian",
    "conda env create -f environment.yml && conda activate aneurysm && ./run.sh": "needs conda and its packages",
    "spack install aneurysm": "needs Spack, which builds all libraries: hours",
    "podman build -t aneurysm .": "needs podman, and root for its user namespaces where they aren't allowed",
    "apptainer build aneurysm.sif packaging/aneurysm.def": "needs Apptainer",
    "cmake --preset package && cmake --build --preset package": "by check_install, from the build that it is in",
    'cmake --install build/package --prefix "$HOME/aneurysm"': "by check_install, under another prefix",
    '"$HOME/aneurysm/bin/aneurysm" verify --out verify': "by check_install, as `info`, and by verify_quick",
    "paraview --script=results/paper_tc1/show_in_paraview.py": "needs ParaView; by test_paraview with its reader of files",
    "pvpython results/paper_tc1/show_in_paraview.py picture.png": "needs ParaView; by test_paraview with its reader of files",
    "build/release/bin/aneurysm view data/scenarios/quick.json": "by check_pictures, since it needs a display",
    "verification/gpu_check.sh OUT": "needs a GPU",
    "cmake --preset fuzz && cmake --build --preset fuzz": "./test.sh itself does it, where clang has libFuzzer",
    "python3 tests/fuzz/run.py build/fuzz --runs 3000": "the test fuzz of the preset fuzz is this command",
    "python3 tests/fuzz/run.py build/fuzz --runs 1000000 --record verification/records/fuzz.md": "takes an hour",
    "python3 tests/app/check_kills.py build/release/bin/aneurysm data 100 1 verification/records/kills.md":
        "takes a quarter of an hour; by check_kills, nine times",
    "build/release/bin/aneurysm verify --full --out results/full": "takes five minutes; its checks are those of the others",
    "build/release/bin/aneurysm verify --full --only eq13,L2,poiseuille --backend cpu --precision float --out results/some":
        "takes a minute; by verify_quick without --full",
    "aneurysm verify --full --only L6 --backend cpu --precision float --out results/nature": "takes minutes",
    "build/release/bin/aneurysm verify --sensitivity --faults ci --out results/sensitivity": "by verify_sensitivity",
    "time $A verify --sensitivity --faults ci --out results/sensitivity": "by verify_sensitivity",
    "build/release/bin/aneurysm verify --sensitivity --out results/sensitivity": "takes hours; by verify_sensitivity for 24 faults",
    "aneurysm verify --sensitivity --out results/sensitivity": "takes hours; by verify_sensitivity for 24 faults",
    "build/release/bin/aneurysm verify --baseline --out results/baseline": "by verify_baseline",
    "time $A verify --baseline --out results/baseline": "by verify_baseline",
    "aneurysm verify --baseline": "by verify_baseline",
    "build/release/bin/aneurysm verify --baseline --record": "by check_baseline",
    "aneurysm verify --baseline --record": "by check_baseline",
    "build/release/bin/aneurysm verify --baseline --only quick --out results/quick_baseline": "by check_baseline",
    "build/release/bin/aneurysm verify --out results/verify": "by verify_quick, with fewer checks",
    "time $A verify --out results/verify": "by verify_quick, with fewer checks",
    "aneurysm verify --backend NAME": "by verify_quick, of all backends",
    "time ./test.sh": "runs this test itself",
    "build/release/bin/aneurysm reproduce all --out results/paper": "takes half an hour; by check_reproduce and check_kills in parts",
    "time $A reproduce all --out results/paper": "takes half an hour; by check_reproduce and check_kills in parts",
    "aneurysm reproduce all --out results/paper": "takes half an hour; by check_reproduce and check_kills in parts",
    "build/release/bin/aneurysm reproduce table4 fig9 --seeds 2 --out results/paper": "takes minutes; by check_kills with short runs",
    "aneurysm reproduce table3 --out results/paper": "takes minutes, and measures the machine",
    "aneurysm reproduce table4 --out results/paper": "takes half an hour",
    "aneurysm reproduce fig4 fig5 --out results/paper": "takes half an hour",
    "aneurysm reproduce fig6 fig8 --out results/paper": "takes minutes",
    "aneurysm reproduce fig9 --out results/paper": "takes half an hour; by check_kills with short runs",
    "build/release/bin/aneurysm reproduce --calibrate --out results/calibration": "takes 17 minutes; by test_reproduce in parts",
    "aneurysm reproduce --calibrate": "takes 17 minutes; by test_reproduce in parts",
}


def commands(text):
    """The commands of a page, in their order, each once."""
    found = []

    def take(command):
        command = " ".join(command.split())
        if command and command not in found:
            found.append(command)

    for kind, block in BLOCK.findall(text):
        if kind == "sh":
            for line in re.sub(r"\\\n", " ", block).splitlines():
                take(re.sub(r"(^|\s+)#.*", "", line))
    for code in CODE.findall(BLOCK.sub("", text)):
        if STARTS.match(code):
            take(code)
    return found


def pages(root):
    return [*(root / page for page in PAGES), *sorted((root / "docs").glob("*.md"))]


def is_mention(command):
    """`aneurysm verify`, of which a page speaks: its --help is run."""
    return re.fullmatch(r"aneurysm \w+", command) is not None


def filled_in(command):
    """With examples for the words that stand for the reader's own."""
    return re.sub(r"\b[A-Z]{2,}\b(?!=)", lambda word: EXAMPLES.get(word[0], word[0]), command)


def check(root):
    findings = []
    known = set()
    for file in pages(root):
        for command in commands(file.read_text(encoding="utf-8")):
            known.add(command)
            open_words = re.findall(r"(?<![\w$-])[A-Z]{2,}\b(?!=|\()", filled_in(command).split(" --benchmark")[0])
            if command not in ELSEWHERE and [word for word in open_words if word not in ("PATH", "ON", "HOME")]:
                findings.append(f"{file.relative_to(root)}: nobody can run `{command}`: {', '.join(open_words)}")
            if command not in ELSEWHERE and not re.match(r"\$A |time \$A |build/|aneurysm|cmake |python3 |grep ", command):
                findings.append(f"{file.relative_to(root)}: no test runs `{command}`, and no reason is given")
    findings += [f"tests/guards/check_commands.py: no page has `{command}`" for command in ELSEWHERE if command not in known]
    tests = (root / "tests/CMakeLists.txt").read_text(encoding="utf-8")
    for command, why in ELSEWHERE.items():
        for name in re.findall(r"\bby (\w+)|\band (check_\w+)", why):
            if not re.search(rf"\b{''.join(name)}\b", tests):
                findings.append(f"tests/guards/check_commands.py: no test {''.join(name)}, for `{command}`")
    return findings


FAULTS = [
    ("README.md", "./test.sh ", "./tests.sh ", "no test runs `./tests.sh`"),
    ("docs/reproduction.md", "reproduce --calibrate --out", "reproduce --calibrated --out", "no page has"),
    ("docs/model.md", "`aneurysm reproduce errata --out results/paper`", "`aneurysm reproduce ITEM --out results/paper`",
     "nobody can run `aneurysm reproduce ITEM"),
    ("tests/CMakeLists.txt", "check_baseline", "check_base", "no test check_baseline"),
]

if __name__ == "__main__":
    guard.main(check, FAULTS)
