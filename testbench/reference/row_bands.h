#pragma once
// Shares out the rows of a picture, or any numbered pieces of work, over threads: whoever is free takes the next band. Work on a row must
// depend on nothing that another row writes; then the result is the same for any number of threads. Threads may also run beside other work
// of the caller, who joins in when it is done with that. No model of hardware.

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace bump {

class RowBands {
 public:
  /// Rows first_row up to, not including, end_row; called from several threads at a time.
  using Work = std::function<void(int first_row, int end_row)>;

  /// Nothing is done yet. `cancelled` may be null; it is looked at before every band.
  RowBands(int rows, int rows_of_band, Work work, const std::atomic<bool>* cancelled = nullptr);
  /// Bands that nobody has begun are left undone.
  ~RowBands();
  RowBands(const RowBands&) = delete;
  RowBands& operator=(const RowBands&) = delete;

  /// Sets `threads` threads to work beside the caller; where the system grants fewer, fewer do it. Call it once.
  void begin(int threads);
  /// The caller works along; returns when every row is done and no thread is left. Throws what the work threw for the topmost of the bands
  /// that failed, or Error(cancelled).
  void finish();

 private:
  void work_along();
  void fail(int first_row);
  void join();

  const int rows_, rows_of_band_;
  const Work work_;
  const std::atomic<bool>* cancelled_;
  std::atomic<int> next_row_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;  ///< of the failure
  std::exception_ptr failure_;
  int failed_row_ = 0;
  std::vector<std::thread> threads_;
};

/// All rows over `threads` threads, the caller's among them.
void for_row_bands(int rows, int rows_of_band, int threads, const RowBands::Work& work, const std::atomic<bool>* cancelled = nullptr);

}  // namespace bump
