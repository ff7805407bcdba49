#pragma once
// The measures of Lee 2007's Table 2 as one takes them from two image files: 8 bits a channel, every pixel of the frame, the background
// included. The paper's formulas are lost (it refers to Al-Otum); these are the usual ones (Eskicioglu and Fisher, IEEE Transactions on
// Communications 1995) with x the picture of the method that Table 2 names, and y the proposed method's:
//   NMSE = sum (x - y)^2 / sum x^2,  PMSE = mean (x - y)^2 / 255^2,  RNMSE and RPMSE their square roots.
// A black background leaves NMSE as it is and makes PMSE smaller. For measures of the shaded surface alone, unrounded: reference/quality.h.

#include <array>
#include <cstdint>
#include <vector>

#include "units/frame_buffer.h"

namespace bump {

/// 8 bits a channel, red, green, blue interleaved, row 0 on top.
struct EightBitImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> samples;
};

/// Clamped to [0, 1] and rounded to nearest (halves up), as the frames are written to PNG files.
EightBitImage eight_bit(const FrameBuffer& frame);

/// Red, green, blue.
struct WholeFrameMeasures {
  std::array<double, 3> nmse{};   ///< NaN where the reference is black and the test is not
  std::array<double, 3> rnmse{};  ///< square root of nmse
  std::array<double, 3> pmse{};
  std::array<double, 3> rpmse{};  ///< square root of pmse
};

/// The images must be of one size, which is not zero.
WholeFrameMeasures whole_frame_measures(const EightBitImage& test, const EightBitImage& reference);

}  // namespace bump
