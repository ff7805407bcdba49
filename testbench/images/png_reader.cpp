#include "testbench/images/png_reader.h"

#include <cstring>
#include <new>
#include <vector>

#include "testbench/images/image_errors.h"
#include "testbench/images/png_guard.h"
#include "testbench/scene/image.h"

namespace bump {

namespace {

struct Source {
  const char* next;
  std::size_t left;
};

void take_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (count > source.left) png_error(png, "the file ends too early");
  std::memcpy(to, source.next, count);
  source.next += count;
  source.left -= count;
}

class Reader {
 public:
  explicit Reader(const std::string& bytes) : source_{bytes.data(), bytes.size()} {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message_, leave_png_message, ignore_png_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, &source_, take_bytes);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // the caller's limits are tighter, and say so
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  bool read_header() {
    return guarded_png(png_, [this] {
      png_read_info(png_, info_);
      png_set_expand(png_);
      png_set_strip_alpha(png_);
    });
  }

  /// Rows from the top; 16-bit values have their high byte first.
  bool read_pixels() {
    const bool begun = guarded_png(png_, [this] {
      png_set_interlace_handling(png_);
      png_read_update_info(png_, info_);
    });
    if (!begun) return false;
    const std::size_t row_bytes = png_get_rowbytes(png_, info_);
    pixels_.resize(row_bytes * static_cast<std::size_t>(height()));
    std::vector<png_bytep> rows;
    for (std::size_t at = 0; at < pixels_.size(); at += row_bytes) rows.push_back(&pixels_[at]);
    return guarded_png(png_, [this, &rows] {
      png_read_image(png_, rows.data());
      png_read_end(png_, nullptr);
    });
  }

  long width() const { return static_cast<long>(png_get_image_width(png_, info_)); }
  long height() const { return static_cast<long>(png_get_image_height(png_, info_)); }
  int channels() const { return png_get_channels(png_, info_); }
  int bits() const { return png_get_bit_depth(png_, info_); }
  const std::vector<unsigned char>& pixels() const { return pixels_; }
  std::string message() const { return message_.text.data(); }

 private:
  Source source_;
  PngMessage message_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::vector<unsigned char> pixels_;
};

template <class Sample>
void copy_flipped(const Reader& reader, const Sample& sample, Image& image) {
  const std::size_t step = image.bits == 16 ? 2 : 1, row_bytes = image.values.size() / static_cast<std::size_t>(image.height) * step;
  double* out = image.values.data();
  for (int y = image.height; y-- > 0;) {
    const unsigned char* row = &reader.pixels()[static_cast<std::size_t>(y) * row_bytes];
    for (std::size_t at = 0; at < row_bytes; at += step) *out++ = sample(row + at);
  }
}

}  // namespace

bool is_png(const std::string& bytes) {
  constexpr char mark[] = "\x89PNG\r\n\x1a\n";
  return bytes.compare(0, 8, mark) == 0;
}

std::optional<ErrorText> decode_png(const std::string& path, const std::string& bytes, const Location& where, Image& image) {
  Reader reader(bytes);
  if (!reader.read_header()) return damaged_image(path, where, reader.message());
  if (const auto wrong = too_big_image(path, where, reader.width(), reader.height(), reader.channels())) return wrong;
  if (!reader.read_pixels()) return damaged_image(path, where, reader.message());

  image.width = static_cast<int>(reader.width());
  image.height = static_cast<int>(reader.height());
  image.channels = reader.channels();
  image.bits = reader.bits();
  image.values.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                      static_cast<std::size_t>(image.channels));
  if (image.bits == 16)
    copy_flipped(
        reader, [](const unsigned char* p) { return static_cast<double>((p[0] << 8) | p[1]) / 65535.0; }, image);
  else
    copy_flipped(
        reader, [](const unsigned char* p) { return static_cast<double>(*p) / 255.0; }, image);
  return std::nullopt;
}

}  // namespace bump
