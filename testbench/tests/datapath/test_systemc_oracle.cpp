// The rounding rule against SystemC's own fixed-point types: SC_TRN with SC_WRAP is truncation towards minus infinity and wrap-around,
// SC_RND with SC_SAT is rounding to nearest (halves up) and saturation.
#define SC_INCLUDE_FX
#include <catch2/catch.hpp>
#include <systemc>

#include "datapath/evaluate.h"
#include "random_netlist.h"

using namespace bump;
using namespace bump_test;

namespace {

/// `exact` stored in a word of the format.
double stored(const sc_dt::sc_fxval& exact, const Format& to, sc_dt::sc_q_mode rounding, sc_dt::sc_o_mode overflow) {
  if (to.is_signed) return sc_dt::sc_fix(exact, to.width, to.width - to.fraction, rounding, overflow).to_double();
  return sc_dt::sc_ufix(exact, to.width, to.width - to.fraction, rounding, overflow).to_double();
}

Format short_format(Random& random) {
  const int width = random.integer(2, 24), fraction = random.integer(-2, 26);
  return random.coin() ? sfixed(width, fraction) : ufixed(width, fraction);
}

}  // namespace

TEST_CASE("sums, differences and products equal sc_fixed with truncation and wrap-around") {
  Random random(1997);
  for (int i = 0; i < 1500; ++i) {
    const Format fa = short_format(random), fb = short_format(random), to = short_format(random);
    Netlist n("unit");
    const Wire a = n.input("a", fa), b = n.input("b", fb);
    n.output("sum", n.add("sum", a, b, to));
    n.output("difference", n.sub("difference", a, b, to));
    n.output("product", n.mul("product", a, b, to));
    const Wire sign = n.is_negative("sign", n.shift("signed", b, 0, sfixed(fb.width + 1, fb.fraction)));
    n.output("either", n.add_sub("either", sign, a, b, to));
    const auto evaluator = make_evaluator(n, Arithmetic::fixed);
    for (int j = 0; j < 4; ++j) {
      const double x = to_double(quantise(random_value(random, fa), fa), fa), y = to_double(quantise(random_value(random, fb), fb), fb);
      const double* in[] = {&x, &y};
      double sum = 0, difference = 0, product = 0, either = 0;
      double* out[] = {&sum, &difference, &product, &either};
      evaluator->evaluate(in, 1, out);
      const sc_dt::sc_fxval u(x), v(y);
      INFO(to_string(fa) << " " << x << ", " << to_string(fb) << " " << y << " to " << to_string(to));
      REQUIRE(sum == stored(u + v, to, sc_dt::SC_TRN, sc_dt::SC_WRAP));
      REQUIRE(difference == stored(u - v, to, sc_dt::SC_TRN, sc_dt::SC_WRAP));
      REQUIRE(either == stored(y < 0 ? u - v : u + v, to, sc_dt::SC_TRN, sc_dt::SC_WRAP));
      REQUIRE(product == stored(u * v, to, sc_dt::SC_TRN, sc_dt::SC_WRAP));
    }
  }
}

TEST_CASE("numbers enter as sc_fixed with rounding and saturation, angles with wrap-around") {
  Random random(1998);
  for (int i = 0; i < 5000; ++i) {
    const bool is_turn = i % 3 == 0;
    const Format to = is_turn ? turns(random.integer(2, 24)) : short_format(random);
    const double value = random_value(random, to);
    INFO(to_string(to) << " " << value);
    REQUIRE(to_double(quantise(value, to), to) ==
            stored(sc_dt::sc_fxval(value), to, sc_dt::SC_RND, is_turn ? sc_dt::SC_WRAP : sc_dt::SC_SAT));
  }
}
