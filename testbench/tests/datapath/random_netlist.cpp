#include "random_netlist.h"

#include <cmath>
#include <set>
#include <string>

#include "datapath/error.h"

namespace bump_test {

using namespace bump;

Format random_format(Random& random) {
  // Mostly narrow words, some of any width, some about the widths at which evaluation changes its lanes or its way.
  const int kind = random.integer(0, 15);
  const int width = kind < 2   ? random.integer(1, 62)
                    : kind < 4 ? random.integer(30, 34)
                    : kind < 5 ? random.integer(48, 52)
                    : kind < 7 ? random.integer(15, 17)
                               : random.integer(1, 20);
  if (random.integer(0, 3) == 0) return turns(random.integer(0, 5) == 0 ? random.integer(30, 34) : random.integer(2, 16));
  const int fraction = random.integer(-3, width + 6);
  return random.coin() ? sfixed(width, fraction) : ufixed(width, fraction);
}

double random_value(Random& random, const Format& format) {
  const double step = format.step();
  switch (random.integer(0, 6)) {
    case 0:
      return format.lowest();
    case 1:
      return format.highest();
    case 2:
      return 0;
    case 3:
      return random.real(2 * format.lowest() - step, 2 * format.highest() + step);
    case 4:
      return (std::floor(random.real(format.lowest(), format.highest()) / step) + 0.5) * step;
    default:
      return random.real(format.lowest(), format.highest());
  }
}

TablePtr random_table(Random& random, const std::string& name) {
  Table table;
  table.name = name;
  table.folding = static_cast<Folding>(random.integer(0, 3));
  const int fields = std::max(0, random.integer(-5, 2));
  table.address_bits = random.integer(1, fields == 0 ? 8 : 5);
  const int width = random.integer(2, fields == 0 ? 10 : 5);
  Column first;
  first.name = "first";
  if (table.folding == Folding::quarter) {
    table.index = turns(width);
    first.function = [](double x) { return 0.9 * std::sin(6.283185307179586 * x); };
    first.symmetry.odd_about_zero = true;
  } else if (table.folding == Folding::magnitude) {
    table.index = sfixed(width, random.integer(0, width));
    first.function = [](double x) { return std::atan(x); };
    first.symmetry.odd_about_zero = true;
  } else if (table.folding == Folding::floating) {
    table.index = ufixed(width, random.integer(0, width));
    table.exponent_bits = random.integer(0, std::min(4, table.address_bits));
    table.min_exponent = random.integer(-8, 3);
    first.function = [](double x) { return 1 / (x + 0.1); };
  } else {
    table.index = random.coin() ? sfixed(width, random.integer(0, width)) : ufixed(width, random.integer(0, width));
    first.function = [](double x) { return x * x - x / 3; };
  }
  first.format = sfixed(random.integer(0, 3) == 0 ? random.integer(15, 34) : random.integer(3, 16), random.integer(0, 12));
  table.columns.push_back(first);
  if (table.folding == Folding::quarter) {
    Column mirrored = first;
    mirrored.name = "mirrored";
    mirrored.function = [](double x) { return 0.9 * std::cos(6.283185307179586 * x); };
    mirrored.symmetry = {false, true};
    mirrored.mirrors_first = fields == 0 && table.address_bits <= width - 2;  // an address that no code reaches has no word to compare with
    table.columns.push_back(mirrored);
  }
  Column even;
  even.name = "even";
  even.function = [](double x) { return std::cos(x) - 0.3; };
  const int even_bits = random.integer(0, 3) == 0 ? random.integer(15, 34) : random.integer(2, 12);
  even.format = random.coin() ? sfixed(even_bits, 8) : random.coin() ? ufixed(even_bits, 8) : turns(8);
  table.columns.push_back(even);
  for (int i = 0; i < fields; ++i) {
    const int bits = random.integer(1, 4);
    table.fields.push_back({random.coin() ? sfixed(bits, random.integer(0, 4)) : turns(bits + 1), random.integer(1, 4)});
  }
  if (fields == 0) return std::make_shared<const Table>(table);
  for (Column& column : table.columns) {
    column.map_function = [f = column.function, fields](const double* x) {
      double weight = 1;
      for (int i = 1; i <= fields; ++i) weight += i * std::fabs(x[i]);
      return f(x[0]) / weight;
    };
    column.function = nullptr;
  }
  return std::make_shared<const Table>(table);
}

namespace {

Wire pick(Random& random, const std::vector<Wire>& wires) {
  return wires[static_cast<std::size_t>(random.integer(0, static_cast<int>(wires.size()) - 1))];
}

/// Tries one random operator; throws when it breaks a rule.
Wire record(Random& random, Netlist& n, const std::vector<Wire>& wires, const std::string& name) {
  const Wire a = pick(random, wires), b = pick(random, wires), c = pick(random, wires);
  const Format to = random_format(random);
  switch (random.integer(0, 20)) {
    case 0:
      return n.add(name, a, b, to);
    case 1:
      return n.sub(name, a, b, to);
    case 2:
    case 3:
      return n.mul(name, a, b, to);
    case 4:
      return n.div(name, a, b, to);
    case 5:
      return n.sqrt(name, a, to);
    case 6:
      return n.shift(name, a, random.integer(-4, 4), to);
    case 7:
      return n.negate(name, a, to);
    case 8:
      return n.absolute(name, a, to);
    case 9:
      return n.half_turn(name, a);
    case 10: {
      const double low = random.real(-2, 1) * to.highest();
      return n.clamp(name, a, low, low + random.real(0, 2) * to.highest(), to);
    }
    case 11:
      return n.select(name, a, b, c, to);
    case 12:
      return n.is_negative(name, a);
    case 13:
      return n.is_beyond_quarter(name, a);
    case 14:
      return n.constant(name, random_value(random, to), to);
    case 15: {
      const int low_bits = random.integer(1, 12);
      const Wire low = n.shift(name + "_low", b, random.integer(-4, 4), ufixed(low_bits, low_bits + n.format(a).fraction));
      return n.join(name, a, low, to);
    }
    case 16:
      return n.join(name, a, b, to);
    case 17: {
      const Wire flag_wire = n.format(a) == flag() ? a : n.is_negative(name + "_sign", a);
      return n.add_sub(name, flag_wire, b, c, to);
    }
    case 18: {
      const Wire places = n.shift(name + "_places", b, random.integer(-4, 4), ufixed(random.integer(1, random.coin() ? 6 : 40), 0));
      return n.shift_by(name, a, places, to);
    }
    case 19: {
      const auto flag_of = [&](const Wire& wire, const std::string& which) {
        return n.format(wire) == flag() ? wire : n.is_negative(name + which, wire);
      };
      const Wire first = flag_of(a, "_first");
      return n.exclusive_or(name, first, flag_of(b, "_second"));
    }
    default: {
      const TablePtr table = random_table(random, name + "_ROM");
      std::vector<Wire> index{n.shift(name + "_index", a, random.integer(-2, 2), table->index)};
      for (const MapField& field : table->fields)
        index.push_back(n.shift(name + "_index" + std::to_string(index.size()), pick(random, wires), random.integer(-2, 2), field.index));
      const Wire read = n.table(name, table, index).back();
      return table->is_map() || random.coin() ? read : n.second_port(name + "_again", table, index.front()).back();
    }
  }
}

}  // namespace

Netlist random_netlist(Random& random, int size) {
  Netlist n("random");
  std::vector<Wire> wires;
  for (int i = 0; i < 4; ++i) wires.push_back(n.input("in" + std::to_string(i), random_format(random)));
  wires.push_back(n.input("flag", flag()));
  for (int i = 0; i < size; ++i) {
    try {
      wires.push_back(record(random, n, wires, "n" + std::to_string(i)));
    } catch (const Error&) {
      // Breaks a rule of the netlist: nothing was recorded under this name, the next try has another.
    }
  }
  std::set<int> read;
  for (const Node& node : n.nodes()) read.insert(node.operands.begin(), node.operands.end());
  for (int i = 0; i < static_cast<int>(n.nodes().size()); ++i)
    if (read.count(i) == 0) n.output("out" + std::to_string(i), Wire{i});
  return n;
}

}  // namespace bump_test
