// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "verification/backends/make_simulation.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace aneurysm::reproduction
{

/// A folder of runs, made when they are asked for and kept: one that is complete isn't made again, one that
/// was interrupted goes on, one of another scenario, program or backend is made anew.
class RunStore
{
public:
    /// `jobs`: runs at once; 0: as many as pay
    RunStore(std::filesystem::path directory, backends::BackendChoice backend, int jobs);

    /// Makes all that are missing, several at once, with progress. Their names must differ.
    /// \throws Interrupted after a checkpoint of each; Error when a run fails
    void make(const std::vector<Scenario>& scenarios);

    /// Of a scenario.
    std::filesystem::path directory(const Scenario& scenario) const;
    /// Of one that was made: all frames, from 1 on.
    std::vector<FrameRecord> records(const Scenario& scenario) const;

    const backends::BackendChoice& backend() const { return backend_; }

private:
    bool complete(const Scenario& scenario) const;

    std::filesystem::path directory_;
    backends::BackendChoice backend_;
    int jobs_;
};

} // namespace aneurysm::reproduction
