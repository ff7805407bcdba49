#pragma once
// libpng reports an error by a call that must not return, and a C++ exception must not cross its frames: the call leaves a message and
// jumps back. No model of hardware. Source: libpng manual, section "Setup" (libpng(3)).

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>

namespace bump {

/// The error pointer of a libpng struct.
struct PngMessage {
  std::array<char, 200> text{};
};

[[noreturn]] inline void leave_png_message(png_structp png, png_const_charp text) {
  auto& message = *static_cast<PngMessage*>(png_get_error_ptr(png));
  const std::size_t length = std::min(std::strlen(text), message.text.size() - 1);
  std::memcpy(message.text.data(), text, length);
  message.text[length] = '\0';
  png_longjmp(png, 1);
}

/// Warnings are of parts that no pixel depends on.
inline void ignore_png_warning(png_structp, png_const_charp) {}

/// False if libpng found an error in `work`, which must hold no object that needs its destructor when it calls libpng.
template <class Work>
bool guarded_png(png_structp png, const Work& work) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  work();
  return true;
}

}  // namespace bump
