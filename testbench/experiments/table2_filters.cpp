#include "testbench/experiments/table2_filters.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "datapath/invariant.h"

namespace bump {

namespace {

using Values = std::array<double, 4>;  // NMSE of red, green, blue; PSNR

constexpr char measured = 'm', refused = 'r';

}  // namespace

std::string draw_filtered(const Scene& scene, const Scheme& scheme, const Configuration& configuration, const std::string& filter,
                          const FrameBuffer& conventional, SimulationOptions options) {
  Configuration filtered = configuration;
  filtered.set(scheme.page().id + ".map_filter", filter, Location("table2"));
  options.engine = Engine::untimed;
  options.measure = false;
  try {
    const FrameBuffer frame = simulate(scene, scheme, filtered, options).hardware;
    const std::array<double, 3> nmse = whole_frame_measures(eight_bit(frame), eight_bit(conventional)).nmse;
    const Values values{nmse[0], nmse[1], nmse[2], compare_frames(frame, conventional).psnr_db};
    return measured + std::string(reinterpret_cast<const char*>(values.data()), sizeof values);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input) throw;
    return refused + error.text().what;
  }
}

void read_filtered(const std::string& bytes, Table2Filtered& picture) {
  BUMP_ASSERT(!bytes.empty());
  Values values;
  values.fill(std::numeric_limits<double>::quiet_NaN());
  if (bytes[0] == refused) {
    picture.refused = bytes.substr(1);
  } else {
    BUMP_ASSERT(bytes[0] == measured && bytes.size() == 1 + sizeof values);
    std::memcpy(values.data(), bytes.data() + 1, sizeof values);
  }
  std::copy_n(values.begin(), 3, picture.nmse.begin());
  picture.psnr_db = values[3];
}

}  // namespace bump
