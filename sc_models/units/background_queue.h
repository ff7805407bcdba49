#pragma once
// Work that may lag behind the simulation, done in order by a thread of its own: a bounded queue between the two, whose items are used
// again and again. One producer. Without a thread (not wanted, or not to be had) items are worked off as they come, with the same results.
// No hardware and no time.

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace bump {

template <class Item>
class BackgroundQueue {
 public:
  /// `work` must not throw.
  BackgroundQueue(std::size_t capacity, bool with_thread, std::function<void(const Item&)> work)
      : work_(std::move(work)), items_(with_thread ? capacity : 1) {
    if (!with_thread) return;
    try {
      thread_ = std::thread([this] { work_off(); });
    } catch (const std::system_error&) {
      // The producer does it itself.
    }
  }
  /// Items that wait are dropped.
  ~BackgroundQueue() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      stopped_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
  }
  BackgroundQueue(const BackgroundQueue&) = delete;
  BackgroundQueue& operator=(const BackgroundQueue&) = delete;

  /// The item to fill next, as it was left by an earlier use; waits for one that is free.
  Item& next() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return begun_ - done_ < items_.size(); });
    return items_[begun_ % items_.size()];
  }
  /// Hands over the item of next().
  void push() {
    if (!thread_.joinable()) {
      work_(items_[begun_ % items_.size()]);
      return;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    ++begun_;
    changed_.notify_all();
  }
  /// Returns when everything handed over is worked off.
  void drain() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return begun_ == done_; });
  }

 private:
  void work_off() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return stopped_ || begun_ != done_; });
      if (stopped_) return;
      const Item& item = items_[done_ % items_.size()];
      lock.unlock();
      work_(item);
      lock.lock();
      ++done_;
      changed_.notify_all();
    }
  }

  const std::function<void(const Item&)> work_;
  std::vector<Item> items_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t begun_ = 0, done_ = 0;  ///< items so far
  bool stopped_ = false;
  std::thread thread_;
};

}  // namespace bump
