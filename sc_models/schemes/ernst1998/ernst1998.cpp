// The scheme of Ernst et al. 1998 in two variants: see README.md of this folder.

#include "schemes/ernst1998/ernst_parameters.h"
#include "schemes/ernst1998/gouraud.h"
#include "schemes/ernst1998/high_end.h"

namespace bump::ernst1998 {

namespace {

class Ernst1998 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "ernst1998", "Tangent-space slope map with k = -1, and Gouraud bump mapping",
        "I. Ernst, H. Ruesseler, H. Schulz, O. Wittig, Gouraud Bump Mapping, Graphics Hardware 1998; as Lee et al. "
        "2007 compares with it",
        "reconstruction from the counts and remarks of Lee et al. 2007 (the paper's text was not at hand)",
        "High end: the map holds (fu, fv, 1) in tangent space, L and H are transformed per pixel, three vectors "
        "are normalised. Low end: a bump term is blended onto Gouraud shading by four multipliers.",
        {"environment", "illumination"}};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_parameters(parameters); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const ErnstParameters p = read_parameters(configuration);
    return p.high_end ? high_end_design(p, material) : gouraud_design(p, material);
  }
};

BUMP_REGISTER_SCHEME(Ernst1998);

}  // namespace

}  // namespace bump::ernst1998
