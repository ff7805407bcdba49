#include "schemes/common/log_vector.h"

namespace bump {

void output_log_vector(Netlist& n, const std::string& name, const PolarDirection& a, Wire normal_phi, LogReads& reads) {
  const Netlist::Scope scope(n, name);
  const Netlist::Label label(n, "LNS step 1");
  const LogSineCosine of_theta = reads.both("LSC_THETA", a.theta);
  const LogSineCosine of_d = reads.both("LSC_D", n.sub("d", a.phi, normal_phi, n.format(normal_phi)));
  output_log(n, "G", reads.product("log_G", of_theta.sine, of_d.cosine));
  output_log(n, "K", reads.product("log_K", of_theta.sine, of_d.sine));
  output_log(n, "z", of_theta.cosine);
}

LogVector input_log_vector(Netlist& n, const std::string& name, const LogWidths& widths) {
  const LogValue G = input_log(n, name + ".G", widths, widths.whole_bits + 1), K = input_log(n, name + ".K", widths, widths.whole_bits + 1);
  return {G, K, input_log(n, name + ".z", widths, widths.whole_bits)};
}

}  // namespace bump
