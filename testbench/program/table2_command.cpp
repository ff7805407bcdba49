#include "datapath/error.h"
#include "testbench/program/commands.h"

namespace bump {

int table2_command(const Table2Arguments&) { throw Error(ErrorKind::internal, {"not built yet", {}, "", ""}); }

}  // namespace bump
