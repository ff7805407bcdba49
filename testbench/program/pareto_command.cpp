// `bumpsim pareto`: which rows of a table no other row beats in two columns, as a list and as a picture.

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "datapath/error.h"
#include "testbench/experiments/pareto.h"
#include "testbench/experiments/pareto_formats.h"
#include "testbench/experiments/result_table.h"
#include "testbench/program/commands.h"
#include "testbench/results/output_file.h"

namespace bump {

namespace {

ParetoAxis axis_of(const std::string& column, const std::string& better, bool logarithmic) {
  ParetoAxis axis;
  axis.column = column;
  axis.high_is_better = better == "high";
  axis.logarithmic = logarithmic;
  return axis;
}

std::string in_format(const ParetoFront& front, const ParetoArguments& arguments) {
  if (arguments.json || arguments.format == "json") return pareto_json(front);
  if (arguments.format == "csv") return pareto_csv(front);
  return pareto_document(front, arguments.format == "md");
}

/// A picture under the name of another format is one that no viewer opens.
void refuse_other_picture(const std::string& file) {
  std::string suffix = std::filesystem::path(file).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".svg") return;
  throw Error({suffix.empty() ? "--out '" + file + "' has no suffix" : "--out cannot write " + suffix + " files",
               {file},
               "the plot is written as SVG",
               "--out " + std::filesystem::path(file).replace_extension(".svg").string()});
}

}  // namespace

int pareto_command(const ParetoArguments& arguments) {
  if (!arguments.out.empty()) {
    refuse_other_picture(arguments.out);
    check_output_file(arguments.out, arguments.force);
  }
  const ResultTable table = read_result_table(arguments.table);
  ParetoOptions options;
  options.x = axis_of(arguments.x, arguments.x_better, arguments.log.find('x') != std::string::npos);
  options.y = axis_of(arguments.y, arguments.y_better, arguments.log.find('y') != std::string::npos);
  options.label = arguments.label;
  options.where = arguments.where;
  const ParetoFront front = pareto_front(table, options);
  if (!arguments.out.empty()) write_output_file(arguments.out, pareto_svg(front, arguments.title), arguments.force);
  fmt::print("{}", in_format(front, arguments));
  return 0;
}

}  // namespace bump
