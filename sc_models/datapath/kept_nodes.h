#pragma once
// Which nodes of a netlist keep their words or values after an evaluation, because somebody has asked for them: the first few one by one,
// as a pipeline does that watches a flag; then all, as a probe does that prints them.

#include <cstddef>
#include <vector>

namespace bump {

class KeptNodes {
 public:
  explicit KeptNodes(std::size_t nodes) : kept_(nodes, false) {}

  std::size_t size() const { return kept_.size(); }
  bool operator[](std::size_t node) const { return kept_[node]; }
  const std::vector<bool>& all() const { return kept_; }
  void keep(std::size_t node) {
    constexpr int singly = 8;
    kept_[node] = true;
    if (++times_ > singly) kept_.assign(kept_.size(), true);
  }

 private:
  std::vector<bool> kept_;
  int times_ = 0;
};

}  // namespace bump
