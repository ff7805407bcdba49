// Table 2's measures against a calculation by hand, and the bytes in which pictures travel.

#include <catch2/catch.hpp>
#include <cmath>

#include "testbench/experiments/frame_bytes.h"
#include "testbench/experiments/whole_frame.h"

namespace bump {
namespace {

TEST_CASE("the measures of two pixels agree with a calculation by hand") {
  // Red: reference 100, 0; test 90, 0. Green: 50, 200; 50, 210. Blue: both black but for the test's 10.
  const EightBitImage reference{2, 1, {100, 50, 0, 0, 200, 0}}, test{2, 1, {90, 50, 0, 0, 210, 10}};
  const WholeFrameMeasures m = whole_frame_measures(test, reference);
  CHECK(m.nmse[0] == Approx(100.0 / 10000));
  CHECK(m.nmse[1] == Approx(100.0 / (2500 + 40000)));
  CHECK(std::isnan(m.nmse[2]));
  CHECK(m.rnmse[0] == Approx(0.1));
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(m.pmse[c] == Approx(100.0 / (2 * 255.0 * 255.0)));
    CHECK(m.rpmse[c] == Approx(10 / (255 * std::sqrt(2.0))));
  }
}

TEST_CASE("equal pictures have no error, also where they are black") {
  const EightBitImage image{1, 2, {0, 7, 255, 0, 0, 255}};
  const WholeFrameMeasures m = whole_frame_measures(image, image);
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(m.nmse[c] == 0);
    CHECK(m.rpmse[c] == 0);
  }
}

TEST_CASE("background lowers PMSE and leaves NMSE") {
  const EightBitImage reference{1, 1, {100, 100, 100}}, test{1, 1, {80, 80, 80}};
  EightBitImage wide_reference = reference, wide_test = test;
  for (EightBitImage* image : {&wide_reference, &wide_test}) {
    image->width = 4;
    image->samples.resize(12, 0);
  }
  const WholeFrameMeasures small = whole_frame_measures(test, reference), wide = whole_frame_measures(wide_test, wide_reference);
  CHECK(wide.nmse[0] == small.nmse[0]);
  CHECK(wide.pmse[0] == Approx(small.pmse[0] / 4));
}

TEST_CASE("colours are clamped and rounded half up to 8 bits") {
  FrameBuffer frame;
  frame.width = 2;
  frame.height = 1;
  frame.colour = {-1, 0.5 / 255, 0.49 / 255, 1, 2, 254.5 / 255};
  const EightBitImage image = eight_bit(frame);
  CHECK(image.samples == std::vector<std::uint8_t>{0, 1, 0, 255, 255, 255});
}

TEST_CASE("pictures and angular errors survive the way through bytes, one after another") {
  FrameBuffer frame;
  frame.width = 1;
  frame.height = 2;
  frame.colour = {0.1, 0.2, 0.3, 0.4, 0.5, 1.0 / 3};
  frame.object = {-1, 4};
  frame.depth = {1, 0.25};
  const AngularError error{"L'", 12, 1.5, 2.5, 40};
  std::string bytes;
  append(bytes, frame);
  append(bytes, eight_bit(frame));
  append(bytes, error);
  ByteReader reader(bytes);
  FrameBuffer frame_back;
  EightBitImage image_back;
  AngularError error_back;
  reader.read(frame_back);
  reader.read(image_back);
  CHECK(!reader.at_end());
  reader.read(error_back);
  CHECK(reader.at_end());
  CHECK(frame_back.colour == frame.colour);
  CHECK(frame_back.object == frame.object);
  CHECK(frame_back.depth == frame.depth);
  CHECK(image_back.samples == eight_bit(frame).samples);
  CHECK(error_back.vector == "L'");
  CHECK(error_back.count == 12);
  CHECK(error_back.max_degrees == 40);
}

}  // namespace
}  // namespace bump
