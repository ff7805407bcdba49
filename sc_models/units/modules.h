#pragma once
// The units as SystemC modules of the functional plane: each a thread that takes a block, lets the unit's behaviour work on it, and passes
// it on. A Kahn network without time: values never depend on dates. An Error raised in a thread would lose its type on its way through the
// SystemC kernel, so it is kept in a Failure, and the simulation stops.

#include <exception>
#include <functional>
#include <systemc>
#include <utility>

#include "channels/block_fifo.h"
#include "units/block_pool.h"
#include "units/frame_sink.h"
#include "units/host_clock.h"
#include "units/rasterizer.h"
#include "units/triangle_block.h"
#include "units/triangle_setup.h"
#include "units/vertex_processor.h"

namespace bump {

/// What went wrong in a thread, first one wins; rethrow it after sc_start() has returned.
struct Failure {
  std::exception_ptr what;
  void rethrow() const {
    if (what) std::rethrow_exception(what);
  }
};

/// A module with one thread, `work`.
class UnitModule : public sc_core::sc_module {
 public:
  UnitModule(const sc_core::sc_module_name& name, Failure& failure) : sc_module(name), failure_(failure) {
    SC_HAS_PROCESS(UnitModule);
    SC_THREAD(guard);
  }
  /// What the host has spent on the unit so far, without waiting.
  double host_seconds() const { return host_clock_.seconds(); }

 protected:
  virtual void work() = 0;
  HostClock host_clock_;  ///< to be stopped around whatever may wait

 private:
  void guard();
  Failure& failure_;
};

class VertexProcessorModule : public UnitModule {
 public:
  /// `progress`, if given, is called with the triangles sent so far; it may throw.
  VertexProcessorModule(const sc_core::sc_module_name& name, Failure& failure, VertexProcessor& unit, BlockFifo<TriangleBlock>& out,
                        std::function<void(std::int64_t)> progress = {})
      : UnitModule(name, failure), unit_(unit), out_triangles_(out), progress_(std::move(progress)) {}

 private:
  void work() override;
  VertexProcessor& unit_;
  BlockFifo<TriangleBlock>& out_triangles_;
  std::function<void(std::int64_t)> progress_;
};

/// A unit that works on blocks in place: Behaviour has `void process(Block&)`.
template <class Behaviour, class Block>
class BlockModule : public UnitModule {
 public:
  BlockModule(const sc_core::sc_module_name& name, Failure& failure, Behaviour& unit, BlockFifo<Block>& in, BlockFifo<Block>& out)
      : UnitModule(name, failure), unit_(unit), in_blocks_(in), out_blocks_(out) {}

 private:
  void work() override {
    while (std::unique_ptr<Block> block = in_blocks_.read()) {
      host_clock_.start();
      unit_.process(*block);
      host_clock_.stop();
      out_blocks_.write(std::move(block));
    }
    out_blocks_.close();
  }
  Behaviour& unit_;
  BlockFifo<Block>&in_blocks_, &out_blocks_;
};

using TriangleSetupModule = BlockModule<TriangleSetup, TriangleBlock>;
template <class Behaviour>
using FragmentModule = BlockModule<Behaviour, FragmentBlock>;

class RasterizerModule : public UnitModule {
 public:
  RasterizerModule(const sc_core::sc_module_name& name, Failure& failure, std::shared_ptr<const PipelineContext> context,
                   const RasterizerConfig& config, std::shared_ptr<BlockPool> pool, BlockFifo<TriangleBlock>& in,
                   BlockFifo<FragmentBlock>& out)
      : UnitModule(name, failure),
        unit_(std::move(context), config, std::move(pool),
              [this, &out](std::unique_ptr<FragmentBlock> block) {
                host_clock_.stop();
                out.write(std::move(block));
                host_clock_.start();
              }),
        in_triangles_(in),
        out_fragments_(out) {}
  const Rasterizer& unit() const { return unit_; }

 private:
  void work() override;
  Rasterizer unit_;
  BlockFifo<TriangleBlock>& in_triangles_;
  BlockFifo<FragmentBlock>& out_fragments_;
};

class FrameSinkModule : public UnitModule {
 public:
  /// `retire` sees every block, with its timing records, after it has been drawn; it may wait. Then the block returns to the pool.
  FrameSinkModule(const sc_core::sc_module_name& name, Failure& failure, FrameSink& unit, std::shared_ptr<BlockPool> pool,
                  BlockFifo<FragmentBlock>& in, std::function<void(const FragmentBlock&)> retire)
      : UnitModule(name, failure), unit_(unit), pool_(std::move(pool)), in_fragments_(in), retire_(std::move(retire)) {}

 private:
  void work() override;
  FrameSink& unit_;
  std::shared_ptr<BlockPool> pool_;
  BlockFifo<FragmentBlock>& in_fragments_;
  std::function<void(const FragmentBlock&)> retire_;
};

}  // namespace bump
