#pragma once
// Unsigned numbers as bytes of a trace: seven bits to a byte, low ones first, the top bit says that more follow. No hardware.

#include <cstdint>
#include <string>

namespace bump {

inline void put_number(std::string& bytes, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>((value & 0x7f) | 0x80);
  bytes += static_cast<char>(value);
}

/// Signed numbers of small magnitude as small unsigned ones: 0, -1, 1, -2, 2 ... become 0, 1, 2, 3, 4.
inline std::uint64_t folded_sign(std::int64_t value) {
  return (static_cast<std::uint64_t>(value) << 1) ^ (value < 0 ? ~std::uint64_t{0} : std::uint64_t{0});
}
inline std::int64_t unfolded_sign(std::uint64_t value) {
  return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
}

}  // namespace bump
