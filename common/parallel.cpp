// SPDX-License-Identifier: Apache-2.0
#include "common/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <iterator>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace aneurysm
{
namespace
{

/// Threads that wait until they are told to end, as many as the system gives.
class Waiting
{
public:
    explicit Waiting(int wanted)
    {
        try {
            for (int t = 0; t < wanted; ++t) {
                crew_.emplace_back([this] { end_.wait(false); });
            }
        } catch (const std::system_error&) { // NOLINT(bugprone-empty-catch): size() says so
        }
    }
    ~Waiting()
    {
        end_ = true;
        end_.notify_all();
    }
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;

    int size() const { return static_cast<int>(crew_.size()); }

private:
    std::atomic<bool> end_ = false;
    std::vector<std::jthread> crew_; // last: they end before what they use
};

/// Of this process, as the kernel counts them.
std::ptrdiff_t threads_now()
{
    std::error_code unused;
    return std::distance(std::filesystem::directory_iterator("/proc/self/task", unused), {});
}

} // namespace

int thread_count(int jobs)
{
    return jobs > 0 ? jobs : paying_threads();
}

int startable_threads(int wanted)
{
    constexpr int patience_ms = 50;
    const int processors =
        std::max(2, static_cast<int>(std::thread::hardware_concurrency())); // more only take turns
    if (wanted < 2) {
        return 1;
    }
    const std::ptrdiff_t before = threads_now();
    const int others = Waiting(std::min(wanted, processors) - 1).size();
    // A thread that was joined counts a moment longer, and would be missing from those that are started next.
    for (int t = 0; t < patience_ms && threads_now() > before; ++t) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return 1 + others;
}

void in_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work,
                 const std::function<void()>& watch)
{
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::condition_variable ended;
    int working = 0;
    std::exception_ptr failure;
    const auto take_all = [&] {
        std::exception_ptr mine;
        try {
            for (std::size_t k = next++; k < count; k = next++) {
                work(k);
            }
        } catch (...) {
            mine = std::current_exception();
            next = count;
        }
        const std::scoped_lock lock(mutex);
        failure = failure ? failure : mine;
        --working;
        ended.notify_one();
    };
    std::vector<std::jthread> crew; // last: they end before what they use
    const auto wanted =
        std::min(static_cast<std::size_t>(std::max(threads, 1)), std::max<std::size_t>(count, 1));
    std::unique_lock lock(mutex);
    try {
        for (; crew.size() < wanted; ++working) {
            crew.emplace_back(take_all);
        }
    } catch (const std::system_error&) {
        if (crew.empty()) {
            throw;
        }
    }
    while (working > 0) {
        ended.wait_for(lock, std::chrono::milliseconds(200));
        lock.unlock();
        watch();
        lock.lock();
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

} // namespace aneurysm
