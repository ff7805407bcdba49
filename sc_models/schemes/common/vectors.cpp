#include "schemes/common/vectors.h"

#include <algorithm>
#include <cmath>

#include "datapath/real_tables.h"

namespace bump {

namespace {

/// |v|^2: 3 multipliers, 2 adders.
Wire squared_length(Netlist& n, const VectorWires& v, const NormaliserFormats& f) {
  const Wire xx = n.mul("xx", v.x, v.x, f.square);
  const Wire yy = n.mul("yy", v.y, v.y, f.square);
  const Wire zz = n.mul("zz", v.z, v.z, f.square);
  return n.add("squared", n.add("xx_yy", xx, yy, f.sum), zz, f.sum);
}

constexpr int root_exponent_bits = 3, root_lowest_exponent = -7;  // binades [2^-7, 2): interpolated unit vectors and filtered texels

TablePtr reciprocal_root_table(const Format& squared, int address_bits, int words) {
  Table table;
  table.name = "RECIPROCAL_ROOT";
  table.formula = "1 / sqrt(x)";
  table.index = squared;
  table.folding = Folding::floating;
  table.address_bits = address_bits;
  table.exponent_bits = root_exponent_bits;
  table.min_exponent = root_lowest_exponent;
  Column column;
  column.name = "value";
  // Finite at 0: what the lowest address would give.
  column.function = [](double x) { return 1.0 / std::sqrt(std::max(x, std::ldexp(1.0, root_lowest_exponent))); };
  column.format = ufixed(words, words - 4);  // up to sqrt(128) = 11.3
  table.columns.push_back(column);
  table.block = real_tables::reciprocal_root(std::ldexp(1.0, root_lowest_exponent));
  return std::make_shared<const Table>(table);
}

}  // namespace

VectorWires input_vector(Netlist& n, const std::string& name, const Format& format) {
  return {n.input(name + ".x", format), n.input(name + ".y", format), n.input(name + ".z", format)};
}

void output_vector(Netlist& n, const std::string& name, const VectorWires& v) {
  n.output(name + ".x", v.x);
  n.output(name + ".y", v.y);
  n.output(name + ".z", v.z);
}

Wire dot_product(Netlist& n, const std::string& name, const VectorWires& a, const VectorWires& b, const Format& product, const Format& sum,
                 const std::string& equation) {
  const Wire x = n.mul(name + "_x", a.x, b.x, product, equation);
  const Wire y = n.mul(name + "_y", a.y, b.y, product, equation);
  const Wire z = n.mul(name + "_z", a.z, b.z, product, equation);
  return n.add(name, n.add(name + "_xy", x, y, sum, equation), z, sum, equation);
}

VectorWires cross_product(Netlist& n, const std::string& name, const VectorWires& a, const VectorWires& b, const Format& product,
                          const Format& difference, const std::string& equation) {
  const Netlist::Scope scope(n, name);
  const auto minor = [&](const std::string& component, Wire a1, Wire b2, Wire a2, Wire b1) {
    const Wire first = n.mul(component + "_1", a1, b2, product, equation), second = n.mul(component + "_2", a2, b1, product, equation);
    return n.sub(component, first, second, difference, equation);
  };
  return {minor("x", a.y, b.z, a.z, b.y), minor("y", a.z, b.x, a.x, b.z), minor("z", a.x, b.y, a.y, b.x)};
}

VectorWires sum_of_vectors(Netlist& n, const std::string& name, const VectorWires& a, const VectorWires& b, const Format& format) {
  const Netlist::Scope scope(n, name);
  return {n.add("x", a.x, b.x, format), n.add("y", a.y, b.y, format), n.add("z", a.z, b.z, format)};
}

VectorWires normalise(Netlist& n, const std::string& name, const VectorWires& v, const NormaliserFormats& f, double shortest) {
  const Netlist::Scope scope(n, name);
  const Wire root = n.sqrt("root", squared_length(n, v, f), f.length);
  const Wire length = n.clamp("length", root, shortest, f.length.is_real ? 1e300 : f.length.highest(), f.length);
  return {n.div("x", v.x, length, f.quotient), n.div("y", v.y, length, f.quotient), n.div("z", v.z, length, f.quotient)};
}

VectorWires normalise_by_table(Netlist& n, const std::string& name, const VectorWires& v, const NormaliserFormats& f, int address_bits,
                               int words) {
  const Netlist::Scope scope(n, name);
  const Wire scale = n.table("RECIPROCAL_ROOT", reciprocal_root_table(f.sum, address_bits, words), squared_length(n, v, f)).front();
  return {n.mul("x", v.x, scale, f.quotient), n.mul("y", v.y, scale, f.quotient), n.mul("z", v.z, scale, f.quotient)};
}

VectorWires normalise_vertex(Netlist& n, const std::string& name, const VectorWires& v) {
  return normalise(n, name, v, {real(), real(), real(), real()}, 1e-150);
}

VectorWires half_vector(Netlist& n, const std::string& name, const VectorWires& unit_light, const VectorWires& unit_view) {
  return sum_of_vectors(n, name, unit_light, unit_view, real());
}

}  // namespace bump
