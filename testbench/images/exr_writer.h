#pragma once
// OpenEXR files of rendered frames, written with OpenEXR's own library: 32-bit floating point, red, green, blue, a fixed date. Not
// compressed: the library's quickest compression (RLE) takes three times as long as all else and saves a third; ZIP at level 1 saves more
// than half, but takes about as long as simulating the frame. One thread, so that none of the library's is alive when the program forks. No
// model of hardware. Source: "Technical Introduction to OpenEXR", Academy Software Foundation.

#include <string>

namespace bump {

/// `colour`: width * height * 3 values, row 0 on top: red, green, blue, rounded to float.
std::string exr_of(int width, int height, const double* colour);

}  // namespace bump
