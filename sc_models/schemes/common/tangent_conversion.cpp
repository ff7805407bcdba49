#include "schemes/common/tangent_conversion.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "schemes/common/vectors.h"

namespace bump {

namespace {

constexpr double two_pi = 6.283185307179586476925;
constexpr double smallest = 1e-300;  // keeps the double evaluation finite; a word saturates long before
/// Quotients are indexed by s in binades up to [2^3, 2^4). Below the lowest, [2^-4, 2^-3) or in large tables [2^-12, 2^-11), its first word
/// serves: an error of at most 0.35 times its lower end, in radians.
int binade_bits(const TangentConversion& widths) {
  return widths.inverse_table_bits < 8 ? 3 : 4;
}

class Conversion {
 public:
  Conversion(Netlist& netlist, const TangentConversion& widths)
      : n_(netlist),
        component_(sfixed(widths.component_bits, widths.component_bits - 1)),
        log_(ufixed(whole_bits(widths) + fraction(widths), fraction(widths))),
        difference_(sfixed(log_.width + 1, log_.fraction)),
        exponent_(ufixed(log_.width + 2, log_.fraction)),
        angle_(widths.angle) {
    Table log = one_index("LOG", "-log2 |x|", component_, component_.width - 1);
    log.folding = Folding::magnitude;
    log.columns = {column("log", log_, [](double x) { return -std::log2(std::max(std::abs(x), smallest)); })};
    logarithm_ = std::make_shared<const Table>(log);
    const Column angle =
        column("angle", uangle(angle_.width - 3, angle_.width), [](double s) { return std::atan(std::exp2(-s)) / two_pi; });
    Table arc_tangent = one_index("ATAN_POWER", "atan(2^-x) / 2 pi", exponent_, widths.inverse_table_bits);
    arc_tangent.folding = Folding::floating;
    arc_tangent.exponent_bits = binade_bits(widths);
    arc_tangent.min_exponent = 4 - (1 << arc_tangent.exponent_bits);
    arc_tangent.columns = {angle};
    arc_tangent_ = std::make_shared<const Table>(arc_tangent);
    Table polar = arc_tangent;
    polar.name = "POLAR_POWER";
    polar.formula = "atan(2^-x) / 2 pi, log2(1 + 2^-2x) / 2";
    polar.columns = {
        angle, column("longer", ufixed(log_.fraction, log_.fraction), [](double s) { return 0.5 * std::log2(1 + std::exp2(-2 * s)); })};
    polar_ = std::make_shared<const Table>(polar);
  }

  void convert(const std::string& name) {
    const VectorWires v = input_vector(n_, name, component_);
    const Netlist::Scope scope(n_, name);
    Netlist::Label label(n_, "logarithms of x, y, z");
    const Wire x = n_.table("LOG_x", logarithm_, v.x).front(), y = n_.table("LOG_y", logarithm_, v.y).front(),
               z = n_.table("LOG_z", logarithm_, v.z).front();
    label.next("s = |lx - lz|");
    const Wire x_less_z = n_.sub("x_less_z", x, z, difference_);
    const Wire s = exponent("s", x_less_z);
    label.next("psi from atan 2^-s");
    const std::vector<Wire> polar = n_.table("POLAR", polar_, s);
    // Of |x| > |z| the logarithm of x is the smaller.
    const Wire steep = n_.is_negative("is_steep", x_less_z);
    label.next("-log2 sqrt(x^2 + z^2)");
    const Wire longer = n_.select("longer", steep, x, z, log_);
    const Wire distance = n_.sub("distance", longer, polar[1], difference_);
    label.next("psi from atan 2^-s");
    const Wire octant = n_.shift("octant", polar[0], 0, angle_);
    const Wire quadrant = quarter_less_if("quadrant", steep, octant);
    const Wire half_turn = n_.half_turn("opposite", n_.negate("minus", quadrant, angle_));
    const Wire upper = n_.select("upper", n_.is_negative("z_negative", v.z), half_turn, quadrant, angle_);
    n_.output("psi", signed_as("psi", v.x, upper));
    label.next("b from atan 2^-t");
    const Wire y_less = n_.sub("y_less_distance", y, distance, wide(difference_));
    const Wire rise = n_.shift("rise", n_.table("ATAN", arc_tangent_, exponent("t", y_less)).front(), 0, angle_);
    n_.output("b", signed_as("b", v.y, quarter_less_if("latitude", n_.is_negative("is_high", y_less), rise)));
  }

 private:
  /// Where atan 2^-s is steepest, at 0, a turn changes by 0.055 of s: four bits fewer than an angle of the same resolution would take.
  static int fraction(const TangentConversion& widths) { return widths.component_bits - 3; }
  /// For the least component; 0 counts as one that is smaller yet.
  static int whole_bits(const TangentConversion& widths) { return widths.component_bits <= 8 ? 3 : 4; }
  static Table one_index(const std::string& name, const std::string& formula, const Format& index, int address_bits) {
    Table table;
    table.name = name;
    table.formula = formula;
    table.index = index;
    table.address_bits = address_bits;
    return table;
  }
  static Column column(const std::string& name, const Format& format, RealFunction function) {
    Column column;
    column.name = name;
    column.function = std::move(function);
    column.format = format;
    return column;
  }
  static Format wide(const Format& f) { return sfixed(f.width + 1, f.fraction); }

  Wire exponent(const std::string& name, Wire difference) { return n_.absolute(name, difference, exponent_); }
  Wire quarter_less_if(const std::string& name, Wire flag, Wire octant) {
    const Wire rest = n_.sub(name + "_rest", n_.constant(name + "_quarter", 0.25, angle_), octant, angle_);
    return n_.select(name, flag, rest, octant, angle_);
  }
  Wire signed_as(const std::string& name, Wire component, Wire angle) {
    const Wire lower = n_.negate(name + "_lower", angle, angle_);
    return n_.select(name + "_signed", n_.is_negative(name + "_negative", component), lower, angle, angle_);
  }

  Netlist& n_;
  Format component_, log_, difference_, exponent_, angle_;
  TablePtr logarithm_, arc_tangent_, polar_;
};

}  // namespace

Netlist tangent_conversion_unit(const TangentConversion& widths) {
  Netlist n("conversion");
  Conversion conversion(n, widths);
  conversion.convert("L");
  conversion.convert("H");
  return n;
}

}  // namespace bump
