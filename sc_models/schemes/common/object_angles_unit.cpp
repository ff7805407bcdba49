#include "schemes/common/object_angles_unit.h"

#include <utility>

#include "schemes/common/polar_rotation.h"

namespace bump {

void declare_object_angles_parameters(Parameters& p, const std::string& id) {
  declare_y_pole_parameters(p, id);
  p.choice(id + ".form", "11", {"11", "13"}, "adders of the illumination unit: 11 as in Table 1 of Lee 2007, 13 as in its section 5.2");
}

ObjectAnglesParameters read_object_angles_parameters(const Configuration& c, const std::string& id) {
  ObjectAnglesParameters p;
  static_cast<YPoleParameters&>(p) = read_y_pole_parameters(c, id);
  p.form = c.choice(id + ".form") == "11" ? 11 : 13;
  return p;
}

Netlist object_angles_illumination(const ObjectAnglesParameters& p, const Material& material) {
  Netlist n("illumination");
  const PolarDirection normal = input_direction(n, "N_object", p.inner_angle()), light = input_direction(n, "L", p.input_angle()),
                       half = input_direction(n, "H", p.input_angle());
  const LawOfCosines form = p.illumination();
  const CosineTables tables = cosine_tables(form);
  const auto dot = [&](const std::string& name, const PolarDirection& a, const std::string& equation) {
    const Netlist::Scope scope(n, name);
    return law_of_cosines(n, a.phi, a.theta, normal.phi, normal.theta, form, tables, equation);
  };
  const Wire n_l = dot("N_L", light, "Lee Eq 24"), n_h = dot("N_H", half, "Lee Eq 25");
  output_intensity(n, n_l, n_h, p, material);
  return n;
}

Design object_angles_design(const ObjectAnglesParameters& p, Netlist environment, const Material& material) {
  return y_pole_design(p, std::move(environment), object_angles_illumination(p, material), material);
}

}  // namespace bump
