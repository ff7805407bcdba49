// EXACT10 as one Design: see README.md of this folder.

#include "schemes/exact10/units.h"

namespace bump::exact10 {

namespace {

class Exact10 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "exact10", "Exact rotation of polar vectors into a vector map, ten multipliers", "this project; in no paper", "this project's",
        "L and H of polar angles are rotated into the frame of N by sums of angles and two multipliers each; the map holds "
        "vectors, so that no inverse function is needed. Exact but for the filtered texel, which is not made unit again."};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_y_pole_parameters(parameters, "exact10", TexelAs::tangent_vector); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const YPoleParameters p = read_y_pole_parameters(configuration, "exact10", TexelAs::tangent_vector);
    Design design = y_pole_design(p, environment_unit(p), illumination_unit(p, material), material);
    using Of = DeliveredDirection::Of;
    const auto frame = p.chart == Chart::any ? DeliveredDirection::Frame::polar : DeliveredDirection::Frame::tangent;
    design.directions = {{Of::light, frame, {"L_ref.x", "L_ref.y", "L_ref.z"}}, {Of::half, frame, {"H_ref.x", "H_ref.y", "H_ref.z"}}};
    return design;
  }
};

BUMP_REGISTER_SCHEME(Exact10);

}  // namespace

}  // namespace bump::exact10
