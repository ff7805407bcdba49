// `bumpsim pareto`: which rows of a table no other row beats in two columns, as a list and as a picture.

#include <fmt/core.h>

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

}  // namespace

int pareto_command(const ParetoArguments& arguments) {
  if (!arguments.out.empty()) check_output_file(arguments.out, arguments.force);
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
