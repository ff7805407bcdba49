#pragma once
// A timing trace as bytes. Numbers are unsigned, seven bits to a byte, low ones first, the top bit says that more follow; texts have their
// length in front; floating-point numbers are eight bytes, little-endian.
//
//   "bumptrc\n"  version  length of the body (eight bytes)  body  SHA-256 of all that (64 digits)
//
// A stream is its kinds (records) and its runs, each one number: (count - 1) shifted by the bits that the last kind takes, plus kind; a
// stream of one kind needs none. Every run of a shipped scene so takes a byte or two.
//
// Behind the streams stands 0, or 1 and what the fetch units read: the textures (bytes of a texel, wrap modes, whether they are filtered,
// sizes of the levels), then for each of the two caches the number of fragments and a text, the bytes of access_stream.h.

#include <cstdint>
#include <string>

#include "retiming/timing_trace.h"

namespace bump {

constexpr std::uint64_t trace_version = 2;
constexpr const char* trace_magic = "bumptrc\n";  ///< how a trace begins

std::string encode_trace(const TimingTrace& trace);

/// `name` is the file, for messages. Throws Error(input) if the bytes are no trace, one of another version, cut off, or damaged.
TimingTrace decode_trace(const std::string& bytes, const std::string& name);

}  // namespace bump
