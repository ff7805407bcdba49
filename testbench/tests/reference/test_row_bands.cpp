#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "testbench/reference/cores.h"
#include "testbench/reference/row_bands.h"

using namespace bump;

TEST_CASE("every row is worked on once, whatever the number of rows, bands and threads") {
  const int rows = GENERATE(0, 1, 7, 100), band = GENERATE(1, 3, 100), threads = GENERATE(1, 2, 5);
  std::vector<std::atomic<int>> times(static_cast<std::size_t>(rows));
  std::atomic<bool> too_high{false};
  for_row_bands(rows, band, threads, [&](int first_row, int end_row) {
    if (end_row - first_row > band) too_high = true;
    for (int row = first_row; row < end_row; ++row) ++times[static_cast<std::size_t>(row)];
  });
  CHECK(!too_high);
  int wrong = 0;
  for (const std::atomic<int>& count : times) wrong += count == 1 ? 0 : 1;
  CHECK(wrong == 0);
}

TEST_CASE("what the work throws reaches the caller, from the topmost band that failed") {
  const int threads = GENERATE(1, 2, 4);
  std::string what;
  try {
    // Every band fails, and the first is always begun.
    for_row_bands(20, 1, threads, [](int first_row, int) { throw std::runtime_error(std::to_string(first_row)); });
  } catch (const std::runtime_error& error) {
    what = error.what();
  }
  CHECK(what == "0");
}

TEST_CASE("bands are given up when the flag is set") {
  const int threads = GENERATE(1, 3);
  std::atomic<bool> cancelled{false};
  std::atomic<int> done{0};
  const auto work = [&](int, int) {
    ++done;
    cancelled = true;
  };
  CHECK_THROWS_AS(for_row_bands(1000, 1, threads, work, &cancelled), Error);
  CHECK(done <= threads);
}

TEST_CASE("threads work beside the caller, and bands that nobody began are left undone") {
  std::atomic<int> done{0};
  {
    RowBands bands(50, 1, [&](int, int) { ++done; });
    bands.begin(2);
    bands.finish();
    CHECK(done == 50);
  }
  {
    RowBands bands(50, 1, [&](int, int) { ++done; });
  }
  CHECK(done == 50);
}

TEST_CASE("a process runs on one core at least") {
  CHECK(cores_of_process() >= 1);
}
