// YP6G as one Design: see README.md of this folder.

#include "schemes/common/light_tables.h"
#include "schemes/common/polar_error.h"
#include "schemes/common/polar_map.h"
#include "schemes/common/polar_vectors.h"
#include "schemes/yp6g/units.h"

namespace bump::yp6g {

namespace {

Yp6gParameters read(const Configuration& c) {
  const auto integer = [&](const char* key) { return static_cast<int>(c.integer(std::string("yp6g.") + key)); };
  Yp6gParameters p;
  read_polar_settings(c, "yp6g", p.polar);
  read_in_plane_settings(c, "yp6g", p.polar);
  p.polar.inverse_table_bits = integer("inverse_table_bits");
  p.sums.angle_bits = p.polar.angle_bits;
  p.sums.table_bits = integer("table_bits");
  p.sums.word_bits = integer("word_bits");
  p.sums.light_table_bits = integer("light_table_bits");
  p.sums.light_word_bits = integer("light_word_bits");
  p.sums.ports = integer("ports");
  return p;
}

class Yp6g : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "yp6g", "Exact dot products of angles on any mesh, six multipliers", "this project; in no paper", "this project's",
        "YP6 for any tangents: the map's pole is on z, the in-plane angle is one addition, and the map's normal is rotated by "
        "sums of angles once for both dot products. Exact, without inverse functions."};
    return page;
  }

  void declare(Parameters& p) const override {
    PolarSettings defaults;
    defaults.angle_bits = 12;
    declare_polar_settings(p, "yp6g", defaults);
    declare_in_plane_settings(p, "yp6g");
    p.integer("yp6g.inverse_table_bits", 10, 4, 14, "bits", "address bits of arc tangents: angles formed per pixel, a vector texel");
    declare_sum_widths(p, "yp6g");
  }

  Design design(const Configuration& configuration, const Material& material) const override {
    const Yp6gParameters p = read(configuration);
    Design design;
    record_polar_vectors(p.polar, NormalAs::angles, design);
    design.environment = environment_unit(p);
    design.illumination = projected_illumination_unit(p.sums, normal_formats(p), material);
    design.map = polar_map(p.polar);
    const double floor_db = polar_floor_db(p.polar, {p.sums.table_bits, p.sums.word_bits, 0, p.sums.light_table_bits}, material);
    design.quantisation_floor_db = light_word_floor_db(floor_db, p.sums.light_word_bits);
    return design;
  }
};

BUMP_REGISTER_SCHEME(Yp6g);

}  // namespace

}  // namespace bump::yp6g
