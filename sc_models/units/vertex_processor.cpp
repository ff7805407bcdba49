#include "units/vertex_processor.h"

#include <algorithm>
#include <string>

#include "datapath/invariant.h"
#include "datapath/vertex_program.h"

namespace bump {

namespace {

constexpr int vectors = 5;

/// Place of a vertex program's input among N, T, B, L, V; each x, y, z.
int input_slot(const std::string& name) {
  static const std::string letters = "NTBLV", axes = "xyz";
  const bool known =
      name.size() == 3 && name[1] == '.' && letters.find(name[0]) != std::string::npos && axes.find(name[2]) != std::string::npos;
  if (!known)
    throw Error(ErrorKind::internal,
                {"vertex program reads '" + name + "'", {}, "inputs are N T B L V, .x .y .z", "mend the scheme's vertex program"});
  return static_cast<int>(3 * letters.find(name[0]) + axes.find(name[2]));
}

bool reads(const Netlist& program, char letter) {
  return std::any_of(program.inputs().begin(), program.inputs().end(), [&](const Netlist::Port& port) { return port.name[0] == letter; });
}

std::vector<Wire> vector_inputs(Netlist& netlist, const std::string& name, const std::string& axes) {
  std::vector<Wire> vector;
  for (const char axis : axes) vector.push_back(netlist.input(name + "." + axis, real()));
  return vector;
}

/// Square, as many rows as there are axes; row by row. Element of row x and column y: "name.x.y".
std::vector<Wire> matrix_inputs(Netlist& netlist, const std::string& name, const std::string& axes) {
  std::vector<Wire> matrix;
  for (const char row : axes)
    for (const char column : axes) matrix.push_back(netlist.input(name + "." + row + "." + column, real()));
  return matrix;
}

std::vector<Wire> matrix_product(Netlist& netlist, const std::string& name, const std::string& axes, const std::vector<Wire>& matrix,
                                 const std::vector<Wire>& vector) {
  std::vector<Wire> product;
  for (const char row : axes) {
    Wire sum;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const std::string term = name + "." + row + "." + axes[i];
      const Wire part = netlist.mul(term, matrix[product.size() * axes.size() + i], vector[i], real());
      sum = i == 0 ? part : netlist.add(term + ".sum", sum, part, real());
    }
    product.push_back(sum);
  }
  return product;
}

glm::dvec3 binormal(const Vertex& vertex) {
  return vertex.handedness * glm::cross(vertex.normal, vertex.tangent);
}

}  // namespace

void VertexProcessorConfig::declare(Parameters& p) {
  p.integer("vertex_processor.alus", 4, 1, 4096, "arithmetic units", "operations of a vertex executed each cycle");
  p.integer("vertex_processor.cache_entries", 16, 0, 65536, "vertices", "post-transform cache, first in first out; 0 for none");
  p.choice(
      "vertex_processor.space", "object", {"object", "eye"},
      "axes of the vectors that are shaded: the object's own, or the camera's (z towards the viewer), for some operations more a vertex; "
      "where the pole of schemes on polar angles is");
  p.integer("vertex_processor.latency", 8, 1, 4096, "cycles", "from the last operation of a triangle to its delivery").timing_only = true;
}

VertexProcessorConfig::VertexProcessorConfig(const Configuration& c)
    : alus(static_cast<int>(c.integer("vertex_processor.alus"))),
      cache_entries(static_cast<int>(c.integer("vertex_processor.cache_entries"))),
      latency(static_cast<int>(c.integer("vertex_processor.latency"))),
      space(c.choice("vertex_processor.space") == "eye" ? ShadingSpace::eye : ShadingSpace::object) {}

std::int64_t operations(const Inventory& i) {
  return i.multipliers + i.adders + i.dividers + i.square_roots + i.tables + i.maps + i.shifters;
}

