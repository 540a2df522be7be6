// SPDX-License-Identifier: Apache-2.0
// Part of every program with the optimized backend: ends it in words where an illegal instruction would.
#include "app/exit_codes.hpp"
#include "cuda/processor_needs.hpp"

#if defined(__x86_64__)

#include <cstring>
#include <unistd.h>

namespace aneurysm::app
{
namespace
{

/// Without the standard library: a function of it may be linked as the optimized code's copy.
void say(const char* text)
{
    if (write(STDERR_FILENO, text, std::strlen(text)) < 0) {
        _exit(exit_bad_input);
    }
}

/// Names an extension that is needed and isn't here.
bool lacks(bool needed, bool here, const char* name, bool first)
{
    if (!needed || here) {
        return false;
    }
    say(first ? "aneurysm: processor: it lacks " : ", ");
    say(name);
    return true;
}

/// Before all other code of the program: constructors of global objects may be compiled for the newer processor.
[[gnu::constructor(101)]] void check_processor()
{
    __builtin_cpu_init();
    const device::ProcessorNeeds& needs = device::processor_needs;
    bool bad = false;
    bad |= lacks(needs.sse4_2, __builtin_cpu_supports("sse4.2") != 0, "SSE4.2", !bad);
    bad |= lacks(needs.avx, __builtin_cpu_supports("avx") != 0, "AVX", !bad);
    bad |= lacks(needs.avx2, __builtin_cpu_supports("avx2") != 0, "AVX2", !bad);
    bad |= lacks(needs.fma, __builtin_cpu_supports("fma") != 0, "FMA", !bad);
    bad |= lacks(needs.avx512f, __builtin_cpu_supports("avx512f") != 0, "AVX512F", !bad);
    bad |= lacks(needs.avx512bw, __builtin_cpu_supports("avx512bw") != 0, "AVX512BW", !bad);
    bad |= lacks(needs.avx512dq, __builtin_cpu_supports("avx512dq") != 0, "AVX512DQ", !bad);
    bad |= lacks(needs.avx512vl, __builtin_cpu_supports("avx512vl") != 0, "AVX512VL", !bad);
    bad |= lacks(needs.avx512vbmi, __builtin_cpu_supports("avx512vbmi") != 0, "AVX512VBMI", !bad);
    bad |= lacks(needs.avx512vnni, __builtin_cpu_supports("avx512vnni") != 0, "AVX512VNNI", !bad);
    if (bad) {
        say(", which this program was compiled for (-march=");
        say(needs.march);
        say("); needed: a newer processor, or a build of the sources with -D ANEURYSM_MARCH=x86-64\n");
        _exit(exit_bad_input);
    }
}

} // namespace
} // namespace aneurysm::app

#endif
