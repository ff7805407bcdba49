#include "testbench/experiments/child_message.h"

#include <cstdint>
#include <cstring>
#include <utility>

#include "datapath/invariant.h"

// Each message is a tag and its content: a share a double; a result its bytes; an error int32 kind, the texts what, file, why, try (uint64
// length and bytes each), int32 line and column.

namespace bump {

namespace {

constexpr char share_tag = 'p', result_tag = 'r', error_tag = 'e';
constexpr std::size_t share_size = 1 + sizeof(double);

template <class Number>
void append(std::string& to, Number number) {
  to.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void append(std::string& to, const std::string& text) {
  append(to, static_cast<std::uint64_t>(text.size()));
  to += text;
}

template <class Number>
Number take(const std::string& from, std::size_t& at) {
  BUMP_ASSERT(from.size() - at >= sizeof(Number));
  Number number;
  std::memcpy(&number, from.data() + at, sizeof number);
  at += sizeof number;
  return number;
}

std::string take_text(const std::string& from, std::size_t& at) {
  const auto length = take<std::uint64_t>(from, at);
  BUMP_ASSERT(from.size() - at >= length);
  at += length;
  return from.substr(at - length, length);
}

Error error_in(const std::string& bytes, std::size_t at) {
  const auto kind = static_cast<ErrorKind>(take<std::int32_t>(bytes, at));
  ErrorText text;
  for (std::string* part : {&text.what, &text.where.file, &text.why, &text.try_this}) *part = take_text(bytes, at);
  text.where.line = take<std::int32_t>(bytes, at);
  text.where.column = take<std::int32_t>(bytes, at);
  return Error(kind, text);
}

}  // namespace

std::string share_message(double share) {
  std::string bytes(1, share_tag);
  append(bytes, share);
  return bytes;
}

std::string result_message(std::string bytes) {
  bytes.insert(bytes.begin(), result_tag);
  return bytes;
}

std::string error_message(const Error& error) {
  const ErrorText& text = error.text();
  std::string bytes(1, error_tag);
  append(bytes, static_cast<std::int32_t>(error.kind()));
  for (const std::string* part : {&text.what, &text.where.file, &text.why, &text.try_this}) append(bytes, *part);
  append(bytes, static_cast<std::int32_t>(text.where.line));
  append(bytes, static_cast<std::int32_t>(text.where.column));
  return bytes;
}

void take_shares(std::string& received, double& share) {
  std::size_t used = 0;
  while (received.size() - used >= share_size && received[used] == share_tag) {
    std::size_t at = used + 1;
    share = take<double>(received, at);
    used = at;
  }
  if (used > 0) received.erase(0, used);
}

bool take_outcome(std::string received, ChildOutcome& outcome) {
  if (received.empty() || received.front() == share_tag) return false;
  if (received.front() == error_tag) {
    outcome.error = error_in(received, 1);
  } else {
    received.erase(0, 1);
    outcome.bytes = std::move(received);
  }
  return true;
}

}  // namespace bump
