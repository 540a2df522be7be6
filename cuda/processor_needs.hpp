// SPDX-License-Identifier: Apache-2.0
// Which instructions the optimized CPU code was compiled with.
#pragma once

namespace aneurysm::device
{

/// Extensions of x86-64 that a compiler uses by itself; whether -march let it.
struct ProcessorNeeds {
    bool sse4_2, avx, avx2, fma, avx512f, avx512bw, avx512dq, avx512vl, avx512vbmi, avx512vnni;
    const char* march; ///< as -march had it
};

/// Plain data, so that reading it takes no instruction of them.
extern const ProcessorNeeds processor_needs;

} // namespace aneurysm::device
