#include "testbench/results/image_file.h"

#include "testbench/images/exr_writer.h"
#include "testbench/images/png_writer.h"
#include "testbench/reference/cores.h"
#include "testbench/reference/row_bands.h"

namespace bump {

std::string encode_png(const FrameBuffer& frame) {
  return png_of(frame.width, frame.height, frame.colour.data());
}

std::string encode_exr(const FrameBuffer& frame) {
  return exr_of(frame.width, frame.height, frame.colour.data());
}

FrameFiles encode_both(const FrameBuffer& frame) {
  FrameFiles files;
  for_row_bands(2, 1, cores_of_process(), [&](int which, int) {
    if (which == 0)
      files.png = encode_png(frame);
    else
      files.exr = encode_exr(frame);
  });
  return files;
}

}  // namespace bump
