#include <fmt/core.h>

#include "testbench/experiments/table1.h"
#include "testbench/program/commands.h"
#include "testbench/program/configure.h"
#include "testbench/results/output_file.h"

namespace bump {

int table1_command(const Table1Arguments& arguments) {
  if (!arguments.out.empty()) check_output_file(arguments.out, arguments.force);
  const Table1 table = make_table1(configure(arguments.configuration_files, arguments.settings));
  const std::string text = format_table1(table, arguments.json ? "json" : arguments.format);
  if (arguments.out.empty())
    fmt::print("{}", text);
  else
    write_output_file(arguments.out, text, arguments.force);
  return 0;
}

}  // namespace bump
