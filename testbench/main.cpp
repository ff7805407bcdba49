// The SystemC library brings `main` and calls sc_main. It also has things to say of its own: a banner on stderr before sc_main is entered, and
// informational reports on stdout, where JSON must stay JSON. Both are silenced.

#include <cstdlib>
#include <systemc>

#include "testbench/program/command_line.h"

namespace {

const int no_banner = setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);

}  // namespace

int sc_main(int argc, char* argv[]) {
  (void)no_banner;
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  return bump::command_line(argc, argv);
}
