#include "schemes/exact_polar/rotation.h"

#include <utility>

#include "schemes/common/polar_map.h"

namespace bump::exact_polar {

namespace {

constexpr int guard_bits = 2;  // of products before they are summed
constexpr const char* sine_cosine_label = "sin, cos of theta_A, d, theta_N";

void rotate(Netlist& n, const std::string& name, const PolarDirection& a, const PolarDirection& normal, const std::vector<Wire>& of_normal,
            const RotationParameters& p, const RotationTables& t) {
  const int fraction = p.word_bits + guard_bits;
  const Format product = sfixed(fraction + 1, fraction), sum = sfixed(fraction + 2, fraction);
  Wire x, y, z;
  {
    const Netlist::Scope scope(n, name);
    Netlist::Label label(n, sine_cosine_label);
    const std::vector<Wire> of_theta = n.table("SC_THETA", t.sine_cosine, a.theta);
    const std::vector<Wire> of_d = n.table("SC_D", t.sine_cosine, n.sub("d", a.phi, normal.phi, p.input_angle(), "d = phi_A - phi_N"));
    // Rz(-phi_N)
    const Wire s = n.mul("s", of_theta[0], of_d[1], product, "s = sin theta_A cos d");
    y = n.mul("y_prime", of_theta[0], of_d[0], product, "y' = sin theta_A sin d");
    // Ry(-theta_N)
    const char* const x_label = "x' = s cos theta_N - ...";
    label.next(x_label);
    const Wire s_cos = n.mul("s_cos", s, of_normal[1], product), cos_sin = n.mul("cos_sin", of_theta[1], of_normal[0], product);
    label.next("z' = s sin theta_N + ...");
    const Wire s_sin = n.mul("s_sin", s, of_normal[0], product), cos_cos = n.mul("cos_cos", of_theta[1], of_normal[1], product);
    x = n.sub("x_prime", s_cos, cos_sin, sum, x_label);
    z = n.add("z_prime", s_sin, cos_cos, sum);
  }
  output_reference(n, name, x, y, z, p, t);
}

}  // namespace

Netlist environment_unit(const RotationParameters& p) {
  Netlist n("environment");
  const PolarDirection normal = input_direction(n, "N", p.input_angle()), light = input_direction(n, "L", p.input_angle()),
                       half = input_direction(n, "H", p.input_angle());
  const RotationTables tables = rotation_tables(p);
  const std::vector<Wire> of_normal = n.table("N.SC", tables.sine_cosine, normal.theta, sine_cosine_label);
  for (const auto& [name, a] : {std::pair<std::string, PolarDirection>{"L", light}, {"H", half}})
    rotate(n, name, a, normal, of_normal, p, tables);
  output_map_angles(n, p);
  return n;
}

}  // namespace bump::exact_polar
