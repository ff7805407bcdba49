#include "system/pipeline.h"

namespace bump {

Pipeline::Pipeline(const sc_core::sc_module_name& name, std::shared_ptr<const PipelineContext> context, const Configuration& c,
                   std::function<void(std::int64_t)> watch)
    : sc_module(name),
      watch_(std::move(watch)),
      pool_(std::make_shared<BlockPool>(context->planes.size(), context->separate_exact() ? context->planes.size() : 0)),
      vertex_processor_(context, VertexProcessorConfig(c)),
      triangle_setup_(context, TriangleSetupConfig(c)),
      interpolators_(context),
      texture_fetch_(context, TextureFetchConfig(c)),
      environment_(context),
      light_map_fetch_(context->designs.front().light_maps ? std::make_unique<LightMapFetch>(context, LightMapFetchConfig(c)) : nullptr),
      illumination_(context),
      colour_(context, ColourUnitConfig(c)),
      shading_{illumination_, colour_},
      frame_sink_(context),
      triangles_("triangles"),
      set_up_triangles_("set_up_triangles"),
      fragments_("fragments"),
      interpolated_("interpolated"),
      textured_("textured"),
      lit_("lit"),
      shaded_("shaded"),
      light_mapped_(light_map_fetch_ ? std::make_unique<BlockFifo<FragmentBlock>>("light_mapped") : nullptr),
      out_records_("records"),
      vertex_processor_module_("vertex_processor", failure_, vertex_processor_, triangles_, watch_),
      triangle_setup_module_("triangle_setup", failure_, triangle_setup_, triangles_, set_up_triangles_),
      rasterizer_module_("rasterizer", failure_, context, RasterizerConfig(c), pool_, set_up_triangles_, fragments_),
      interpolators_module_("interpolators", failure_, interpolators_, fragments_, interpolated_),
      texture_fetch_module_("texture_fetch", failure_, texture_fetch_, interpolated_, textured_),
      environment_module_("environment", failure_, environment_, textured_, lit_),
      light_map_fetch_module_(light_map_fetch_ ? std::make_unique<FragmentModule<LightMapFetch>>("light_map_fetch", failure_,
                                                                                                 *light_map_fetch_, lit_, *light_mapped_)
                                               : nullptr),
      illumination_module_("illumination", failure_, shading_, light_mapped_ ? *light_mapped_ : lit_, shaded_),
      frame_sink_module_("frame_sink", failure_, frame_sink_, pool_, shaded_, [this](const FragmentBlock& block) {
        if (retired_) retired_(block);
        out_records_.write(records_of(block));
        if (block.last) out_records_.close();
        if (watch_) watch_(vertex_processor_.counters().triangles);
      }) {}

void Pipeline::listen(AccessListener& listener) {
  texture_fetch_.listen(listener);
  if (light_map_fetch_) light_map_fetch_->listen(listener);
}

std::vector<HostTime> Pipeline::host_times() const {
  std::vector<const UnitModule*> modules = {&vertex_processor_module_, &triangle_setup_module_, &rasterizer_module_,
                                            &interpolators_module_,    &texture_fetch_module_,  &environment_module_};
  if (light_map_fetch_module_) modules.push_back(light_map_fetch_module_.get());
  modules.insert(modules.end(), {&illumination_module_, &frame_sink_module_});
  std::vector<HostTime> times;
  for (const UnitModule* module : modules) times.push_back({module->basename(), module->host_seconds()});
  return times;
}

}  // namespace bump
