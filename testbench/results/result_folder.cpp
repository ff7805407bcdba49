#include "testbench/results/result_folder.h"

#include "testbench/results/image_file.h"
#include "testbench/results/pending_folder.h"
#include "testbench/results/result_json.h"
#include "testbench/results/statistics_table.h"

namespace bump {

void write_result(const std::string& out, const RunReport& report, bool force) {
  PendingFolder folder(out, force);
  folder.write("config.resolved.toml", report.resolved_toml);
  folder.write("stats.csv", to_csv(statistic_rows(report)));
  const FrameFiles files = encode_both(report.result->hardware);
  folder.write("frame.png", files.png);
  folder.write("frame.exr", files.exr);
  if (report.error_picture) folder.write("error.png", encode_png(*report.error_picture));
  folder.write("result.json", json_text(report));  // last: without it a folder is no result
  folder.commit();
}

}  // namespace bump
