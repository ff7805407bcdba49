// Phong shading hardware without bumps, the baseline of Peercy, Airey and Cabral 1997, Fig. 1: see README.md of this folder.

#include "schemes/common/cartesian_units.h"
#include "schemes/common/vertex_vectors.h"
#include "schemes/scheme.h"

namespace bump::phong1975 {

namespace {

/// Three normalisers: 9 multipliers, 6 adders, 9 dividers, 3 square roots.
Netlist environment_unit(const CartesianWidths& widths) {
  Netlist n("environment");
  const Netlist::Label label(n, "Peercy Fig. 1, normaliser");
  for (const char* name : {"L", "H", "N"}) {
    const std::string unit = std::string(name) + "_unit";
    output_vector(n, unit, normalise_pixel(n, unit, input_vector(n, name, widths.component()), widths));
  }
  return n;
}

class Phong1975 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"phong1975",
                                 "Phong shading without bumps",
                                 "B.-T. Phong, Illumination for Computer Generated Pictures, 1975; hardware of M. Peercy, J. Airey, B. "
                                 "Cabral, Efficient Bump Mapping Hardware, SIGGRAPH 1997, Fig. 1",
                                 "as published (widths, illumination finish: reconstruction)",
                                 "N, L and H are interpolated in object space and normalised per pixel; there is no bump map. The circuit "
                                 "that bump mapping is added to, and the yardstick for what bumps cost.",
                                 {"illumination"}};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_widths(parameters, "phong1975"); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const CartesianWidths widths = read_widths(configuration, "phong1975");
    Design design;
    const VertexVectors v = record_vertex_vectors(design);
    interpolate_vector(design, "N", v.normal);
    interpolate_vector(design, "L", v.light);
    interpolate_vector(design, "H", v.half);
    design.environment = environment_unit(widths);
    design.illumination = vector_illumination_unit(widths, material);
    design.map.encode = [](const glm::dvec3&, double*) {};
    design.map.note = "no bump map is read";
    state_direction_bound(design, widths, 0, material);
    return design;
  }
};

BUMP_REGISTER_SCHEME(Phong1975);

}  // namespace

}  // namespace bump::phong1975
