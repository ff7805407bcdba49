// The scheme of Peercy, Airey and Cabral 1997 as one Design: see README.md of this folder.

#include "schemes/peercy1997/peercy_parameters.h"
#include "schemes/peercy1997/units.h"
#include "schemes/scheme.h"

namespace bump::peercy1997 {

namespace {

BumpEncoding vector_map(const PeercyParameters& p) {
  BumpEncoding map;
  for (const char* component : {"x", "y", "z"}) map.channels.push_back({component, p.texel(), ChannelKind::linear});
  map.encode = [](const glm::dvec3& normal, double* channels) {
    for (int i = 0; i < 3; ++i) channels[i] = normal[i];
  };
  const MapSpace space = p.map;
  const Perturbation perturbation = p.perturbation;
  if (space == MapSpace::object || perturbation == Perturbation::surface)
    map.bake = [space, perturbation](const SceneObject& object) { return surface_map(object, space, perturbation); };
  map.in_object_space = space == MapSpace::object;
  map.filterable = true;
  map.note = "filtered as any texture; a shortened normal is normalised per pixel";
  return map;
}

class Peercy1997 : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "peercy1997",
        "Tangent-space normal map",
        "M. Peercy, J. Airey, B. Cabral, Efficient Bump Mapping Hardware, SIGGRAPH 1997",
        "as published (widths, illumination finish: reconstruction)",
        "The map holds N' in tangent space (or the object's own); L and H are taken there by the matrix of T, B, N, per pixel or at the "
        "vertices, and interpolated; "
        "three normalisers and two dot products a pixel. Exact but for interpolation.",
        {"illumination"}};
    return page;
  }

  void declare(Parameters& parameters) const override { declare_parameters(parameters); }

  Design design(const Configuration& configuration, const Material& material) const override {
    const PeercyParameters p = read_parameters(configuration);
    Design design;
    record_vertex_program(p, design);
    design.environment = environment_unit(p);
    design.illumination = vector_illumination_unit(p.widths, material);
    design.map = vector_map(p);
    using Of = DeliveredDirection::Of;
    using Frame = DeliveredDirection::Frame;
    const Frame frame = p.map == MapSpace::object ? Frame::shading : Frame::tangent;
    design.directions = {{Of::light, frame, {"L_unit.x", "L_unit.y", "L_unit.z"}}, {Of::half, frame, {"H_unit.x", "H_unit.y", "H_unit.z"}}};
    state_direction_bound(design, p.widths, p.texel().step(), material);
    return design;
  }
};

BUMP_REGISTER_SCHEME(Peercy1997);

}  // namespace

}  // namespace bump::peercy1997
