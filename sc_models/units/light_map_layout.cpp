#include "units/light_map_layout.h"

#include <algorithm>

namespace bump {

LightMapLayout::LightMapLayout(const LightMaps& maps, int line_bytes)
    : column_bits_(maps.column_bits > 0 ? maps.column_bits : maps.address_bits / 2) {
  const auto line = static_cast<std::uint64_t>(line_bytes);
  const int row_bits = maps.address_bits - column_bits_;
  for (const LightMaps::Map& map : maps.maps) {
    Place place;
    place.base = object_bytes_;
    while ((8 << place.byte_bits) < map.word.width) ++place.byte_bits;
    int tile_bits = 0;  // words of a line, as a power of two
    while ((std::uint64_t{2} << (tile_bits + place.byte_bits)) <= line) ++tile_bits;
    place.tile_columns = std::min((tile_bits + 1) / 2, column_bits_);
    place.tile_rows = std::min(tile_bits - place.tile_columns, row_bits);
    place.tile_columns = std::min(tile_bits - place.tile_rows, column_bits_);
    places_.push_back(place);
    const std::uint64_t bytes = std::uint64_t{1} << (maps.address_bits + place.byte_bits);
    object_bytes_ += (bytes + line - 1) / line * line;
  }
}

}  // namespace bump
