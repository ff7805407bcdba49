#include "testbench/experiments/price_component.h"

#include <array>

namespace bump {

namespace {

struct About {
  const char* name;
  std::vector<std::string> sizes;
  Component general;
  CostGroup group;
};

const About& about(Component component) {
  using C = Component;
  using G = CostGroup;
  static const std::array<About, static_cast<std::size_t>(C::count)> all = {{
      {"adder", {"width"}, C::adder, G::adders},
      {"constant_adder", {"width"}, C::adder, G::adders},
      {"adder_subtractor", {"width"}, C::adder_subtractor, G::adders},
      {"constant_adder_subtractor", {"width"}, C::adder_subtractor, G::adders},
      {"multiplier", {"first", "second"}, C::multiplier, G::multipliers},
      {"squarer", {"width"}, C::multiplier, G::multipliers},
      {"constant_multiplier", {"first", "second"}, C::multiplier, G::multipliers},
      {"divider", {"rows", "width"}, C::divider, G::dividers},
      {"square_root", {"rows", "width"}, C::square_root, G::dividers},
      {"clamp", {"width"}, C::clamp, G::logic},
      {"select", {"width"}, C::select, G::logic},
      {"negate", {"width"}, C::negate, G::logic},
      {"shifter", {"width", "places"}, C::shifter, G::logic},
      {"index_encoder", {"binades", "word"}, C::index_encoder, G::logic},
      {"table", {"entries", "word", "columns", "changes"}, C::table, G::tables},
      {"line_table", {"entries", "word", "columns", "changes"}, C::table, G::tables},
      {"map", {"entries", "word", "columns", "changes"}, C::table, G::tables},
      {"second_port", {"entries", "word", "columns", "changes"}, C::second_port, G::tables},
      {"register", {}, C::register_bits, G::registers},
      {"float_adder", {}, C::float_adder, G::adders},
      {"float_multiplier", {}, C::float_multiplier, G::multipliers},
      {"float_divider", {}, C::float_divider, G::dividers},
      {"float_square_root", {}, C::float_square_root, G::dividers},
      {"float_select", {}, C::float_select, G::logic},
      {"cache_read", {"bytes"}, C::cache_read, G::memory},
      {"memory_byte", {}, C::memory_byte, G::memory},
  }};
  return all[static_cast<std::size_t>(component)];
}

}  // namespace

const char* name_of(Component component) {
  return about(component).name;
}
const std::vector<std::string>& sizes_of(Component component) {
  return about(component).sizes;
}
bool has_width(Component component) {
  return !sizes_of(component).empty() && sizes_of(component).front() == "width";
}
Component general(Component component) {
  return about(component).general;
}
CostGroup group_of(Component component) {
  return about(component).group;
}

const char* name_of(CostGroup group) {
  static const std::array<const char*, static_cast<std::size_t>(CostGroup::count)> names = {"multipliers", "adders", "dividers", "tables",
                                                                                            "registers",   "logic",  "memory"};
  return names[static_cast<std::size_t>(group)];
}

}  // namespace bump
