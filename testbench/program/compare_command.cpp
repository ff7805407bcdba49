#include "datapath/error.h"
#include "testbench/program/commands.h"

namespace bump {

int compare_command(const CompareArguments&) { throw Error(ErrorKind::internal, {"not built yet", {}, "", ""}); }

}  // namespace bump
