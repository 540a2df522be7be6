// SPDX-License-Identifier: Apache-2.0
#include "cuda/processor_needs.hpp"

// A macro that the compiler has set expands to 1; another to its own name.
#define ANEURYSM_TEXT(macro) #macro
#define ANEURYSM_IS_SET(macro) (ANEURYSM_TEXT(macro)[0] == '1')

namespace aneurysm::device
{

constinit const ProcessorNeeds processor_needs{ANEURYSM_IS_SET(__SSE4_2__),
                                               ANEURYSM_IS_SET(__AVX__),
                                               ANEURYSM_IS_SET(__AVX2__),
                                               ANEURYSM_IS_SET(__FMA__),
                                               ANEURYSM_IS_SET(__AVX512F__),
                                               ANEURYSM_IS_SET(__AVX512BW__),
                                               ANEURYSM_IS_SET(__AVX512DQ__),
                                               ANEURYSM_IS_SET(__AVX512VL__),
                                               ANEURYSM_IS_SET(__AVX512VBMI__),
                                               ANEURYSM_IS_SET(__AVX512VNNI__),
                                               ANEURYSM_MARCH};

} // namespace aneurysm::device
