#include "retiming/access_stream.h"

#include <limits>

#include "datapath/error.h"
#include "datapath/invariant.h"
#include "retiming/byte_numbers.h"

namespace bump {

namespace {

enum Code : std::uint64_t { full, moves_only, moves_together, first_kind };

constexpr std::size_t most_kinds = 4096;
constexpr std::uint64_t textures_follow = 16;
constexpr std::int32_t largest_move = 1 << 30;

[[noreturn]] void contradicts(const std::string& what) {
  throw Error(ErrorKind::internal, {"the timing trace contradicts itself: " + what, {}, "", "record it again"});
}

bool is_short(std::int32_t move) {
  return move >= -8 && move <= 7;
}

bool is_short(const AccessStep& step) {
  for (const AccessStep::Move& m : step.moves)
    if (!is_short(m.level) || !is_short(m.x) || !is_short(m.y)) return false;
  return true;
}

/// Calls visit(place) for the places in use.
template <class Visit>
void for_places(const std::array<std::uint8_t, 2>& levels, const Visit& visit) {
  for (std::size_t t = 0; t < 2; ++t)
    for (std::size_t i = 0; i < levels[t]; ++i) visit(2 * t + i);
}

}  // namespace

AccessStreamBuilder::Key AccessStreamBuilder::key_of(const AccessStep& step) {
  Key key{step.levels[0], step.levels[1]};
  for (std::size_t i = 0; i < 4; ++i) {
    const AccessStep::Move& m = step.moves[i];
    key[2 + 4 * i] = m.level;
    key[3 + 4 * i] = m.x;
    key[4 + 4 * i] = m.y;
    key[5 + 4 * i] = m.sides;
  }
  return key;
}

void AccessStreamBuilder::append(const FragmentAccess& access) {
  BUMP_ASSERT(access.levels[0] <= 2 && access.levels[1] <= 2);
  ++stream_.fragments;
  AccessStep step;
  step.levels = access.levels;
  for_places(access.levels, [&](std::size_t i) {
    const Footprint &to = access.at[i], &from = last_.at[i];
    step.moves[i] = {to.level - from.level, to.x - from.x, to.y - from.y, to.sides};
  });
  const Key key = key_of(step);
  const bool same_textures = access.texture == last_.texture;
  if (run_ > 0 && same_textures && !textures_change_ && key == key_) {
    ++run_;
  } else {
    write_run();
    levels_before_ = last_.levels;
    for (std::size_t i = 0; i < 4; ++i) sides_before_[i] = last_.at[i].sides;
    step_ = step;
    key_ = key;
    run_ = 1;
    textures_change_ = !same_textures;
    last_.texture = access.texture;
  }
  last_.levels = access.levels;
  for_places(access.levels, [&](std::size_t i) { last_.at[i] = access.at[i]; });
}

std::uint64_t AccessStreamBuilder::code_of() const {
  if (textures_change_) return Code::full;
  const auto known = kinds_.find(key_);
  if (known != kinds_.end()) return Code::first_kind + known->second;
  bool only_moves = step_.levels == levels_before_, together = step_.levels[0] == step_.levels[1];
  for_places(step_.levels, [&](std::size_t i) {
    const AccessStep::Move &m = step_.moves[i], &first = step_.moves[i % 2];
    only_moves = only_moves && m.level == 0 && m.sides == sides_before_[i];
    together = together && m.x == first.x && m.y == first.y;
  });
  if (!only_moves) return Code::full;
  return together ? Code::moves_together : Code::moves_only;
}

void AccessStreamBuilder::write_step(std::uint64_t code) {
  std::string& bytes = stream_.bytes;
  if (code == Code::full) {
    put_number(bytes, step_.levels[0] | step_.levels[1] << 2U | (textures_change_ ? textures_follow : 0));
    if (textures_change_)
      for (const std::int32_t texture : last_.texture) put_number(bytes, static_cast<std::uint64_t>(texture + 1));
  }
  for_places(step_.levels, [&](std::size_t i) {
    if (code == Code::moves_together && i >= 2) return;
    const AccessStep::Move& m = step_.moves[i];
    if (code == Code::full) put_number(bytes, folded_sign(m.level));
    put_number(bytes, folded_sign(m.x));
    put_number(bytes, folded_sign(m.y));
    if (code == Code::full) put_number(bytes, m.sides);
  });
  if (!textures_change_ && kinds_.size() < most_kinds && is_short(step_)) kinds_.emplace(key_, kinds_.size());
}

void AccessStreamBuilder::write_run() {
  if (run_ == 0) return;
  const std::uint64_t code = code_of();
  put_number(stream_.bytes, code << 1U | (run_ > 1 ? 1 : 0));
  if (code < Code::first_kind) write_step(code);
  if (run_ > 1) put_number(stream_.bytes, run_ - 2);
  run_ = 0;
}

AccessStream AccessStreamBuilder::finish() {
  write_run();
  return std::move(stream_);
}

std::uint64_t AccessReader::number() {
  const std::string& bytes = stream_->bytes;
  std::uint64_t value = 0;
  for (int shift = 0; shift < 63 && at_ < bytes.size(); shift += 7) {
    const auto byte = static_cast<unsigned char>(bytes[at_++]);
    value |= std::uint64_t{byte & 0x7fU} << shift;
    if ((byte & 0x80U) == 0) return value;
  }
  contradicts("addresses that end too soon");
}

std::int32_t AccessReader::move() {
  const std::int64_t value = unfolded_sign(number());
  if (value < -largest_move || value > largest_move) contradicts("an address out of range");
  return static_cast<std::int32_t>(value);
}

void AccessReader::read_textures(std::uint64_t flags) {
  if ((flags & textures_follow) == 0) return;
  for (std::int32_t& texture : access_.texture) {
    const std::uint64_t value = number();
    if (value > std::uint64_t{largest_move}) contradicts("a texture that is not there");
    texture = static_cast<std::int32_t>(value) - 1;
  }
}

void AccessReader::read_step() {
  std::uint64_t code = number();
  const bool is_longer = (code & 1U) != 0;
  code >>= 1U;
  if (code >= Code::first_kind) {
    if (code - Code::first_kind >= kinds_.size()) contradicts("an unknown step from one address to the next");
    kind_ = kinds_[code - Code::first_kind];
  } else {
    kind_ = {};
    AccessStep& step = kind_.step;
    step.levels = access_.levels;
    std::uint64_t flags = 0;
    if (code == Code::full) {
      flags = number();
      step.levels = {static_cast<std::uint8_t>(flags & 3U), static_cast<std::uint8_t>(flags >> 2U & 3U)};
      if (step.levels[0] > 2 || step.levels[1] > 2 || flags >= 2 * textures_follow) contradicts("a fragment that reads three levels");
      read_textures(flags);
    }
    bool still = flags < textures_follow;
    for_places(step.levels, [&](std::size_t i) {
      AccessStep::Move& m = step.moves[i];
      m.sides = access_.at[i].sides;
      if (code == Code::moves_together && i >= 2) {
        m.x = step.moves[i - 2].x;
        m.y = step.moves[i - 2].y;
        return;
      }
      if (code == Code::full) m.level = move();
      m.x = move();
      m.y = move();
      if (code == Code::full) m.sides = static_cast<std::uint8_t>(number() & 3U);
    });
    for (const AccessStep::Move& m : step.moves) still = still && m.level == 0 && m.x == 0 && m.y == 0;
    kind_.still = still;
    if (flags < textures_follow && kinds_.size() < most_kinds && is_short(step)) kinds_.push_back(kind_);
  }
  left_ = 1;
  if (is_longer) left_ = number() + 2;
  if (left_ > static_cast<std::uint64_t>(stream_->fragments - done_)) contradicts("more addresses than fragments");
}

void AccessReader::apply() {
  const AccessStep& step = kind_.step;
  access_.levels = step.levels;
  for_places(step.levels, [&](std::size_t i) {
    Footprint& at = access_.at[i];
    const AccessStep::Move& m = step.moves[i];
    at.level += m.level;
    at.x += m.x;
    at.y += m.y;
    at.sides = m.sides;
  });
}

bool AccessReader::next() {
  if (left_ == 0) {
    if (done_ == stream_->fragments) {
      if (at_ != stream_->bytes.size()) contradicts("more addresses than fragments");
      return false;
    }
    read_step();
  }
  apply();
  alike_ = kind_.still ? left_ : 1;
  left_ -= alike_;
  done_ += static_cast<std::int64_t>(alike_);
  return true;
}

}  // namespace bump
