#pragma once
// How good an image is, in the measures of Lee 2007 (Table 2) and in decibels, over the pixels in which two frames show the same surface.
// Pixels on a silhouette that one frame gives to another surface say something about rasterization, not about bump mapping: they are left
// out and counted. The formulas are missing from the paper; NMSE and PMSE follow Eskicioglu and Fisher, "Image quality measures and their
// performance", IEEE Transactions on Communications 1995, as is usual. Table 2 averages whole frames, black background included, so its
// PMSE depends on the share of the background; here the background is left out.

#include <array>
#include <cstdint>
#include <vector>

#include "units/frame_buffer.h"

namespace bump {

/// Measures over `pixels` pixels; channels are red, green, blue; colours are unrounded, peak 1. With no pixels to compare all measures are
/// NaN.
struct Quality {
  double psnr_db = 0;             ///< 10 log10(1 / mean squared error), channels pooled; infinite for identical images
  std::array<double, 3> nmse{};   ///< sum (reference - test)^2 / sum reference^2; NaN where the reference is black and the test is not
  std::array<double, 3> rnmse{};  ///< square root of nmse
  std::array<double, 3> pmse{};   ///< mean (reference - test)^2 / peak^2
  std::array<double, 3> rpmse{};  ///< square root of pmse
  double max_error = 0;           ///< largest absolute difference of a channel, in steps of an 8-bit image (of 255)
  double mean_error = 0;          ///< mean absolute difference of all channels, in steps of an 8-bit image
  std::int64_t pixels = 0;        ///< compared
  std::int64_t excluded = 0;      ///< an object in either frame, but not the same surface in both
};

/// True if pixel (x, y) shows the same surface in both frames: the same object, and depths that differ by less than the reference's depth
/// changes over half a pixel (its own slope, from the flatter neighbour on each axis), or by less than a 24-bit depth step.
bool same_surface(const FrameBuffer& test, const FrameBuffer& reference, int x, int y);

/// The frames must be of one size. Pixels of the test frame that `left_out` marks (not 0; may be null) are taken for background, so where
/// the reference shows an object they are excluded.
Quality compare_frames(const FrameBuffer& test, const FrameBuffer& reference, const std::vector<std::uint8_t>* left_out = nullptr);

/// The absolute error as a picture: the largest error of the three channels on a logarithmic scale of 8-bit steps, from black (none) over
/// blue (3 of 255), red (15) and yellow (63) to white (255); in between linear in log2(1 + error). Excluded pixels are green, background
/// black. `threads` share the rows. Hand the reference over if it is of no further use: the picture takes its place.
FrameBuffer error_image(const FrameBuffer& test, FrameBuffer reference, int threads = 1);

}  // namespace bump
