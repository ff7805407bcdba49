#include "datapath/error.h"
#include "testbench/program/commands.h"

namespace bump {

int table1_command(const Table1Arguments&) { throw Error(ErrorKind::internal, {"not built yet", {}, "", ""}); }

}  // namespace bump
