#include "schemes/common/light_tables.h"

#include <algorithm>
#include <cmath>

#include "datapath/real_tables.h"

namespace bump {

namespace {

TablePtr light_table(const std::string& name, const std::string& formula, const Format& index, int address_bits, int word_bits,
                     RealFunction function, BlockFunction block) {
  Table table;
  table.name = name;
  table.formula = formula;
  table.index = index;
  table.address_bits = address_bits;
  table.per_material = true;
  Column column;
  column.name = "intensity";
  column.function = std::move(function);
  column.format = light_format(word_bits);
  table.columns.push_back(column);
  if (!index.is_real) table.block = std::move(block);  // light of vertices becomes words of the hardware: the bits of the C library
  return std::make_shared<const Table>(table);
}

}  // namespace

Format light_format(int word_bits) {
  return ufixed(word_bits, word_bits - 1);
}
Format intensity_format(int word_bits) {
  return ufixed(word_bits + 1, word_bits - 1);
}
Format clamped_dot_format(int fraction) {
  return ufixed(fraction, fraction);
}

TablePtr diffuse_table(const Format& index, int address_bits, const Material& material, int word_bits) {
  return light_table(
      "DIFF", "kd x", index, address_bits, word_bits, [kd = material.diffuse](double x) { return kd * x; },
      real_tables::proportion(material.diffuse));
}

TablePtr specular_table(const Format& index, int address_bits, const Material& material, int word_bits) {
  return light_table(
      "SPEC", "ks x^n", index, address_bits, word_bits,
      [ks = material.specular, n = material.shininess](double x) { return x > 0 ? ks * std::pow(x, n) : 0.0; },
      real_tables::scaled_power(material.specular, material.shininess));
}

double angular_slope(const Material& material) {
  return material.diffuse + 0.61 * material.specular * std::sqrt(std::max(1.0, material.shininess));
}

double light_table_error(const Material& material, int address_bits) {
  return std::ldexp(material.diffuse + material.specular * std::max(1.0, material.shininess), -address_bits - 1);
}

double light_word_floor_db(double floor_db, int word_bits) {
  if (word_bits >= default_light_word_bits) return floor_db;
  // Half a step each of the diffuse and the specular word.
  return std::max(3.0, -20 * std::log10(std::pow(10.0, -floor_db / 20) + std::ldexp(1.0, 1 - word_bits)));
}

Wire clamp_dot(Netlist& n, const std::string& name, Wire dot, int fraction) {
  return n.clamp(name, dot, 0, 1, clamped_dot_format(fraction));
}

}  // namespace bump
