#pragma once
// Where the words of light maps lie in memory: whole bytes, a power of two of them a word, map after map, object after object. Within a map
// the bits of an entry are permuted so that a line holds a tile of neighbouring rows and columns: wiring, no operator. Two maps of 2^20 x 8
// bit are two arrays of 1 MB, and each has a look-up of its own (they are not interleaved into one record). Addresses only; no time.
// Source: Kugler 1998 as Lee 2007 describes it; tiles as Hakura and Gupta, ISCA 1997.

#include <cstdint>
#include <vector>

#include "schemes/scheme.h"

namespace bump {

class LightMapLayout {
 public:
  /// `line_bytes`: a power of two.
  LightMapLayout(const LightMaps& maps, int line_bytes);

  /// Byte address of a word; 0 <= entry < 2^address_bits within the object's map.
  std::uint64_t address(int object, int map, std::int64_t entry) const {
    const Place& place = places_[static_cast<std::size_t>(map)];
    const auto at = static_cast<std::uint64_t>(entry);
    const std::uint64_t column = at & mask(column_bits_), row = at >> column_bits_;
    const std::uint64_t in_tile = (column & mask(place.tile_columns)) | ((row & mask(place.tile_rows)) << place.tile_columns);
    const std::uint64_t tile = (column >> place.tile_columns) | ((row >> place.tile_rows) << (column_bits_ - place.tile_columns));
    const std::uint64_t word = in_tile | (tile << (place.tile_columns + place.tile_rows));
    return static_cast<std::uint64_t>(object) * object_bytes_ + place.base + (word << place.byte_bits);
  }
  /// Low bits of an entry that are its column.
  int column_bits() const { return column_bits_; }
  /// Bytes of a word of `map`.
  int word_bytes(int map) const { return 1 << places_[static_cast<std::size_t>(map)].byte_bits; }

 private:
  /// One map: bytes of a word, and rows and columns of a tile, all as powers of two.
  struct Place {
    std::uint64_t base = 0;
    int byte_bits = 0, tile_columns = 0, tile_rows = 0;
  };
  static std::uint64_t mask(int bits) { return (std::uint64_t{1} << bits) - 1; }

  std::vector<Place> places_;
  int column_bits_ = 0;
  std::uint64_t object_bytes_ = 0;
};

}  // namespace bump
