#include "testbench/reference/row_bands.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "datapath/error.h"
#include "datapath/invariant.h"

namespace bump {

RowBands::RowBands(int rows, int rows_of_band, Work work, const std::atomic<bool>* cancelled)
    : rows_(rows), rows_of_band_(rows_of_band), work_(std::move(work)), cancelled_(cancelled) {
  BUMP_ASSERT(rows >= 0 && rows_of_band > 0);
}

RowBands::~RowBands() {
  stopped_ = true;
  join();
}

void RowBands::begin(int threads) {
  BUMP_ASSERT(threads_.empty());
  const int bands = rows_ / rows_of_band_ + (rows_ % rows_of_band_ != 0 ? 1 : 0);
  try {
    for (int i = 0; i < std::min(threads, bands); ++i) threads_.emplace_back([this] { work_along(); });
  } catch (const std::system_error&) {
    // No more threads to be had: finish() needs none.
  }
}

void RowBands::finish() {
  work_along();
  join();
  if (failure_) std::rethrow_exception(failure_);
}

void RowBands::work_along() {
  while (!stopped_) {
    const int first = next_row_.fetch_add(rows_of_band_);
    if (first >= rows_) return;
    try {
      if (cancelled_ != nullptr && *cancelled_) throw Error(ErrorKind::cancelled, {"interrupted", {}, "", "nothing was written"});
      work_(first, std::min(first + rows_of_band_, rows_));
    } catch (...) {
      fail(first);
    }
  }
}

void RowBands::fail(int first_row) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!failure_ || first_row < failed_row_) {
    failure_ = std::current_exception();
    failed_row_ = first_row;
  }
  stopped_ = true;
}

void RowBands::join() {
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

void for_row_bands(int rows, int rows_of_band, int threads, const RowBands::Work& work, const std::atomic<bool>* cancelled) {
  RowBands bands(rows, rows_of_band, work, cancelled);
  bands.begin(threads - 1);
  bands.finish();
}

}  // namespace bump
