#pragma once
// One operator of fixed-point evaluation, prepared: its constants (shifts, masks, bounds) are worked out once from the formats, and the
// kernel that suits them is chosen, on 32-bit lanes where the words fit and on 64-bit lanes otherwise.

#include <array>
#include <cstdint>
#include <memory>

#include "datapath/evaluate.h"
#include "datapath/lane_kernels.h"
#include "datapath/narrow_kernels.h"
#include "datapath/narrow_reads.h"
#include "datapath/netlist.h"

namespace bump {

/// An array of words of a block, of either size.
struct alignas(64) NarrowLane {
  std::array<std::int32_t, block_lanes> words{};
};
struct alignas(64) WideLane {
  std::array<std::int64_t, block_lanes> words{};
};
/// Where a node's words are; one of the two.
struct LanePointer {
  NarrowWords narrow = nullptr;
  Words wide = nullptr;
};

/// Where the index of a table was reflected, for the columns behind it.
struct Reflections {
  WideLane negative, beyond;
};

struct FixedStep {
  Op op = Op::input;
  bool narrow = false;  ///< runs on 32-bit lanes
  int node = -1, second_node = -1;
  std::array<int, 3> operands{-1, -1, -1};  ///< nodes whose words are read

  std::array<LanePointer, 3> in;
  LanePointer out, second_out;

  NarrowRule narrow_rule{}, narrow_other{};
  std::shared_ptr<const NarrowRead> read;
  int wide_right = -1;  ///< narrow multiply: see narrow::multiply
  RoundingRule rule{}, other_rule{};
  int left_a = 0, left_b = 0, right = 0;
  int width = 0;  ///< of the first operand
  DividerShape divider{};
  RootShape root{};
  bool by_doubles = false;  ///< wide division and root: see lane_kernels.h
  std::int64_t low = 0, high = 0;
  const Table* table = nullptr;
  const std::int64_t* words = nullptr;  ///< column on 64-bit lanes: ROM words
  Reflections* reflections = nullptr;   ///< table and column on 64-bit lanes
  std::int64_t odd_zero = 0, odd_quarter = 0;

  /// `scratch`: three lanes for operands and one for the result, for steps on 64-bit lanes between 32-bit words.
  void run(std::array<WideLane, 4>& scratch, int lanes) const;
};

/// A step for any operator but input, constant, table and column.
FixedStep arithmetic_step(const Netlist& netlist, int node);
/// Whether the node's words are those of its operand: wiring that changes nothing.
bool is_same_word(const Netlist& netlist, int node);

}  // namespace bump
