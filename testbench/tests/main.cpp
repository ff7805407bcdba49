// The SystemC library brings `main`; tests run inside sc_main so that they may elaborate modules.

#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#include <systemc>

int sc_main(int argc, char* argv[]) {
  sc_core::sc_report_handler::set_actions("/OSCI/SystemC", sc_core::SC_DO_NOTHING);
  return Catch::Session().run(argc, argv);
}
