// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/pictures/scene.hpp"
#include "verification/backends/make_simulation.hpp"

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace aneurysm::app
{

/// A simulation in a thread of its own, which hands out copies
/// of its state: a window stays responsive beside it.
class Worker
{
public:
    /// Paused at first. `last`: the frame that it stops at.
    Worker(std::unique_ptr<Simulation> backend, const pictures::Snapshot& start, std::int64_t last);
    ~Worker(); ///< waits for the end of the frame
    Worker(const Worker&) = delete;
    Worker(Worker&&) = delete;
    Worker& operator=(const Worker&) = delete;
    Worker& operator=(Worker&&) = delete;

    void set_running(bool running);
    /// One more frame, when paused; several calls add up.
    void step();

    struct Status {
        bool running = false;
        bool idle = true;  ///< neither running nor with steps to make
        bool done = false; ///< at the last frame
        std::string error; ///< of the simulation, which has ended with it
    };
    Status status() const;
    /// The newest state, and all rows since the last call. \return false when nothing is new
    bool take(pictures::Snapshot& snapshot, std::vector<FrameRecord>& records);

private:
    void work();
    bool has_work() const
    {
        return error_.empty() && newest_.record.frame < last_ && (running_ || steps_ > 0);
    }

    std::unique_ptr<Simulation> backend_; ///< the thread's alone
    std::int64_t last_;
    mutable std::mutex mutex_; ///< of all below
    std::condition_variable wake_;
    bool stop_ = false;
    bool running_ = false;
    std::int64_t steps_ = 0;
    bool fresh_ = true;
    pictures::Snapshot newest_;
    std::vector<FrameRecord> records_; ///< not taken yet
    std::string error_;
    std::thread thread_;
};

} // namespace aneurysm::app
