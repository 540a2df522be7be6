# SPDX-License-Identifier: Apache-2.0
"""The arithmetic contract in the code that nvcc makes, checked without a GPU.

    check_ptx.py NVCC SOURCE FLAG...            fails on fused or inexact floating operations, on floating atomics, and
                                                on registers spilled in the kernels of the pressure's iteration
    check_ptx.py NVCC SOURCE FLAG... --report   prints registers, stack and spills of every kernel as well
    check_ptx.py NVCC SOURCE FLAG... --planted  compiles small kernels with one fault each; fails when one isn't found
"""
import re
import subprocess
import sys
import tempfile
from collections import namedtuple
from pathlib import Path

ARCHITECTURES = ("80", "90")
HOT = re.compile(r"run_group<\S*\b(AccelerateByPressure|Rates)<")

INSTRUCTION = re.compile(r"^\s*(?:@!?%\w+\s+)?([a-z]\w*(?:\.[\w:]+)*)\s", re.MULTILINE)
FLOAT = re.compile(r"\.(b?f16x?2?|tf32|f32x?2?|f64)\b")
ROUNDED = {"add", "sub", "mul", "div", "sqrt", "rcp"}
FUSED = {"fma", "mad", "wgmma", "mma"}
ATOMIC = {"atom", "red", "multimem"}

Usage = namedtuple("Usage", "kernel architecture registers stack spill_stores spill_loads")


def fault_of(instruction):
    """What is wrong with a PTX instruction such as add.rn.f32, or None."""
    parts = instruction.split(".")
    if not FLOAT.search(instruction):
        return None
    if parts[0] in FUSED:
        return "fused"
    if parts[0] in ATOMIC:
        return "atomic: its order is not fixed"
    for inexact in ("approx", "ftz", "full", "sat"):
        if inexact in parts:
            return f"not IEEE ({inexact})"
    if parts[0] in ROUNDED and "rn" not in parts:
        return "rounding not fixed, the assembler may fuse it"
    return None


def ptx_findings(ptx):
    faults = {}
    for instruction in INSTRUCTION.findall(ptx):
        if fault := fault_of(instruction):
            faults[instruction, fault] = faults.get((instruction, fault), 0) + 1
    return [f"{instruction}: {fault}, {count} times" for (instruction, fault), count in sorted(faults.items())]


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def make_ptx(nvcc, source, flags, architecture, to):
    run(nvcc, *flags, f"-arch=compute_{architecture}", "-ptx", str(source), "-o", str(to))
    return to.read_text(encoding="utf-8")


def usages(nvcc, ptx, architecture):
    """What ptxas says of each kernel of a PTX file."""
    said = run(nvcc, f"-arch=sm_{architecture}", "-cubin", "-Xptxas", "-v", str(ptx), "-o", str(ptx) + ".cubin")
    found = []
    for part in re.split(r"Compiling entry function ", said)[1:]:
        name = re.match(r"'(\S+?)'", part)[1]
        numbers = re.search(r"(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads", part)
        registers = re.search(r"Used (\d+) registers", part)[1]
        found.append(Usage(name, architecture, int(registers), *map(int, numbers.groups())))
    names = run("c++filt", *(usage.kernel for usage in found)).splitlines()
    return [usage._replace(kernel=name) for usage, name in zip(found, names)]


def short(kernel):
    kernel = re.sub(r"aneurysm::device::|\(.*", "", kernel.removeprefix("void "))
    return re.sub(r"cub::\w+::detail::(\w+::)*(\w+).*", r"cub::\2", kernel)


def show(usages_of_all):
    print(f"{'kernel':62} {'sm':>3} {'registers':>9} {'stack':>6} {'spilled':>8}")
    for u in sorted(usages_of_all, key=lambda u: (short(u.kernel), u.architecture)):
        print(f"{short(u.kernel):62} {u.architecture:>3} {u.registers:9} {u.stack:6} {u.spill_stores + u.spill_loads:8}")


