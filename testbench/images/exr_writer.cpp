#include "testbench/images/exr_writer.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "datapath/error.h"
#include "datapath/invariant.h"
#include "datapath/lane_clones.h"

namespace bump {

namespace {

constexpr std::array<const char*, 3> channels = {"R", "G", "B"};
constexpr std::size_t pixel_bytes = channels.size() * sizeof(float);

class MemoryStream : public Imf::OStream {
 public:
  explicit MemoryStream(std::size_t expected_size) : Imf::OStream("frame.exr") { bytes_.reserve(expected_size); }
  void write(const char from[], int count) override {
    const auto size = static_cast<std::size_t>(count), within = std::min(size, bytes_.size() - at_);
    std::memcpy(bytes_.data() + at_, from, within);
    bytes_.append(from + within, size - within);
    at_ += size;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t position) override {
    BUMP_ASSERT(position <= bytes_.size());
    at_ = static_cast<std::size_t>(position);
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

BUMP_LANE_LOOP void round_to_float(const double* row, int count, float* rounded) {
  for (int i = 0; i < count; ++i) rounded[i] = static_cast<float>(row[i]);
}

Imf::Header header_of(int width, int height) {
  Imf::Header header(width, height);
  header.compression() = Imf::NO_COMPRESSION;
  for (const char* name : channels) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  Imf::addCapDate(header, "1970:01:01 00:00:00");
  return header;
}

/// Every row of the file is taken from `row`.
Imf::FrameBuffer buffer_of(std::vector<float>& row) {
  Imf::FrameBuffer buffer;
  for (std::size_t i = 0; i < channels.size(); ++i)
    buffer.insert(channels[i], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&row[i]), pixel_bytes, 0));
  return buffer;
}

void write_rows(MemoryStream& stream, int width, int height, const double* colour) {
  const auto count = channels.size() * static_cast<std::size_t>(width);
  std::vector<float> row(count);
  Imf::OutputFile file(stream, header_of(width, height), 0);
  file.setFrameBuffer(buffer_of(row));
  for (int y = 0; y < height; ++y) {
    round_to_float(colour + static_cast<std::size_t>(y) * count, static_cast<int>(count), row.data());
    file.writePixels(1);
  }
}

}  // namespace

std::string exr_of(int width, int height, const double* colour) {
  BUMP_ASSERT(width > 0 && height > 0);
  const auto rows = static_cast<std::size_t>(height);
  MemoryStream stream(1024 + rows * (16 + pixel_bytes * static_cast<std::size_t>(width)));
  try {
    write_rows(stream, width, height, colour);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ErrorKind::internal, {"cannot encode an OpenEXR picture", {}, error.what(), "check the installation of OpenEXR"});
  }
  return stream.take();
}

}  // namespace bump
