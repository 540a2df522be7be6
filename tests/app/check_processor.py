# SPDX-License-Identifier: Apache-2.0
"""Programs on a processor older than the one that they were compiled for, which qemu plays: one line, exit code 2.

usage: check_processor.py QEMU COMPILER MARCH PROGRAM...
"""
import subprocess
import sys

qemu, compiler, march, *programs = sys.argv[1:]
OLD = "Nehalem"  # of 2008: SSE4.2, no AVX

macros = subprocess.run([compiler, *([f"-march={march}"] if march else []), "-dM", "-E", "-x", "c++", "/dev/null"],
                        stdout=subprocess.PIPE, text=True, check=True).stdout
newer = "__AVX__" in macros
failures = []
for program in programs:
    on_old = subprocess.run([qemu, "-cpu", OLD, program, "--help"], capture_output=True, text=True)
    last = (on_old.stderr.splitlines() or [""])[-1]  # qemu itself may warn before
    if newer:
        good = on_old.returncode == 2 and on_old.stdout == ""
        good &= last.startswith("aneurysm: processor: it lacks AVX") and f"-march={march}" in last and "ANEURYSM_MARCH" in last
    else:
        good = on_old.returncode == 0
    if not good:
        failures.append(f"{program} on {OLD}: exit code {on_old.returncode}: {on_old.stderr}")
print("\n".join(failures) or f"{len(programs)} programs: {'refused' if newer else 'run'} on {OLD}")
sys.exit(bool(failures))
