// TL0 as one Design: see README.md of this folder.

#include <algorithm>

#include "schemes/common/log_error.h"
#include "schemes/tl0/units.h"

namespace bump::tl0 {

namespace {

class Tl0 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "tl0", "Law of haversines on longitude and latitude in tangent space, no multiplier", "this project; in no paper", "this project's",
        "L and H are turned into tangent space at the vertices and interpolated as longitude and latitude about the y axis, where the map "
        "has "
        "its pole, too. A pixel needs the law of haversines, its one product a sum of three logarithms. For any mesh."};
    return page;
  }

  void declare(Parameters& p) const override {
    const Tl0Parameters defaults;
    declare_tangent_angle_parameters(p, "tl0");
    p.integer("tl0.log_table_bits", defaults.log_table_bits, 3, 12, "bits",
              "address bits of the table of logarithms of cosines, for a quarter turn");
    p.integer("tl0.log_bits", defaults.log_bits, 3, 18, "bits", "fraction bits of a logarithm");
    declare_log_whole_bits(p, "tl0");
    p.integer("tl0.antilog_table_bits", defaults.antilog_table_bits, 3, 14, "bits", "address bits of the antilogarithm's table");
  }

  Design design(const Configuration& c, const Material& material) const override {
    const auto integer = [&](const char* key) { return static_cast<int>(c.integer(std::string("tl0.") + key)); };
    Tl0Parameters p;
    static_cast<TangentAngleParameters&>(p) = read_tangent_angle_parameters(c, "tl0");
    p.log_table_bits = integer("log_table_bits");
    p.log_bits = integer("log_bits");
    p.log_whole_bits = integer("log_whole_bits");
    p.antilog_table_bits = integer("antilog_table_bits");
    TangentAngleParameters coarsest = p;  // for the bound: latitudes are read in the steps of two tables
    coarsest.table_bits = std::min(p.table_bits, p.log_table_bits);
    Design design = tangent_angle_design(coarsest, environment_unit(p), illumination_unit(p, material), material);
    // Twice the product of three factors.
    design.quantisation_floor_db = logarithmic_floor_db(design.quantisation_floor_db, p.logs(), 3, 2, material);
    return design;
  }
};

BUMP_REGISTER_SCHEME(Tl0);

}  // namespace

}  // namespace bump::tl0
