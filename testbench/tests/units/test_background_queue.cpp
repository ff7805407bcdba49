#include <atomic>
#include <catch2/catch.hpp>
#include <thread>
#include <vector>

#include "units/background_queue.h"

using namespace bump;

TEST_CASE("items are worked off in order, each once, with a thread and without") {
  const bool with_thread = GENERATE(false, true);
  const std::size_t capacity = GENERATE(1u, 3u, 64u);
  std::vector<int> seen;
  BackgroundQueue<int> queue(capacity, with_thread, [&](const int& item) { seen.push_back(item); });
  for (int i = 0; i < 500; ++i) {
    queue.next() = i;
    queue.push();
    if (i % 100 == 0) queue.drain();
  }
  queue.drain();
  REQUIRE(seen.size() == 500);
  int wrong = 0;
  for (int i = 0; i < 500; ++i) wrong += seen[static_cast<std::size_t>(i)] == i ? 0 : 1;
  CHECK(wrong == 0);
}

TEST_CASE("a queue that is given up ends without working off what waits") {
  std::atomic<bool> begun{false}, go{false};
  std::atomic<int> done{0};
  {
    BackgroundQueue<int> queue(8, true, [&](const int&) {
      begun = true;
      while (!go) std::this_thread::yield();
      ++done;
    });
    for (int i = 0; i < 8; ++i) {
      queue.next() = i;
      queue.push();
    }
    while (!begun) std::this_thread::yield();
    go = true;
  }
  CHECK(done >= 1);
}
