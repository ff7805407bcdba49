#include "system/simulation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <systemc>

#include "channels/stepped_engine.h"
#include "datapath/invariant.h"
#include "datapath/vertex_program.h"
#include "system/accounting.h"
#include "system/bound.h"
#include "system/dated_engine.h"
#include "system/pipeline.h"
#include "system/self_check.h"
#include "system/stand_in.h"

namespace bump {

namespace {

/// One design per distinct material, and which of them each object uses.
struct Designs {
  std::vector<Design> designs;
  std::vector<int> of_object;
};

Designs make_designs(const Scene& scene, const Scheme& scheme, const Configuration& configuration) {
  Designs result;
  std::vector<Material> materials;
  for (const SceneObject& object : scene.objects) {
    std::size_t index = 0;
    while (index < materials.size() && !(materials[index] == object.material)) ++index;
    if (index == materials.size()) {
      materials.push_back(object.material);
      result.designs.push_back(scheme.design(configuration, object.material));
    }
    result.of_object.push_back(static_cast<int>(index));
  }
  return result;
}

/// Runs SystemC to the end of the simulation. What a module threw comes back from the failure; what else escapes is the program's fault.
void run_kernel(const Failure& failure) {
  try {
    sc_core::sc_start();
  } catch (const std::exception& escaped) {
    failure.rethrow();
    throw Error(ErrorKind::internal, {"the simulation broke off", {}, escaped.what(), "report this with the command that led to it"});
  }
  failure.rethrow();
}

/// Takes the records of retired blocks and forgets them.
class RecordSink : public UnitModule {
 public:
  RecordSink(const sc_core::sc_module_name& name, Failure& failure, BlockFifo<TimingRecords>& in_records)
      : UnitModule(name, failure), in_records_(in_records) {}

 private:
  void work() override {
    while (in_records_.read()) {
    }
    sc_core::sc_stop();
  }
  BlockFifo<TimingRecords>& in_records_;
};

/// Shows the records of retired blocks to a listener on their way to the engine.
class RecordTap : public UnitModule {
 public:
  RecordTap(const sc_core::sc_module_name& name, Failure& failure, BlockFifo<TimingRecords>& in_records,
            std::function<void(const TimingRecords&)> listener)
      : UnitModule(name, failure), in_records_(in_records), out_records_("records"), listener_(std::move(listener)) {}
  BlockFifo<TimingRecords>& out_records() { return out_records_; }

 private:
  void work() override {
    while (auto records = in_records_.read()) {
      listener_(*records);
      out_records_.write(std::move(records));
    }
    out_records_.close();
  }
  BlockFifo<TimingRecords>& in_records_;
  BlockFifo<TimingRecords> out_records_;
  std::function<void(const TimingRecords&)> listener_;
};

/// The engine around the pipeline; owns whichever timing plane dates its records.
class TimedRun {
 public:
  TimedRun(Pipeline& pipeline, const PipelineTiming& timing, const SimulationOptions& options, sc_core::sc_time period)
      : pipeline_(pipeline), last_interval_(timing.graph.stages.size(), 0) {
    if (options.record) tap_.emplace("record_tap", pipeline.failure(), pipeline.out_records(), options.record);
    if (options.engine == Engine::untimed) {
      sink_.emplace("record_sink", pipeline.failure(), source());
      return;
    }
    if (options.engine == Engine::dated) {
      dated_.emplace("dated_engine", pipeline.failure(), timing, source(), period, last_interval_);
      return;
    }
    StageFactory stand_in;
    if (options.stand_in != nullptr) stand_in = [&options](const StageParts& parts) { return options.stand_in->stage(parts); };
    const auto refill = [this, &timing] {
      const auto records = source().read();
      if (records) feed(*stepped_, *records, timing, last_interval_);
      return records != nullptr;
    };
    stepped_.emplace("stepped_engine", timing.graph, period, refill, std::function<void()>(), stand_in);
    if (!options.trace.empty()) stepped_->trace(options.trace);
  }

  TimingResult run() {
    run_kernel(pipeline_.failure());
    if (sink_) return {};
    return dated_ ? dated_->result() : stepped_->result();
  }

