#pragma once
// Threads that share a list of independent pieces of work, for sweeps over a trace. Whoever waits for them can show progress meanwhile. No
// model of hardware.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace bump {

class Team {
 public:
  /// `jobs` threads, 0: one per core. `watch` is called ten times a second while they work.
  Team(int jobs, std::function<void()> watch) : watch_(std::move(watch)) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    jobs_ = jobs > 0 ? static_cast<std::size_t>(jobs) : cores;
  }

  std::size_t jobs() const { return jobs_; }

  /// Runs work(0) ... work(count - 1), several at a time. The first exception by index is thrown on.
  void run(std::size_t count, const std::function<void(std::size_t)>& work) {
    std::vector<std::exception_ptr> failures(count);
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    std::mutex mutex;
    std::condition_variable finished;
    std::size_t running = std::min(jobs_, count);
    std::vector<std::thread> threads;
    const auto member = [&] {
      for (std::size_t i = next++; i < count && !failed; i = next++) {
        try {
          work(i);
        } catch (...) {
          failures[i] = std::current_exception();
          failed = true;
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      --running;
      finished.notify_one();
    };
    for (std::size_t i = 0, all = running; i < all; ++i) threads.emplace_back(member);
    std::unique_lock<std::mutex> lock(mutex);
    while (!finished.wait_for(lock, std::chrono::milliseconds(100), [&] { return running == 0; })) watch_();
    lock.unlock();
    for (std::thread& thread : threads) thread.join();
    for (const std::exception_ptr& failure : failures)
      if (failure) std::rethrow_exception(failure);
  }

 private:
  std::size_t jobs_ = 1;
  std::function<void()> watch_;
};

}  // namespace bump
