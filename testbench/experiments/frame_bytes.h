#pragma once
// Pictures and what goes with them as bytes, for their way from a child process (child_processes.h) to its parent: the same program on the
// same machine, so numbers travel as they lie in memory. Not a file format. No model of hardware.

#include <cstddef>
#include <string>
#include <string_view>

#include "testbench/experiments/whole_frame.h"
#include "units/counters.h"
#include "units/frame_buffer.h"

namespace bump {

void append(std::string& bytes, const FrameBuffer& frame);
void append(std::string& bytes, const EightBitImage& image);
void append(std::string& bytes, const AngularError& error);

/// Reads back what was appended, in order. The bytes must outlive it and must be whole.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
  void read(FrameBuffer& frame);
  void read(EightBitImage& image);
  void read(AngularError& error);
  bool at_end() const { return at_ == bytes_.size(); }

 private:
  void copy(void* to, std::size_t count);
  template <class Value>
  Value value();
  template <class Container>
  void elements(Container& container);

  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace bump
