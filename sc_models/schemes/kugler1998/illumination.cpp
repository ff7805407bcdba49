#include "schemes/kugler1998/illumination.h"

#include <algorithm>
#include <cmath>

#include "schemes/common/light_tables.h"
#include "schemes/common/trigonometric_tables.h"
#include "schemes/common/vectors.h"
#include "schemes/kugler1998/tables.h"

namespace bump::kugler1998 {

namespace {

constexpr int object_bits = 8;  // objects whose maps an address can tell apart

/// Bits of a coordinate in [-1, 1] as an address field `low` bits above the address's last.
Wire address_field(Netlist& n, const std::string& name, Wire coordinate, int bits, int low) {
  const Format code = sfixed(bits, bits - 1);
  const Wire bounded = n.clamp(name + "_code", coordinate, -1, code.highest(), code);
  return n.shift(name + "_field", bounded, bits - 1 + low, ufixed(bits, -low));
}

/// Heidrich and Seidel's paraboloid (1998), one for each hemisphere: (x, y) / (1 + |z|).
Netlist address_unit(const KuglerParameters& p) {
  Netlist n("address");
  const int w = p.word_bits, rows = p.row_bits(), columns = p.column_bits();
  const int trigonometric_bits = std::min(p.table_bits, p.angle_bits - 2);
  const TablePtr sine = sine_table("SIN", p.turn(), trigonometric_bits, w), cosine = cosine_table("COS", p.turn(), trigonometric_bits, w);
  const Wire theta = n.input("bumped.theta", p.turn()), phi = n.input("bumped.phi", p.turn());
  Netlist::Label label(n, "sin, cos of theta', phi'");
  const Wire sine_theta = n.table("SIN_theta", sine, theta).front(), z = n.table("COS_theta", cosine, theta).front();
  const Wire sine_phi = n.table("SIN_phi", sine, phi).front(), cosine_phi = n.table("COS_phi", cosine, phi).front();
  label.next("x, y of theta', phi'");
  const Wire x = n.mul("x", sine_theta, cosine_phi, n.format(z)), y = n.mul("y", sine_theta, sine_phi, n.format(z));
  const TablePtr reciprocal = paraboloid_table(p);
  label.next("q = 1 / (1 + abs z)");
  const Wire sum = n.add("one_plus_z", n.absolute("abs_z", z, ufixed(w, w)), n.constant("one", 1, ufixed(1, 0)), reciprocal->index);
  const Wire q = n.table("RECIP_1", reciprocal, sum).front();
  const Format coordinate = sfixed(w + 2, w);
  label.next("s = x q, t = y q");
  const Wire s = n.mul("s", x, q, coordinate), t = n.mul("t", y, q, coordinate);
  label.next("base + (hemisphere, t, s)");
  const Wire below = n.is_negative("below", z);

  const Wire hemisphere = n.shift("hemisphere", below, rows + columns, ufixed(1, -rows - columns));
  const Wire row = n.join("row", hemisphere, address_field(n, "t", t, rows, columns), ufixed(rows + 1, -columns));
  const Wire entry = n.join("entry", row, address_field(n, "s", s, columns, 0), ufixed(p.light_map_bits, 0));
  const Format address = ufixed(p.light_map_bits + object_bits, 0);
  n.output("light_map.entry", n.add("address", n.input("light_map.base", address), entry, address));
  n.output("light_map.s", s);
  n.output("light_map.t", t);
  n.output("light_map.below", below);
  return n;
}

/// Of the paraboloid of the hemisphere: beyond the rim it goes on into the other one.
glm::dvec3 direction_of(const double* coordinates) {
  const double s = coordinates[0], t = coordinates[1], squared = s * s + t * t;
  const double z = (1 - squared) / (1 + squared);
  return {2 * s / (1 + squared), 2 * t / (1 + squared), coordinates[2] != 0 ? -z : z};
}

/// The value of a two's complement field, in the middle of its step, in [-1, 1].
double field_value(std::int64_t field, int bits) {
  const std::int64_t half = std::int64_t{1} << (bits - 1);
  return (static_cast<double>(field < half ? field : field - 2 * half) + 0.5) / static_cast<double>(half);
}

TablePtr power_table(const Material& material) {
  Table table;
  table.name = "POWER";
  table.formula = "x^n";
  table.index = real();
  table.per_material = true;
  Column column;
  column.name = "value";
  column.function = [exponent = material.shininess](double x) { return x > 0 ? std::pow(x, exponent) : 0.0; };
  column.format = real();
  table.columns = {column};
  return std::make_shared<const Table>(table);
}

Netlist fill_program(const Material& material) {
  Netlist n("frame");
  const VectorWires normal = input_vector(n, "N", real()), light = input_vector(n, "L", real()), half = input_vector(n, "H", real());
  const auto lit = [&](const std::string& name, const VectorWires& v) {
    return n.clamp(name + "_lit", dot_product(n, name, normal, v, real(), real()), 0, 1, real());
  };
  n.output("diffuse", n.mul("diffuse", n.constant("kd", material.diffuse, real()), lit("N_L", light), real()));
  n.output("specular", n.table("POWER", power_table(material), lit("N_H", half)).front());
  return n;
}

}  // namespace

LightMaps light_maps(const KuglerParameters& p, const Material& material) {
  LightMaps maps;
  maps.maps = {{"diffuse", p.light_word()}, {"specular", p.light_word()}};
  maps.address_bits = p.light_map_bits;
  maps.column_bits = p.column_bits();
  maps.address = address_unit(p);
  maps.coordinates = {"light_map.s", "light_map.t", "light_map.below"};
  maps.direction = direction_of;
  maps.centre = [rows = p.row_bits(), columns = p.column_bits()](std::int64_t entry, double* coordinates) {
    coordinates[0] = field_value(entry & ((std::int64_t{1} << columns) - 1), columns);
    coordinates[1] = field_value((entry >> columns) & ((std::int64_t{1} << rows) - 1), rows);
    coordinates[2] = static_cast<double>(entry >> (rows + columns));
  };
  maps.fill = fill_program(material);
  return maps;
}

Netlist illumination_unit(const KuglerParameters& p, const Material& material) {
  Netlist n("illumination");
  const Format word = p.light_word(), sum = ufixed(15 + p.light_integer_bits + 5, 15);
  const Wire diffuse = n.input("light.diffuse", word), specular = n.input("light.specular", word);
  const Netlist::Label label(n, "intensity = D + ks S");
  const Wire gain = n.constant("ks", material.specular, ufixed(16, 12));
  n.output("intensity", n.add("intensity", diffuse, n.mul("shine", specular, gain, sum), sum));
  return n;
}

}  // namespace bump::kugler1998
