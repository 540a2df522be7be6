// SPDX-License-Identifier: Apache-2.0
#include "common/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace aneurysm
{

int thread_count(int jobs)
{
    return jobs > 0 ? jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void in_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work,
                 const std::function<void()>& watch)
{
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::condition_variable ended;
    int working = std::max(threads, 1);
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
    for (int t = working; t > 0; --t) {
        crew.emplace_back(take_all);
    }
    std::unique_lock lock(mutex);
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
