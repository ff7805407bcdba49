#include "testbench/experiments/frame_bytes.h"

#include <cstdint>
#include <cstring>

#include "datapath/invariant.h"

namespace bump {

namespace {

template <class Value>
void append_value(std::string& bytes, Value value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Container>
void append_elements(std::string& bytes, const Container& container) {
  append_value(bytes, static_cast<std::uint64_t>(container.size()));
  bytes.append(reinterpret_cast<const char*>(container.data()), container.size() * sizeof(typename Container::value_type));
}

}  // namespace

void append(std::string& bytes, const FrameBuffer& frame) {
  append_value(bytes, frame.width);
  append_value(bytes, frame.height);
  append_elements(bytes, frame.colour);
  append_elements(bytes, frame.object);
  append_elements(bytes, frame.depth);
}

void append(std::string& bytes, const EightBitImage& image) {
  append_value(bytes, image.width);
  append_value(bytes, image.height);
  append_elements(bytes, image.samples);
}

void append(std::string& bytes, const AngularError& error) {
  append_elements(bytes, error.vector);
  append_value(bytes, error.count);
  for (const double degrees : {error.mean_degrees, error.rms_degrees, error.max_degrees}) append_value(bytes, degrees);
}

void ByteReader::copy(void* to, std::size_t count) {
  BUMP_ASSERT(bytes_.size() - at_ >= count);
  if (count > 0) std::memcpy(to, bytes_.data() + at_, count);
  at_ += count;
}

template <class Value>
Value ByteReader::value() {
  Value result;
  copy(&result, sizeof result);
  return result;
}

template <class Container>
void ByteReader::elements(Container& container) {
  const auto count = static_cast<std::size_t>(value<std::uint64_t>());
  BUMP_ASSERT(count <= (bytes_.size() - at_) / sizeof(typename Container::value_type));
  container.resize(count);
  copy(container.data(), count * sizeof(typename Container::value_type));
}

void ByteReader::read(FrameBuffer& frame) {
  frame.width = value<int>();
  frame.height = value<int>();
  elements(frame.colour);
  elements(frame.object);
  elements(frame.depth);
}

void ByteReader::read(EightBitImage& image) {
  image.width = value<int>();
  image.height = value<int>();
  elements(image.samples);
}

void ByteReader::read(AngularError& error) {
  elements(error.vector);
  error.count = value<std::int64_t>();
  for (double* degrees : {&error.mean_degrees, &error.rms_degrees, &error.max_degrees}) *degrees = value<double>();
}

}  // namespace bump
