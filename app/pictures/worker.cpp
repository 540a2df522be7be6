// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/worker.hpp"

#include "common/exception.hpp"

#include <exception>
#include <utility>

namespace aneurysm::app
{

Worker::Worker(std::unique_ptr<Simulation> backend, const pictures::Snapshot& start, std::int64_t last)
    : backend_(std::move(backend)), last_(last), newest_(start), thread_([this] { work(); })
{
}

Worker::~Worker()
{
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void Worker::set_running(bool running)
{
    {
        const std::lock_guard lock(mutex_);
        running_ = running;
    }
    wake_.notify_one();
}

void Worker::step()
{
    {
        const std::lock_guard lock(mutex_);
        steps_ += running_ ? 0 : 1;
    }
    wake_.notify_one();
}

Worker::Status Worker::status() const
{
    const std::lock_guard lock(mutex_);
    return {running_, !has_work(), newest_.record.frame >= last_, error_};
}

bool Worker::take(pictures::Snapshot& snapshot, std::vector<FrameRecord>& records)
{
    const std::lock_guard lock(mutex_);
    if (!std::exchange(fresh_, false)) {
        return false;
    }
    snapshot = newest_;
    records.insert(records.end(), records_.begin(), records_.end());
    records_.clear();
    return true;
}

void Worker::work()
{
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock, [this] { return stop_ || has_work(); });
        if (stop_) {
            return;
        }
        const bool stepping = !running_;
        lock.unlock();
        pictures::Snapshot next;
        std::string error;
        try {
            next.record = backend_->advance();
            next.particles = output::shown_particles({backend_->state().particles, backend_->density()});
        } catch (const std::exception& failure) {
            error = text_of(failure);
        }
        lock.lock();
        if (!error.empty()) {
            error_ = error;
            running_ = false;
        } else {
            records_.push_back(next.record);
            newest_ = std::move(next);
            fresh_ = true;
        }
        steps_ -= stepping ? 1 : 0;
    }
}

} // namespace aneurysm::app
