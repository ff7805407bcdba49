#pragma once
// BUMP_LANE_LOOP in front of a function builds it for AVX2 as well and lets the machine choose when the program starts. Sanitizers and
// other processors build it once.

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(undefined_behavior_sanitizer)
#define BUMP_LANES_SANITIZED 1
#endif
#endif

#if defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(BUMP_LANES_SANITIZED)
#define BUMP_LANE_LOOP __attribute__((target_clones("avx2", "default")))
#else
#define BUMP_LANE_LOOP
#endif
