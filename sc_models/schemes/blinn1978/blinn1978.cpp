// Blinn's bump mapping as a per-pixel unit, as one Design: see README.md of this folder.

#include "schemes/blinn1978/perturbation.h"
#include "schemes/common/cartesian_units.h"
#include "schemes/scheme.h"

namespace bump::blinn1978 {

namespace {

class Blinn1978 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"blinn1978", "The conventional method: perturbation per pixel in object space",
                                 "J. F. Blinn, Simulation of Wrinkled Surfaces, SIGGRAPH 1978; as Lee et al. 2007, Eq 1, compares with it",
                                 "reconstruction (a software method laid out as hardware)",
                                 "The map holds two slopes; N' = N + Bu (N x Pv) - Bv (N x Pu) is formed and normalised at every pixel, "
                                 "beside L and H, in object space. Exact for a square patch, but for interpolation.",
                                 {"environment", "illumination"}};
    return page;
  }

  void declare(Parameters& p) const override {
    p.choice("blinn1978.perturbation", "plain", {"plain", "factored"},
             "two cross products as Eq 1 of Lee 2007 is written, or one: N x (Bu Pv - Bv Pu)");
    declare_slopes(p, "blinn1978");
    declare_widths(p, "blinn1978");
  }

  Design design(const Configuration& configuration, const Material& material) const override {
    const BlinnParameters p{configuration.choice("blinn1978.perturbation") == "factored", read_widths(configuration, "blinn1978"),
                            read_slopes(configuration, "blinn1978")};
    Design design;
    record_vertex_program(design);
    design.environment = environment_unit(p);
    design.illumination = vector_illumination_unit(p.widths, material);
    design.map = slope_map(p.slopes, "u", "v", -1);  // a surface that rises along u leans its normal back
    state_direction_bound(design, p.widths, p.slopes.texel().step(), material);
    return design;
  }
};

BUMP_REGISTER_SCHEME(Blinn1978);

}  // namespace

}  // namespace bump::blinn1978
