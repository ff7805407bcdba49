#include "schemes/kim2001/illumination.h"

#include "schemes/common/light_tables.h"
#include "schemes/common/trigonometric_tables.h"

namespace bump::kim2001 {

namespace {

struct SineCosine {
  Wire sine, cosine;
};

class DotProducts {
 public:
  DotProducts(Netlist& netlist, const KimParameters& p) : n(netlist), p_(p) {
    sine_ = sine_table("SIN", p.inner_angle(), p.table_bits, p.word_bits);
    cosine_ = cosine_table("COS", p.inner_angle(), p.table_bits, p.word_bits);
    both_ = sine_cosine_table("SC_INNER", p.inner_angle(), p.table_bits, p.word_bits);
  }

  SineCosine read(const std::string& name, Wire theta) {
    if (p_.tables == Tables::separate)
      return {n.table("SIN_" + name, sine_, theta).front(), n.table("COS_" + name, cosine_, theta).front()};
    const std::vector<Wire> columns = n.table("SC_" + name, both_, theta);
    return {columns[0], columns[1]};
  }

  /// N'.V, in [-1, 1].
  Wire dot(const SineCosine& of_vector, const SineCosine& of_normal, Wire phi_difference) {
    const Format product = sfixed(p_.word_bits + 3, p_.word_bits + 2), sum = sfixed(p_.word_bits + 4, p_.word_bits + 2);
    const Wire cosine = n.table("COS_PHI", cosine_, phi_difference).front();
    const Wire along = n.mul("cosines", of_vector.cosine, of_normal.cosine, product);
    const Wire sines = n.mul("sines", of_vector.sine, of_normal.sine, product);
    return n.add("dot", along, n.mul("across", sines, cosine, product), sum);
  }

 private:
  Netlist& n;
  const KimParameters& p_;
  TablePtr sine_, cosine_, both_;
};

struct Direction {
  Wire phi, theta;
};

}  // namespace

Netlist illumination_unit(const KimParameters& p, const Material& material) {
  Netlist n("illumination");
  DotProducts products(n, p);
  const auto direction = [&](const std::string& name) {
    const Wire phi = n.input(name + ".phi", p.inner_angle());
    return Direction{phi, n.input(name + ".theta", p.inner_angle())};
  };
  const Direction light = direction("L_ref"), half = direction("H_ref"), normal = direction("N_L");
  const bool shared = p.tables == Tables::shared;
  const Direction normal_again = shared ? normal : direction("N_H");
  const int fraction = p.word_bits;
  Wire lit[2];
  SineCosine of_normal;
  for (int i = 0; i < 2; ++i) {
    const std::string equation = i == 0 ? "Eq 3" : "Eq 4";
    const Direction& v = i == 0 ? light : half;
    const Direction& m = i == 0 ? normal : normal_again;
    const Netlist::Scope scope(n, i == 0 ? "N_L" : "N_H");
    const Netlist::Label label(n, equation);
    const SineCosine of_vector = products.read("V", v.theta);
    if (i == 0 || !shared) of_normal = products.read("N", m.theta);
    const Wire phi_difference = n.sub("phi_difference", v.phi, m.phi, p.inner_angle());
    lit[i] = clamp_dot(n, "lit", products.dot(of_vector, of_normal, phi_difference), fraction);
  }
  const Format index = clamped_dot_format(fraction);
  const Wire diffuse = n.table("DIFF", diffuse_table(index, p.light_table_bits, material, p.light_word_bits), lit[0], "Eq 2").front();
  const Wire specular = n.table("SPEC", specular_table(index, p.light_table_bits, material, p.light_word_bits), lit[1], "Eq 2").front();
  n.output("intensity", n.add("intensity", diffuse, specular, intensity_format(p.light_word_bits), "Eq 2"));
  return n;
}

}  // namespace bump::kim2001
