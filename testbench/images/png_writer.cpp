#include "testbench/images/png_writer.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <vector>

#include "datapath/error.h"
#include "datapath/invariant.h"
#include "datapath/lane_clones.h"
#include "testbench/images/png_guard.h"

namespace bump {

namespace {

BUMP_LANE_LOOP void round_values(const double* colour, int count, std::int32_t* steps) {
  for (int i = 0; i < count; ++i) {
    const double above = colour[i] > 0 ? colour[i] : 0, value = above < 1 ? above : 1;
    steps[i] = static_cast<std::int32_t>(value * 255 + 0.5);
  }
}

BUMP_LANE_LOOP void narrow(const std::int32_t* steps, int count, unsigned char* pixels) {
  for (int i = 0; i < count; ++i) pixels[i] = static_cast<unsigned char>(steps[i]);
}

/// In two steps, since compilers do not vectorise from eight bytes to one.
void round_row(const double* colour, int count, unsigned char* pixels) {
  std::array<std::int32_t, 512> steps;
  for (int first = 0; first < count; first += static_cast<int>(steps.size())) {
    const int some = std::min(count - first, static_cast<int>(steps.size()));
    round_values(colour + first, some, steps.data());
    narrow(steps.data(), some, pixels + first);
  }
}

struct Sink {
  std::string bytes{};
  bool out_of_memory = false;
};

void give_bytes(png_structp png, png_bytep from, std::size_t count) {
  auto& sink = *static_cast<Sink*>(png_get_io_ptr(png));
  try {
    sink.bytes.append(reinterpret_cast<const char*>(from), count);
  } catch (const std::bad_alloc&) {
    sink.out_of_memory = true;
  }
  if (sink.out_of_memory) png_error(png, "out of memory");
}

/// There is nothing between a string and what it holds.
void flush_bytes(png_structp) {}

class Writer {
 public:
  Writer() {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message_, leave_png_message, ignore_png_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_write_struct(&png_, nullptr);
      throw std::bad_alloc();
    }
    png_set_write_fn(png_, &sink_, give_bytes, flush_bytes);
  }
  ~Writer() { png_destroy_write_struct(&png_, &info_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  std::string write(int width, int height, const double* colour) {
    const int count = 3 * width;
    std::vector<unsigned char> row(static_cast<std::size_t>(count));
    const bool written = guarded_png(png_, [&] {
      png_set_IHDR(png_, info_, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8, PNG_COLOR_TYPE_RGB,
                   PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
      png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
      png_set_compression_level(png_, 1);
      png_set_compression_strategy(png_, Z_RLE);
      png_write_info(png_, info_);
      for (int y = 0; y < height; ++y) {
        round_row(colour + static_cast<std::size_t>(y) * static_cast<std::size_t>(count), count, row.data());
        png_write_row(png_, row.data());
      }
      png_write_end(png_, info_);
    });
    if (sink_.out_of_memory) throw std::bad_alloc();
    if (!written)
      throw Error(ErrorKind::internal, {"cannot encode a PNG picture", {}, message_.text.data(), "check the installation of libpng"});
    return std::move(sink_.bytes);
  }

 private:
  PngMessage message_;
  Sink sink_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace

std::string png_of(int width, int height, const double* colour) {
  BUMP_ASSERT(width > 0 && height > 0);
  return Writer().write(width, height, colour);
}

}  // namespace bump
