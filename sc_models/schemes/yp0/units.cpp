#include "schemes/yp0/units.h"

#include <utility>
#include <vector>

#include "schemes/common/sums_projection.h"

namespace bump::yp0 {

namespace {

/// The reads of cc(x, y), or ss(x, y): 2 adders, 2 tables. The caller sums.
class Pairs {
 public:
  explicit Pairs(SineReads& reads) : reads_(reads) {}
  std::vector<Wire> cc(const std::string& of, Wire x, Wire y) {
    const Wire sum = reads_.plus(of + "_plus", x, y), difference = reads_.minus(of + "_less", x, y);
    const Wire first = reads_.cosine("COS_" + of + "_plus", sum);
    return {first, reads_.cosine("COS_" + of + "_less", difference)};
  }
  std::vector<Wire> ss(const std::string& of, Wire x, Wire y) {
    const Wire sum = reads_.plus(of + "_plus", x, y), difference = reads_.minus(of + "_less", x, y);
    const Wire first = reads_.sine("SIN_" + of + "_plus", sum);
    return {first, reads_.sine("SIN_" + of + "_less", difference)};
  }

 private:
  SineReads& reads_;
};

std::vector<Wire> joined(std::vector<Wire> a, const std::vector<Wire>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

Format dot_format(const YPoleParameters& p) {
  return sfixed(p.word_bits + 5, p.word_bits + 3);
}

Netlist environment_unit(const YPoleParameters& p) {
  Netlist n("environment");
  SineReads r(n, p.sums());
  Pairs pairs(r);
  const PolarDirection normal = input_polar(n, "N", r), light = input_polar(n, "L", r), half = input_polar(n, "H", r);
  const YPoleWires texel = y_pole_texel(n, p, p.turn());
  const Wire b = texel.latitude, Psi = r.plus("N.Psi", texel.psi, normal.theta, "YP6 step 3");
  for (const auto& [name, a] : {std::pair<std::string, PolarDirection>{"L", light}, {"H", half}}) {
    const Netlist::Scope scope(n, "N_" + name);
    const Wire theta = a.theta, d = r.minus("d", a.phi, normal.phi, "Lee Eq 6");
    Netlist::Label label(n, "YP4 step 2");
    const Wire u = r.minus("u", theta, Psi), v = r.plus("v", theta, Psi);
    label.next("YP0 step 2");
    const Wire E = r.minus("E", d, b), F = r.plus("F", d, b);
    const std::vector<Wire> u_E = pairs.cc("u_E", u, E), u_F = pairs.cc("u_F", u, F), v_E = pairs.cc("v_E", v, E),
                            v_F = pairs.cc("v_F", v, F);
    label.next("YP0 step 1");
    const std::vector<Wire> u_b = pairs.cc("u_b", u, b), v_b = pairs.cc("v_b", v, b);
    label.next("YP0 step 3");
    const std::vector<Wire> theta_E = pairs.ss("theta_E", theta, E), theta_F = pairs.ss("theta_F", theta, F);
    const Wire eighths = r.sum("eighths", joined(u_E, u_F), joined(v_E, v_F), 3, "YP0");
    const Wire quarters = r.sum("quarters", joined(joined(u_b, v_b), theta_E), theta_F, 2, "YP0");
    n.add("dot", eighths, quarters, dot_format(p), "YP0");
  }
  n.output("L_turned.dot", Wire{n.find("N_L.dot")});
  n.output("H_turned.dot", Wire{n.find("N_H.dot")});
  return n;
}

Netlist illumination_unit(const YPoleParameters& p, const Material& material) {
  Netlist n("illumination");
  const Wire n_l = n.input("L_turned.dot", dot_format(p)), n_h = n.input("H_turned.dot", dot_format(p));
  output_intensity(n, n_l, n_h, p, material);
  return n;
}

}  // namespace bump::yp0
