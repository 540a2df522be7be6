// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Marks functions that run on the host and on a GPU.
#ifdef __CUDACC__
#define ANEURYSM_HD __host__ __device__
#else
#define ANEURYSM_HD
#endif