  /// Appends what the host spent on dates, where that is known apart from the kernel's work.
  void add_host_time(std::vector<HostTime>& times) const {
    if (dated_) times.push_back({"dates", dated_->host_seconds()});
  }
  /// Initiation interval of the last token of each stage.
  const std::vector<Cycle>& last_interval() const { return last_interval_; }

 private:
  BlockFifo<TimingRecords>& source() { return tap_ ? tap_->out_records() : pipeline_.out_records(); }

  Pipeline& pipeline_;
  std::vector<Cycle> last_interval_;
  std::optional<RecordTap> tap_;
  std::optional<RecordSink> sink_;
  std::optional<DatedEngine> dated_;
  std::optional<SteppedEngine> stepped_;
};

/// What the designs state for their widths, one light of intensity 1 each, put together for the scene: errors of several lights add up at
/// worst, the colour unit rounds each of its sums and products once, and the material that is worst decides. Words of light maps round the
/// sum of the lights once, so they are off by no less when lights are dim.
double stated_floor_db(const PipelineContext& context, int colour_bits) {
  double intensity = 0, worst = 0;
  for (const Light& light : context.scene->lights) intensity += std::fabs(light.intensity);
  if (context.designs.front().light_maps) intensity = std::max(1.0, intensity);
  for (const Design& design : context.designs) worst = std::max(worst, intensity * std::pow(10, -design.quantisation_floor_db / 20));
  const double rounding = (2.0 * context.lights + 3) * std::ldexp(1.0, -colour_bits);
  return -20 * std::log10(worst + rounding);
}

GeometryCounters geometry_of(const Pipeline& pipeline) {
  GeometryCounters all = pipeline.vertex_processor().counters();
  const GeometryCounters& setup = pipeline.triangle_setup().counters();
  const GeometryCounters& raster = pipeline.rasterizer().counters();
  all.triangles_clipped = setup.triangles_clipped;
  all.triangles_culled = setup.triangles_culled;
  all.triangles_empty = setup.triangles_empty + raster.triangles_empty;
  all.triangles_hidden = raster.triangles_hidden;
  all.triangles_drawn = raster.triangles_drawn;
  all.fragments_generated = raster.fragments_generated;
  all.fragments_hidden = raster.fragments_hidden;
  all.fragments = raster.fragments;
  all.fragments_retired = pipeline.frame_sink().retired();
  return all;
}

void account(const Pipeline& pipeline, const PipelineContext& context, const DatapathSchedules& schedules, SimulationResult& result) {
  const Design& design = context.designs.front();
  const int materials = static_cast<int>(context.designs.size());
  const auto unit = [&](const std::string& name, const Netlist& netlist, const Schedule* schedule, std::int64_t executions) {
    result.units.push_back(unit_cost(name, netlist, schedule, executions));
    keep_tables_per_material(result.units.back(), netlist, materials);
    for (TableUse& use : table_uses(name, netlist, executions, materials)) result.tables.push_back(std::move(use));
  };
  unit("environment", design.environment, &schedules.environment, pipeline.environment().executions());
  if (const LightMapFetch* fetch = pipeline.light_map_fetch()) {
    const LightMaps& maps = *design.light_maps;
    unit("light_map_address", maps.address, &schedules.light_map_address, fetch->executions());
    result.units.back().published.maps += static_cast<int>(maps.maps.size());
    result.light_maps = light_map_uses(maps, *fetch);
  }
  unit("illumination", design.illumination, &schedules.illumination, pipeline.illumination().executions());
  if (design.conversion) unit("conversion", *design.conversion, &schedules.conversion, pipeline.interpolators().conversions());
  unit("colour", pipeline.colour().netlist(), &schedules.colour, pipeline.colour().executions());
  result.units.push_back(unit_cost("interpolators", interpolator_netlist(context), nullptr, result.geometry.fragments));
  if (const LightMapFetch* fetch = pipeline.light_map_fetch())
    result.units.push_back(frame_cost(*design.light_maps, context.scene->lights, fetch->fill_executions()));
  UnitCost vertex = unit_cost("vertex", design.vertex, nullptr, result.geometry.vertices);
  vertex.per_light = count_nodes(design.vertex, depends_on(design.vertex, {"L."}));
  vertex.lights = context.lights;
  result.units.push_back(std::move(vertex));
  result.units.push_back(unit_cost("vertex_transform", pipeline.vertex_processor().transform(), nullptr, result.geometry.vertices));
}

}  // namespace

Parameters all_parameters() {
  Parameters parameters;
  declare_pipeline_parameters(parameters);
  VertexProcessorConfig::declare(parameters);
  TriangleSetupConfig::declare(parameters);
  RasterizerConfig::declare(parameters);
  InterpolatorsConfig::declare(parameters);
  TextureFetchConfig::declare(parameters);
  LightMapFetchConfig::declare(parameters);
  ColourUnitConfig::declare(parameters);
  for (const Scheme* scheme : all_schemes()) scheme->declare(parameters);
  return parameters;
}

SimulationResult simulate(const Scene& scene, const Scheme& scheme, const Configuration& configuration, const SimulationOptions& options) {
  HostClock preparation;
  preparation.start();
  Designs designs = make_designs(scene, scheme, configuration);
  ContextOptions context_options;
  context_options.arithmetic = configuration.choice("numeric") == "fixed" ? Arithmetic::fixed : Arithmetic::real;
  context_options.keep_exact = options.measure;
  context_options.probe_directions = options.measure;
  context_options.measure_aside = options.measure_aside;
  context_options.shading = VertexProcessorConfig(configuration).space;
  const auto context = make_context(scene, std::move(designs.designs), std::move(designs.of_object), context_options);

  const std::int64_t triangles = context->triangles();
  const auto watch = [&options, triangles](std::int64_t entered) {
    if (options.cancelled != nullptr && *options.cancelled)
      throw Error(ErrorKind::cancelled, {"interrupted", {}, "", "nothing was written"});
    if (options.progress) options.progress(triangles > 0 ? static_cast<double>(entered) / static_cast<double>(triangles) : 1.0);
  };
  Pipeline pipeline("pipeline", context, configuration, watch);
  if (options.accesses) pipeline.listen(*options.accesses);
  const DatapathSchedules schedules = make_schedules(context->designs.front(), pipeline.colour().netlist(), configuration);
  const PipelineTiming timing = make_pipeline_timing(schedules, context->passes, configuration);
  if (options.stand_in != nullptr) {
    BUMP_ASSERT(options.engine == Engine::stepped);
    options.stand_in->prepare(context, timing);
    pipeline.show_retired([&options](const FragmentBlock& block) { options.stand_in->retire(block); });
  }
  const double megahertz = configuration.number("clock.megahertz");
  // Kernel time is counted in whole picoseconds; cycles are integers of their own, so a rounded period does no harm.
  TimedRun run(pipeline, timing, options, sc_core::sc_time(1e6 / megahertz, sc_core::SC_PS));
  preparation.stop();

  SimulationResult result;
  result.timing = run.run();
  result.geometry = geometry_of(pipeline);
  result.fragments = result.geometry.fragments;
  result.texture = pipeline.texture_fetch().counters();
  if (options.engine != Engine::untimed) result.bound = lower_bound(timing.graph, result.timing, run.last_interval());
  result.angular_errors = pipeline.environment().meter().hardware();
  result.angular_errors_exact = pipeline.environment().meter().exact();
  result.interpolator_components = interpolator_components(*context);
  result.quantisation_floor_db = stated_floor_db(*context, static_cast<int>(configuration.integer("colour_unit.bits")));
  FrameSink::Drawn drawn = pipeline.release_frames(options.measure);
  result.hardware = std::move(drawn.hardware);
  if (options.stand_in != nullptr) options.stand_in->draw(result.hardware);
  result.exact = std::move(drawn.exact);
  result.diverged = std::move(drawn.diverged);
  result.clock_megahertz = megahertz;
  result.host_times = pipeline.host_times();
  result.host_times.insert(result.host_times.begin(), {"preparation", preparation.seconds()});
  run.add_host_time(result.host_times);
  account(pipeline, *context, schedules, result);
  if (options.engine != Engine::untimed) check_conservation(result, timing.graph, run.last_interval());
  return result;
}

}  // namespace bump
