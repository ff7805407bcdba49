// LNS as one Design: see README.md of this folder.

#include "schemes/common/log_error.h"
#include "schemes/lns/units.h"

namespace bump::lns {

namespace {

class Lns : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "lns", "Exact dot products of angles in logarithms, no multiplier (pole on y)", "this project; in no paper", "this project's",
        "The three products of the rotated normal with a vector, each a sum of logarithms of sines that tables give, brought back by a "
        "small antilogarithm table and a barrel shifter. Exact, with adders and shifters only; errors are relative."};
    return page;
  }

  void declare(Parameters& parameters) const override {
    const LnsParameters defaults;
    declare_y_pole_parameters(parameters, "lns");
    parameters.integer("lns.log_bits", defaults.log_bits, 4, 18, "bits", "fraction bits of a logarithm");
    declare_log_whole_bits(parameters, "lns");
    parameters.integer("lns.antilog_table_bits", defaults.antilog_table_bits, 3, 14, "bits", "address bits of the antilogarithm's table");
  }

  Design design(const Configuration& configuration, const Material& material) const override {
    LnsParameters p;
    static_cast<YPoleParameters&>(p) = read_y_pole_parameters(configuration, "lns");
    p.log_bits = static_cast<int>(configuration.integer("lns.log_bits"));
    p.log_whole_bits = static_cast<int>(configuration.integer("lns.log_whole_bits"));
    p.antilog_table_bits = static_cast<int>(configuration.integer("lns.antilog_table_bits"));
    Design design = y_pole_design(p, environment_unit(p), illumination_unit(p, material), material);
    design.quantisation_floor_db = logarithmic_floor_db(design.quantisation_floor_db, p.logs(), 4, 3, material);
    return design;
  }
};

BUMP_REGISTER_SCHEME(Lns);

}  // namespace

}  // namespace bump::lns
