#pragma once
// What all units of one run know: the scene as each object sees it, the design of each object, and which quantity travels in which plane
// of a fragment block. Built once, before the units, and constant afterwards. No hardware and no time.
//
// Planes, in this order: interpolants (per light where the vertex program's output depends on the light), probes ("probe.P.x" ...
// "probe.B.z": position and frame in object space, interpolated for the report of angular errors only), texels "tex.r/g/b", and, of designs
// with light maps, "light_map.base" -- up to here the hardware holds what the double evaluation holds, and one plane serves both -- then
// "map.<channel>", the outputs of conversion and environment netlist per pass, with light maps those of the address netlist and
// "light.<name>", the outputs of the illumination netlist per pass, and "colour.r/g/b". A pass is a light; with light maps there is one.

#include <memory>
#include <string>
#include <vector>

#include "datapath/evaluate.h"
#include "schemes/scheme.h"
#include "units/fragment_block.h"
#include "units/object_space.h"
#include "units/scene.h"

namespace bump {

struct ContextOptions {
  Arithmetic arithmetic = Arithmetic::fixed;
  bool keep_exact = true;                       ///< with fixed point: compute the double-precision planes, too
  bool probe_directions = false;                ///< interpolate the probes and measure the directions that the environment unit delivers
  bool measure_aside = false;                   ///< measure them by a thread of its own
  ShadingSpace shading = ShadingSpace::object;  ///< axes of the vectors that the vertex program reads
};

/// One interpolated component besides u and v.
struct Attribute {
  int plane = 0;
  InterpolantKind kind = InterpolantKind::linear;
  int output = -1;  ///< of the vertex program; -1 for a probe
  int light = 0;    ///< which execution of the vertex program delivers it
  int probe = -1;   ///< 0 .. 11: P.x P.y P.z N.x ... B.z; -1 for an interpolant
};

struct PipelineContext {
  const Scene* scene = nullptr;
  std::vector<Design> designs;
  std::vector<int> design_of_object;  ///< index into designs, one per object
  ContextOptions options;
  int lights = 0;
  int passes = 0;  ///< executions of the per-pixel netlists for each fragment: one for each light, or one where light maps sum them
  std::vector<ObjectSpace> spaces;  ///< one per object
  std::vector<Attribute> attributes;
  PlaneMap planes;
  int shared_planes = 0;  ///< planes below this index are the same in hardware and in double precision

  const Design& design_of(int object) const {
    return designs[static_cast<std::size_t>(design_of_object[static_cast<std::size_t>(object)])];
  }
  /// Attributes of a corner with u and v.
  int stride() const { return static_cast<int>(attributes.size()) + 2; }
  /// Whether blocks carry double-precision planes of their own.
  bool separate_exact() const { return options.arithmetic == Arithmetic::fixed && options.keep_exact; }
  /// The plane that a netlist's port `name` means in the pass for `light`: the light's own if there is one, else the common one.
  int plane(const std::string& name, int light) const;
  /// The plane of the double-precision evaluation, wherever it is kept.
  const Lanes& exact_plane(const FragmentBlock& block, int index) const;
  /// Mesh triangles in the whole scene.
  std::int64_t triangles() const;
};

/// `design_of_object` names the design of every object; designs differ in table contents and constants only (they follow the material),
/// never in structure. The scene must outlive the context. Throws Error(internal) if designs do not fit together.
std::shared_ptr<const PipelineContext> make_context(const Scene& scene, std::vector<Design> designs, std::vector<int> design_of_object,
                                                    const ContextOptions& options);
std::shared_ptr<const PipelineContext> make_context(const Scene&&, std::vector<Design>, std::vector<int>, const ContextOptions&) = delete;

}  // namespace bump
