// N2L as one Design: see README.md of this folder.

#include "schemes/n2l/environment.h"

namespace bump::n2l {

namespace {

class N2l : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"n2l", "The bumped normal to object angles, division by logarithms: two multipliers (pole on y)",
                                 "this project; in no paper", "this project's",
                                 "As N3, with the quotient of its arc tangent as a difference of two logarithms that tables give, and a "
                                 "table from the difference to "
                                 "the angle. The law of cosines of Lee 2007 takes the two multipliers that are left."};
    return page;
  }

  void declare(Parameters& parameters) const override {
    declare_object_angles_parameters(parameters, "n2l");
    parameters.integer("n2l.log_bits", N2lParameters{}.log_bits, 4, 18, "bits", "fraction bits of a logarithm");
  }

  Design design(const Configuration& configuration, const Material& material) const override {
    N2lParameters p;
    static_cast<ObjectAnglesParameters&>(p) = read_object_angles_parameters(configuration, "n2l");
    p.log_bits = static_cast<int>(configuration.integer("n2l.log_bits"));
    return object_angles_design(p, environment_unit(p), material);
  }
};

BUMP_REGISTER_SCHEME(N2l);

}  // namespace

}  // namespace bump::n2l
