#pragma once
// A bump-mapping scheme: what a paper proposes, as data and netlists. To add one, add a folder with a class derived from Scheme and one
// BUMP_REGISTER_SCHEME line; the list, the comparison, the documentation, the generic tests and the sweeps find it by themselves.
//
// Names that connect the parts. The vertex program reads, along the axes of `vertex_processor.space` (the object's own by default), per vertex and light:
//   N.x N.y N.z  T.x T.y T.z  B.x B.y B.z   the vertex frame (unit vectors, B = N x T up to handedness)
//   L.x L.y L.z   towards the light: unit for a directional light, light position minus vertex for a point light
//   V.x V.y V.z   towards the eye: eye position minus vertex
// Its outputs are the interpolants, one for one. An output that does not depend on L is computed and interpolated once for all lights.
// The per-pixel netlists (conversion, environment, illumination) read interpolants, "map.<channel>" and outputs of the netlists before
// them by name, and run once per light, or once for all lights if there are light maps. The illumination netlist has one output,
// "intensity": diffuse plus specular, without ambient, for a light of intensity 1 (with light maps: of all lights). The colour unit
// that every scheme shares adds ambient and multiplies by the colour texel.

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "datapath/netlist.h"
#include "units/scene.h"
#include "units/surface_map.h"

namespace bump {

enum class InterpolantKind {
  linear,       ///< perspective-correct
  angle,        ///< turns: perspective-correct along the short way round
  flat_angle    ///< turns: constant over the triangle, its first corner's value
};

struct Interpolant {
  std::string name;  ///< the vertex program's output and the plane
  InterpolantKind kind = InterpolantKind::linear;
};

/// How the scheme stores N' in its bump map.
struct BumpEncoding {
  struct Channel {
    std::string name;                            ///< plane "map.<name>"
    Format format{};                             ///< of the stored texel
    ChannelKind kind = ChannelKind::linear;
  };
  std::vector<Channel> channels;  ///< none: the scheme reads no bump map, and nothing is fetched
  std::function<void(const glm::dvec3& normal, double* channels)> encode;  ///< from a unit normal in the map's space
  bool filterable = true;  ///< false: nearest texel whatever the configured filter (polar maps: phi is undefined on flat texels)
  std::string note;        ///< why, one line
  /// Optional: the normals to encode, when they depend on the surface and not only on the scene's tangent-space map; asked once for each
  /// object that differs in mesh or textures. Throws Error(input) for an object that cannot have such a map.
  std::function<SurfaceMap(const SceneObject& object)> bake;
  bool in_object_space = false;  ///< `bake` gives normals along the object's axes: vectors must be shaded in object space, too
};

/// A direction that the environment unit delivers, for the report of angular errors.
struct DeliveredDirection {
  enum class Of { light, half } of = Of::light;
  enum class Frame {
    tangent,  ///< x = T, y = B, z = N of the interpolated, orthonormalised frame
    polar,    ///< x = e_theta, y = e_phi, z = N: Lee's rotation, singular at the poles of the z axis
    shading   ///< the axes along which the vertex program reads its vectors
  } frame = Frame::tangent;
  std::vector<std::string> planes;  ///< three: Cartesian x, y, z (any length); two: phi, theta in turns
};

/// Maps that are filled once a frame for the lights of the scene, one set per object, and fetched per pixel at an address that the hardware has just
/// computed: a dependent fetch, with a cache and a memory port of its own, between environment and illumination unit. Lights and eye count as
/// infinitely far from the object's centre, and all lights are summed in the maps: the pixel passes the datapaths once, however many lights there are.
struct LightMaps {
  struct Map {
    std::string name;  ///< plane "light.<name>", which the illumination netlist reads, and output of `fill`
    Format word{};     ///< of a stored entry
  };
  std::vector<Map> maps;  ///< words of at most 31 bits
  int address_bits = 20;  ///< 2^address_bits entries in each map
  /// The low bits of an entry that count its column, the others its row: entries of one tile of rows and columns share a cache line. 0: half of
  /// address_bits.
  int column_bits = 0;
  /// Per pixel, fixed point. Reads outputs of the environment netlist, and "light_map.base", the first entry of the object's maps
  /// (object * 2^address_bits). Outputs: "light_map.entry", an integer: base plus entry; and whatever `direction` needs. The widths of both words
  /// limit the number of objects.
  Netlist address{"address"};
  /// Outputs of `address` that mean a direction. The double evaluation computes the maps' continuous function there, as it does for tables.
  std::vector<std::string> coordinates;
  /// The direction that coordinates mean; and the centre coordinates of an entry. Unit vectors, in the axes of the vertex program.
  std::function<glm::dvec3(const double* coordinates)> direction;
  std::function<void(std::int64_t entry, double* coordinates)> centre;
  /// Real-valued, once per entry and light: N.x N.y N.z (the direction), L.x .. L.z, H.x .. H.z (unit) to one output per map, for a light of intensity 1.
  Netlist fill{"frame"};
};

struct Design {
  Netlist vertex{"vertex"};
  std::vector<Interpolant> interpolants;
  std::optional<Netlist> conversion;  ///< per-pixel work in front of the environment unit that the paper assumes given; reported apart
  Netlist environment{"environment"};
  Netlist illumination{"illumination"};
  std::optional<LightMaps> light_maps;
  BumpEncoding map;
  std::vector<DeliveredDirection> directions;
  /// PSNR of fixed point against the scheme's own double evaluation that these widths guarantee, for one light of intensity 1 and a white texel: a
  /// run whose picture is worse fails its self-check. Pixels named by `jumps` and `least` are left out.
  double quantisation_floor_db = 0;
  /// Flags of the environment netlist, by node name, at which the formula itself jumps: where fixed point and double decide them
  /// differently, an arbitrarily small rounding makes an arbitrarily large error.
  std::vector<std::string> jumps;
  /// Nodes of the environment netlist, by name, below whose least value (in double precision) the bound does not hold: vectors that interpolation
  /// has shortened to almost nothing.
  struct Least {
    std::string node;
    double value;
  };
  std::vector<Least> least;
};

/// Where a scheme comes from, for `list`, `describe` and the reports.
struct SchemePage {
  std::string id;          ///< folder name, e.g. "lee2007"
  std::string title;       ///< one line
  std::string source;      ///< paper
  std::string provenance;  ///< "as published", "reconstruction", "this project's"
  std::string summary;     ///< two or three sentences
  /// Units ("environment", "illumination") that are in no source in this form but were made to agree with what is known of them, counts or remarks;
  /// tables mark them.
  std::vector<std::string> reconstructed{};
  bool mirrored_charts = true;  ///< false: texture charts that run the wrong way round are shaded wrongly, and no parameter helps
};

class Scheme {
 public:
  virtual ~Scheme() = default;
  virtual const SchemePage& page() const = 0;
  /// Declares the scheme's parameters; keys start with its id.
  virtual void declare(Parameters& parameters) const = 0;
  /// Table contents follow the material; the structure must not. Throws Error(input) when parameters contradict one another.
  virtual Design design(const Configuration& configuration, const Material& material) const = 0;
};

/// All registered schemes in order of id.
std::vector<const Scheme*> all_schemes();
/// Throws Error(input) with the nearest id.
const Scheme& find_scheme(const std::string& id);

bool register_scheme(std::unique_ptr<Scheme> scheme);
#define BUMP_REGISTER_SCHEME(Type) static const bool registered_##Type = ::bump::register_scheme(std::make_unique<Type>())

}  // namespace bump
