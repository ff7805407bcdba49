#pragma once
// The functional plane of one run: the units as SystemC modules, joined by channels of blocks, ending in a stream of timing records for
// whichever engine dates them.
//
//   vertex_processor -> triangle_setup -> rasterizer -> interpolators -> texture_fetch -> environment [-> light_map_fetch] -> illumination
//   (and colour)
//                    -> frame_sink
//
// The light-map fetch unit is there only if the design has light maps.

#include <functional>
#include <memory>

#include "system/timing_feed.h"
#include "units/colour_unit.h"
#include "units/environment_unit.h"
#include "units/illumination_unit.h"
#include "units/interpolators.h"
#include "units/light_map_fetch.h"
#include "units/modules.h"
#include "units/texture_fetch.h"

namespace bump {

class Pipeline : public sc_core::sc_module {
 public:
  /// `watch` is called with the triangles that have entered, from time to time; it may throw to end the simulation.
  Pipeline(const sc_core::sc_module_name& name, std::shared_ptr<const PipelineContext> context, const Configuration& configuration,
           std::function<void(std::int64_t)> watch);

  BlockFifo<TimingRecords>& out_records() { return out_records_; }
  Failure& failure() { return failure_; }

  // The units, for their counters and netlists.
  const VertexProcessor& vertex_processor() const { return vertex_processor_; }
  const TriangleSetup& triangle_setup() const { return triangle_setup_; }
  const Rasterizer& rasterizer() const { return rasterizer_module_.unit(); }
  const Interpolators& interpolators() const { return interpolators_; }
  const TextureFetch& texture_fetch() const { return texture_fetch_; }
  const EnvironmentUnit& environment() const { return environment_; }
  /// Null if the design has no light maps.
  const LightMapFetch* light_map_fetch() const { return light_map_fetch_.get(); }
  const IlluminationUnit& illumination() const { return illumination_; }
  const ColourUnit& colour() const { return colour_; }
  const FrameSink& frame_sink() const { return frame_sink_; }
  FrameSink::Drawn release_frames(bool with_exact) { return frame_sink_.release(with_exact); }

  /// `retired` is shown every block after it has been drawn, before its records leave; before the simulation.
  void show_retired(std::function<void(const FragmentBlock&)> retired) { retired_ = std::move(retired); }
  /// Tells a listener what the fetch units read; before the simulation. It must outlive this.
  void listen(AccessListener& listener);
  /// What the host has spent on each unit, in the order of the pipeline.
  std::vector<HostTime> host_times() const;

 private:
  /// The illumination unit with the colour unit behind it: one stage of the pipeline.
  struct Shading {
    IlluminationUnit& illumination;
    ColourUnit& colour;
    void process(FragmentBlock& block) {
      illumination.process(block);
      colour.process(block);
    }
  };

  std::function<void(std::int64_t)> watch_;
  std::function<void(const FragmentBlock&)> retired_;
  Failure failure_;
  std::shared_ptr<BlockPool> pool_;

  VertexProcessor vertex_processor_;
  TriangleSetup triangle_setup_;
  Interpolators interpolators_;
  TextureFetch texture_fetch_;
  EnvironmentUnit environment_;
  std::unique_ptr<LightMapFetch> light_map_fetch_;
  IlluminationUnit illumination_;
  ColourUnit colour_;
  Shading shading_;
  FrameSink frame_sink_;

  BlockFifo<TriangleBlock> triangles_, set_up_triangles_;
  BlockFifo<FragmentBlock> fragments_, interpolated_, textured_, lit_, shaded_;
  std::unique_ptr<BlockFifo<FragmentBlock>> light_mapped_;
  BlockFifo<TimingRecords> out_records_;

  VertexProcessorModule vertex_processor_module_;
  TriangleSetupModule triangle_setup_module_;
  RasterizerModule rasterizer_module_;
  FragmentModule<Interpolators> interpolators_module_;
  FragmentModule<TextureFetch> texture_fetch_module_;
  FragmentModule<EnvironmentUnit> environment_module_;
  std::unique_ptr<FragmentModule<LightMapFetch>> light_map_fetch_module_;
  FragmentModule<Shading> illumination_module_;
  FrameSinkModule frame_sink_module_;
};

}  // namespace bump
