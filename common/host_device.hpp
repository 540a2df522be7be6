// SPDX-License-Identifier: Apache-2.0
#pragma once

/// ANEURYSM_HD marks functions that run on the host and on a GPU; ANEURYSM_INLINE those that must dissolve in
/// their callers as well, so that the vectors they take and return stay in registers.
#ifdef __CUDACC__
#define ANEURYSM_HD __host__ __device__
#define ANEURYSM_INLINE __host__ __device__ __forceinline__
#else
#define ANEURYSM_HD
#define ANEURYSM_INLINE [[gnu::always_inline]] inline
#endif