Netlist vertex_transform(const TransformNeeds& needs) {
  Netlist netlist("vertex_transform");
  const Format format = real();
  std::vector<Wire> position = vector_inputs(netlist, "P", "xyzw");
  const std::vector<Wire> clip = matrix_product(netlist, "clip", "xyzw", matrix_inputs(netlist, "M.clip", "xyzw"), position);
  for (std::size_t i = 0; i < 4; ++i) netlist.output(std::string("clip.") + "xyzw"[i], clip[i]);

  const bool in_eye_space = needs.space == ShadingSpace::eye;
  if (in_eye_space && !needs.frame.empty()) {
    const std::vector<Wire> rotation = matrix_inputs(netlist, "R", "xyz");
    for (const char letter : needs.frame) {
      const std::string name(1, letter);
      const std::vector<Wire> turned = matrix_product(netlist, name + "_eye", "xyz", rotation, vector_inputs(netlist, name, "xyz"));
      for (std::size_t i = 0; i < 3; ++i) netlist.output(name + "_eye." + "xyz"[i], turned[i]);
    }
  }
  if (in_eye_space && (needs.towards_eye || needs.point_lights > 0)) {
    position.pop_back();  // w is 1: the last column is only added
    position = matrix_product(netlist, "eye", "xyz", matrix_inputs(netlist, "M.eye", "xyz"), position);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string row = std::string("eye.") + "xyz"[i];
      position[i] = netlist.add(row + ".w.sum", position[i], netlist.input("M." + row + ".w", format), format);
    }
  }
  const auto difference = [&](const std::string& name) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string component = name + "." + "xyz"[i];
      netlist.output(component, netlist.sub(component, netlist.input("from." + component, format), position[i], format));
    }
  };
  if (needs.towards_eye && in_eye_space) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string component = std::string("V.") + "xyz"[i];
      netlist.output(component, netlist.negate(component, position[i], format));
    }
  }
  if (needs.towards_eye && !in_eye_space) difference("V");
  for (int light = 0; light < needs.point_lights; ++light) difference(plane_of_light("L", light));
  return netlist;
}

Netlist vertex_transform(bool towards_eye, int point_lights) {
  TransformNeeds needs;
  needs.towards_eye = towards_eye;
  needs.point_lights = point_lights;
  return vertex_transform(needs);
}

Netlist vertex_transform(const PipelineContext& context) {
  const Netlist& program = context.designs.front().vertex;
  const std::vector<Light>& lights = context.scene->lights;
  const auto points = std::count_if(lights.begin(), lights.end(), [](const Light& light) { return !light.directional; });
  TransformNeeds needs;
  needs.space = context.options.shading;
  needs.towards_eye = reads(program, 'V');
  needs.point_lights = reads(program, 'L') ? static_cast<int>(points) : 0;
  for (const char letter : {'N', 'T', 'B'})
    if (reads(program, letter)) needs.frame += letter;
  return vertex_transform(needs);
}

VertexWork vertex_work(const PipelineContext& context) {
  const Netlist& program = context.designs.front().vertex;
  VertexWork work;
  work.transform = operations(count(vertex_transform(context)));
  const std::vector<bool> per_light = depends_on(program, {"L."});
  std::vector<bool> once = per_light;
  once.flip();
  work.once = operations(count_nodes(program, once));
  work.per_light = operations(count_nodes(program, per_light));
  work.lights = context.lights;
  return work;
}

VertexProcessor::VertexProcessor(std::shared_ptr<const PipelineContext> context, const VertexProcessorConfig& config)
    : context_(std::move(context)), config_(config), transform_(vertex_transform(*context_)), work_(vertex_work(*context_)) {
  for (const Design& design : context_->designs) programs_.push_back(make_evaluator(design.vertex, Arithmetic::real));
}

void VertexProcessor::start_object() {
  const Mesh& mesh = *context_->scene->objects[static_cast<std::size_t>(object_)].mesh;
  const ObjectSpace& space = context_->spaces[static_cast<std::size_t>(object_)];
  const auto stride = static_cast<std::size_t>(context_->stride());
  triangle_ = 0;
  cache_ = VertexCache(config_.cache_entries, mesh.vertices.size());
  clip_.resize(mesh.vertices.size());
  attributes_.assign(mesh.vertices.size() * stride, 0.0);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vertex& vertex = mesh.vertices[v];
    clip_[v] = space.to_clip * glm::dvec4(vertex.position, 1.0);
    double* out = &attributes_[v * stride];
    out[0] = vertex.uv.x;
    out[1] = vertex.uv.y;
    const glm::dvec3 probes[4] = {vertex.position, vertex.normal, vertex.tangent, binormal(vertex)};
    for (std::size_t a = 0; a < context_->attributes.size(); ++a) {
      const int probe = context_->attributes[a].probe;
      if (probe >= 0) out[2 + a] = probes[probe / 3][probe % 3];
    }
  }
  for (int first = 0; first < static_cast<int>(mesh.vertices.size()); first += block_lanes)
    run_program(first, std::min(block_lanes, static_cast<int>(mesh.vertices.size()) - first));
}

