// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cuda/executor/lanes.hpp"

namespace aneurysm::device
{

/// Collects what a search finds: counts it, or writes it behind one another.
template <bool write>
class Hits
{
public:
    ANEURYSM_HD explicit Hits(Index* list) : list_(list) {}

    ANEURYSM_INLINE void add(const Mask& m, const Lanes<Index>& value, Lane lane)
    {
        if (count_ > limit - lane_count) {
            return;
        }
        if constexpr (!write) {
            count_ += device::count(m, lane);
        } else {
#ifdef __CUDACC__
            count_ = append(list_, count_, m, value, lane);
#else
            count_ = append(local_, count_, m, value, lane);
#endif
        }
    }
    /// Fills the last block up.
    ANEURYSM_INLINE void pad(Index value, Lane lane)
    {
#ifdef __CUDACC__
        const Index k = count_ + lane.id;
        const Index end = (count_ + lane_count - 1) / lane_count * lane_count;
        if (k < end) {
            list_[k] = value;
        }
#else
        store(local_ + count_, Lanes<Index>(value), lane);
        for (Index k = 0; k < count_; k += lane_count) {
            store(list_ + k, load(local_ + k, lane), lane);
        }
#endif
    }
    ANEURYSM_HD Index count() const
    {
        return count_;
    }

private:
    static constexpr Index limit = 1024; ///< more is no fluid: its density stops the run

    Index* list_;
    Index count_ = 0;
#ifndef __CUDACC__
    // append() also writes behind the last, which in the list may belong to another thread.
    Index local_[write ? limit + lane_count : 1];
#endif
};

} // namespace aneurysm::device