def check(nvcc, source, flags, report):
    findings = []
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for architecture in ARCHITECTURES:
            file = Path(folder) / f"{architecture}.ptx"
            ptx = make_ptx(nvcc, source, flags, architecture, file)
            findings += [f"{source}, compute_{architecture}: {f}" for f in ptx_findings(ptx)]
            found += usages(nvcc, file, architecture)
    hot = [u for u in found if HOT.search(u.kernel)]
    if not hot:
        findings.append(f"{source}: no kernel matches {HOT.pattern}; this check looks for it by name")
    for u in hot:
        if u.spill_stores + u.spill_loads > 0:
            findings.append(f"{short(u.kernel)}, sm_{u.architecture}: {u.spill_stores} bytes of registers spilled")
    if report:
        show(found)
    return findings


# (what, kernel, flags that replace those of the build, expected in a finding)
KERNEL = 'extern "C" __global__ void k(float* a, double* d, int* n) {{ {} }}'
FAULTS = [
    ("a fused multiply-add", "a[0] = a[1] * a[2] + a[3];", ["--fmad=true"], "fused"),
    ("an unsplit sum of products", "d[0] = d[1] * d[2] + d[3];", ["--fmad=true"], "fused"),
    ("an explicit fma", "a[0] = __fmaf_rn(a[1], a[2], a[3]);", [], "fused"),
    ("an atomic sum of floats", "atomicAdd(a, a[1]);", [], "atomic"),
    ("an atomic sum of doubles", "atomicAdd(d, d[1]);", [], "atomic"),
    ("a fast division", "a[0] = a[1] / a[2];", ["-prec-div=false"], "not IEEE"),
    ("a fast root", "a[0] = sqrtf(a[1]);", ["-prec-sqrt=false"], "not IEEE"),
    ("numbers flushed to zero", "a[0] = a[1] + a[2];", ["-ftz=true"], "not IEEE (ftz)"),
    ("a sine", "a[0] = __sinf(a[1]);", [], "not IEEE (approx)"),
]
SOUND = "a[0] = a[1] / a[2] + sqrtf(a[3]) * a[4]; d[0] = d[1] / d[2] - sqrt(d[3]); atomicAdd(n, 1);"
# 80 doubles at once don't fit into the 64 registers that a thread of 1,024 has.
SPILLING = """
template <class Real> struct AccelerateByPressure {};
template <class F> __global__ void __launch_bounds__(1024) run_group(F, double* d, int n)
{
    double v[80];
    for (int k = 0; k < 80; ++k) v[k] = d[k * n + threadIdx.x];
    __syncthreads();
    for (int k = 0; k < 80; ++k) d[k * n + threadIdx.x] = v[k] / v[79 - k];
}
template __global__ void run_group(AccelerateByPressure<double>, double*, int);
"""


def planted(nvcc, flags):
    missed = []
    with tempfile.TemporaryDirectory() as folder:
        source, ptx = Path(folder) / "k.cu", Path(folder) / "k.ptx"
        source.write_text(SPILLING, encoding="utf-8")
        if not any("registers spilled" in finding for finding in check(nvcc, source, flags, False)):
            missed.append("planted, but not found: spilled registers")
        source.write_text(KERNEL.format(""), encoding="utf-8")
        if not any("no kernel matches" in finding for finding in check(nvcc, source, flags, False)):
            missed.append("planted, but not found: no hot kernel")
        for what, body, others, expected in [*FAULTS, ("nothing", SOUND, [], None)]:
            source.write_text(KERNEL.format(body), encoding="utf-8")
            replaced = [flag.split("=")[0] for flag in others]
            used = [flag for flag in flags if flag.split("=")[0] not in replaced] + others
            findings = ptx_findings(make_ptx(nvcc, source, used, ARCHITECTURES[0], ptx))
            if expected is None and findings:
                missed.append(f"found in sound code: {findings}")
            elif expected is not None and not any(expected in finding for finding in findings):
                missed.append(f"planted, but not found: {what}")
    return missed


def main():
    arguments = [a for a in sys.argv[1:] if a not in ("--report", "--planted")]
    if len(arguments) < 2:
        sys.exit(__doc__)
    nvcc, source, *flags = arguments
    if "--planted" in sys.argv:
        findings = planted(nvcc, flags)
    else:
        findings = check(nvcc, source, flags, "--report" in sys.argv)
    for finding in findings:
        print(finding)
    sys.exit(1 if findings else 0)


if __name__ == "__main__":
    main()