void VertexProcessor::run_program(int first, int count) {
  const Mesh& mesh = *context_->scene->objects[static_cast<std::size_t>(object_)].mesh;
  const ObjectSpace& space = context_->spaces[static_cast<std::size_t>(object_)];
  const Netlist& program = context_->design_of(object_).vertex;
  Evaluator& evaluator = *programs_[static_cast<std::size_t>(context_->design_of_object[static_cast<std::size_t>(object_)])];
  std::vector<Lanes> slots(3 * vectors), results(program.outputs().size());
  std::vector<const double*> inputs;
  std::vector<double*> outputs;
  for (const Netlist::Port& port : program.inputs()) inputs.push_back(slots[static_cast<std::size_t>(input_slot(port.name))].data());
  for (Lanes& result : results) outputs.push_back(result.data());

  // Without any light the program still runs once, for what does not depend on one.
  for (int light = 0; light < std::max(1, context_->lights); ++light) {
    for (int lane = 0; lane < count; ++lane) {
      const Vertex& vertex = mesh.vertices[static_cast<std::size_t>(first + lane)];
      const glm::dvec3 normal = space.direction(vertex.normal);
      const glm::dvec3 towards_light = context_->lights > 0 ? space.light_vector(light, vertex.position) : normal;
      const glm::dvec3 read[vectors] = {normal, space.direction(vertex.tangent), space.direction(binormal(vertex)), towards_light,
                                        space.eye_vector(vertex.position)};
      for (int slot = 0; slot < 3 * vectors; ++slot)
        slots[static_cast<std::size_t>(slot)][static_cast<std::size_t>(lane)] = read[slot / 3][slot % 3];
    }
    evaluator.evaluate(inputs.data(), count, outputs.data());
    for (std::size_t a = 0; a < context_->attributes.size(); ++a) {
      const Attribute& attribute = context_->attributes[a];
      if (attribute.output < 0 || attribute.light != light) continue;
      const Lanes& result = results[static_cast<std::size_t>(attribute.output)];
      for (int lane = 0; lane < count; ++lane)
        attributes_[static_cast<std::size_t>(first + lane) * static_cast<std::size_t>(context_->stride()) + 2 + a] =
            result[static_cast<std::size_t>(lane)];
    }
  }
}

void VertexProcessor::emit_triangle(TriangleBlock& block, int index, std::uint32_t source) {
  const Mesh& mesh = *context_->scene->objects[static_cast<std::size_t>(object_)].mesh;
  const glm::uvec3& corners = mesh.triangles[source];
  const auto stride = static_cast<std::size_t>(block.stride);
  int transformed = 0;
  for (int corner = 0; corner < 3; ++corner) {
    const std::uint32_t vertex = corners[corner];
    BUMP_ASSERT(vertex < mesh.vertices.size());
    if (!cache_.look_up(vertex)) ++transformed;
    const auto slot = static_cast<std::size_t>(3 * index + corner);
    block.clip[slot] = clip_[vertex];
    std::copy_n(&attributes_[vertex * stride], stride, &block.attributes[slot * stride]);
  }
  block.source[static_cast<std::size_t>(index)] = source;
  const std::int64_t cycles_per_vertex = (work_.total() + config_.alus - 1) / config_.alus;
  TokenRecord record;
  record.interval = static_cast<std::uint32_t>(std::max<std::int64_t>(1, transformed * cycles_per_vertex));
  record.lead = record.interval - 1;  // the triangle leaves when its last corner is done
  block.vertex_records.push_back(record);
  counters_.vertices += transformed;
  counters_.vertex_reuses += 3 - transformed;
  ++counters_.triangles;
}

bool VertexProcessor::next(TriangleBlock& block) {
  const std::vector<SceneObject>& objects = context_->scene->objects;
  while (object_ < 0 || triangle_ == objects[static_cast<std::size_t>(object_)].mesh->triangles.size()) {
    if (object_ + 1 >= static_cast<int>(objects.size())) {
      block.resize(std::max(0, object_), 0, context_->stride());
      return false;
    }
    ++object_;
    start_object();
  }
  const std::size_t left = objects[static_cast<std::size_t>(object_)].mesh->triangles.size() - triangle_;
  block.resize(object_, static_cast<int>(std::min<std::size_t>(block_triangles, left)), context_->stride());
  for (int i = 0; i < block.triangles; ++i) emit_triangle(block, i, static_cast<std::uint32_t>(triangle_++));
  return true;
}

}  // namespace bump
