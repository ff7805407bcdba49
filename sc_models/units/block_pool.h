#pragma once
// Fragment blocks that have been retired and can be filled again: a block is a few hundred kilobytes, so allocating one for every 256
// fragments would cost more than computing them. No hardware and no time: how many blocks are under way is bounded by the channels.

#include <memory>
#include <vector>

#include "units/fragment_block.h"

namespace bump {

class BlockPool {
 public:
  /// Blocks with `hardware_planes` and `exact_planes` planes.
  BlockPool(std::size_t hardware_planes, std::size_t exact_planes) : hardware_planes_(hardware_planes), exact_planes_(exact_planes) {}

  /// A block without lanes, triangles and records. Values of its planes are unspecified.
  std::unique_ptr<FragmentBlock> take();
  void give_back(std::unique_ptr<FragmentBlock> block);

 private:
  std::size_t hardware_planes_, exact_planes_;
  std::vector<std::unique_ptr<FragmentBlock>> free_;
};

}  // namespace bump
