// A SystemC program that does nothing: what starting `bumpsim` is measured against.

#include <systemc>

int sc_main(int, char*[]) {
  return 0;
}
