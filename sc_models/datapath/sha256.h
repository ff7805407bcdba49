#pragma once
// SHA-256, to name the exact bytes of inputs and of ROM images in results. Not for secrets. Source: FIPS 180-4.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace bump {

class Sha256 {
 public:
  void update(const void* data, std::size_t size);
  /// 64 lower-case hexadecimal digits of everything so far. Further updates continue as if it had not been asked.
  std::string hex() const;

 private:
  void take_block(const unsigned char* block);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> pending_{};
  std::size_t pending_size_ = 0;
  std::uint64_t size_ = 0;
};

std::string sha256_hex(const void* data, std::size_t size);

}  // namespace bump
