#include "rtl/datapath_module.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <regex>
#include <set>

#include "datapath/evaluate.h"
#include "datapath/invariant.h"
#include "datapath/register_plan.h"
#include "datapath/rom_cache.h"
#include "rtl/adder_subtractor_module.h"
#include "rtl/divider_module.h"
#include "rtl/operator_text.h"
#include "rtl/shared_multipliers.h"
#include "rtl/square_root_module.h"
#include "rtl/table_module.h"

namespace bump {

namespace {

/// Names that the emission forms from those of nodes, or has for itself: nodes that are called so get another name.
const std::regex derived_names(
    "(.*_(c[0-9]+|next|exact|full|word|first|first_[0-9]+|index[0-9]+|column[0-9]+|factor[0-9]|operator|rom)|multiplier[0-9]+_.*|in_.*|out_"
    ".*|clk|"
    "phase)");

class DatapathText {
 public:
  DatapathText(const std::string& scheme, const std::string& unit, const Netlist& netlist, const Schedule& schedule)
      : scheme_(scheme),
        netlist_(netlist),
        schedule_(schedule),
        interval_(schedule.initiation_interval),
        plan_(netlist, schedule, interval_),
        multipliers_(interval_ > 1 ? shared_multipliers(netlist, schedule) : std::vector<SharedMultiplier>{}) {
    module_.name = verilog_identifier(scheme) + "_" + verilog_identifier(unit) + "_datapath";
    module_.latency = schedule.latency;
    module_.initiation_interval = interval_;
    name_nodes();
    find_views();
  }

  DatapathModule module() {
    std::string body;
    for (std::size_t i = 0; i < multipliers_.size(); ++i) body += multipliers_[i].declaration(static_cast<int>(i));
    for (int i = 0; i < count(); ++i) body += node_text(i);
    for (std::size_t i = 0; i < multipliers_.size(); ++i) body += shared_text(i);
    body += outputs_text();
    const VerilogModule text = verilog_module(module_.name, comment(), header() + body + "endmodule\n");
    module_.text = text.text;
    return std::move(module_);
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int count() const { return static_cast<int>(netlist_.nodes().size()); }
  const Node& node(int i) const { return netlist_.nodes()[at(i)]; }
  int cycles(int i) const { return schedule_.finish[at(i)] - schedule_.start[at(i)]; }
  /// The node whose operator makes the word: of a column, the table.
  int made_by(int i) const { return node(i).op == Op::column ? node(i).operands[0] : i; }
  bool is_registered(int i) const { return cycles(made_by(i)) > 0; }

  // Names

  void name_nodes() {
    std::set<std::string> taken;
    for (const Node& n : netlist_.nodes()) {
      std::string name = verilog_identifier(n.name);
      if (std::regex_match(name, derived_names)) name += "_";
      for (int again = 2; !taken.insert(name).second; ++again) name = verilog_identifier(n.name) + "_" + std::to_string(again) + "_";
      names_.push_back(name);
    }
    for (const Netlist::Port& port : netlist_.inputs())
      module_.inputs.push_back({port.name, names_[at(port.node)], node(port.node).format});
    taken.clear();
    for (const Netlist::Port& port : netlist_.outputs()) {
      const std::string name = verilog_identifier(port.name);
      BUMP_ASSERT(taken.insert(name).second);
      module_.outputs.push_back({port.name, name, node(port.node).format});
    }
  }

  std::string made_name(int i) const {
    if (node(i).op == Op::input) return "in_" + names_[at(i)];
    return names_[at(i)] + (is_registered(i) ? "_next" : "");
  }
  std::string name_at(int i, const WordPlace& place) const {
    switch (place.from) {
      case WordPlace::From::fixed:
        return names_[at(i)];
      case WordPlace::From::made:
        return made_name(i);
      case WordPlace::From::held:
        break;
      case WordPlace::From::view: {
        int root = i;
        while (plan_.is_view(root)) root = node(root).operands[0];
        const WordPlace of_root = plan_.place(root, place.cycle);
        if (of_root.from == WordPlace::From::made) return names_[at(i)] + (is_registered(root) ? "_next" : "");
        break;
      }
    }
    return fmt::format("{}_c{}", names_[at(i)], place.cycle);
  }
  /// The word in a cycle in which it is there.
  WordText word(int i, int cycle) const { return word_text(name_at(i, plan_.place(i, cycle)), node(i).format); }
  std::vector<WordText> operands_at(int i, int cycle) const {
    std::vector<WordText> words;
    for (const int operand : node(i).operands) words.push_back(word(operand, cycle));
    return words;
  }

  // Which views are formed at which places

  void find_views() {
    for (int i = 0; i < count(); ++i)
      if (!plan_.is_view(i) && !plan_.is_fixed(i) && node(i).op != Op::column)
        for (const int operand : node(i).operands) need(operand, schedule_.start[at(i)]);
    for (const Netlist::Port& port : netlist_.outputs()) need(port.node, schedule_.latency);
    for (const HeldWord& held : plan_.registers()) need(held.node, held.cycle - 1);
  }
  void need(int i, int cycle) {
    const WordPlace place = plan_.place(i, cycle);
    if (place.from != WordPlace::From::view || !views_.insert({i, place.cycle}).second) return;
    need(node(i).operands[0], place.cycle);
  }

  // Nodes

  std::string node_text(int i) {
    if (node(i).op == Op::input) return registers_text(i);
    std::string text = fmt::format("\n  // {}\n", describe(i));
    if (plan_.is_fixed(i)) {
      if (node(i).op != Op::constant && node(i).op != Op::column) module_.folded.push_back(node(i).name);
      return text + fixed_text(i);
    }
    if (plan_.is_view(i)) return text + views_text(i) + registers_text(i);
    switch (node(i).op) {
      case Op::div:
      case Op::sqrt:
      case Op::add_sub:
        text += leaf_text(i);
        break;
      case Op::table:
        text += table_text(i);
        break;
      case Op::column:
        break;
      case Op::mul:
        text += multipliers_.empty() ? product_text(i) : shared_product_text(i);
        break;
      default:
        text +=
            staged(i, [&](const std::string& result) { return operator_text(node(i), result, operands_at(i, schedule_.start[at(i)])); });
        break;
    }
    return text + registers_text(i);
  }

  std::string describe(int i) const {
    const Node& n = node(i);
    std::string text = n.equation.empty() ? "" : n.equation + ": ";
    text += fmt::format("{} = {}", n.name, name_of(n.op));
    for (const int operand : n.operands) text += (operand == n.operands.front() ? " " : ", ") + node(operand).name;
    if (n.op == Op::constant) text += fmt::format(" {:.9g}", n.value);
    if (n.op == Op::shift) text += fmt::format(" by 2^{}", n.amount);
    if (n.op == Op::clamp) text += fmt::format(" to [{:.9g}, {:.9g}]", n.low, n.high);
    if (n.op == Op::table)
      text += ": " + netlist_.tables()[at(n.table)]->formula;
    else
      text += ", " + to_string(n.format);
    if (n.addition) text += " (beside the published design)";
    return text;
  }

  /// The word that an operator of constants alone gives; such an operator is not built.
  std::string fixed_text(int i) {
    if (node(i).op == Op::table) return "";
    if (!constants_) {
      constants_ = make_evaluator(netlist_, Arithmetic::fixed);
      const double zero = 0;
      const std::vector<const double*> in(netlist_.inputs().size(), &zero);
      std::vector<double> sink(netlist_.outputs().size());
      std::vector<double*> out;
      for (double& value : sink) out.push_back(&value);
      constants_->evaluate(in.data(), 1, out.data());
    }
    return wire_text(names_[at(i)], node(i).format.width, verilog_word(constants_->raw(i, 0), node(i).format.width));
  }

  std::string views_text(int i) const {
    std::string text;
    for (auto view = views_.lower_bound({i, -1}); view != views_.end() && view->first == i; ++view)
      text += operator_text(node(i), name_at(i, {WordPlace::From::view, view->second}), operands_at(i, view->second));
    return text;
  }

  /// An operator of several cycles: its result waits in registers of its own until the last.
  template <class Text>
  std::string staged(int i, const Text& text_of) {
    const int waits = std::max(0, cycles(i) - 1);
    if (waits == 0) return text_of(made_name(i));
    const std::string first = names_[at(i)] + "_first";
    return text_of(first) + delay_text(first, made_name(i), node(i).format.width, waits);
  }
  /// `to` is `from`, `edges` clock edges later.
  std::string delay_text(const std::string& from, const std::string& to, int width, int edges) {
    module_.has_clock = true;
    module_.inside_bits += std::int64_t{width} * edges;
    std::string declared, clocked, before = from;
    for (int k = 1; k <= edges; ++k) {
      const std::string name = k == edges ? to : fmt::format("{}_{}", from, k);
      declared += fmt::format("  reg {}{};\n", verilog_range(width), name);
      clocked += fmt::format("    {} <= {};\n", name, before);
      before = name;
    }
    return declared + "  always @(posedge clk) begin\n" + clocked + "  end\n";
  }

  /// A multiplier of several cycles takes its factors through registers.
  std::string product_text(int i) {
    const int waits = std::max(0, cycles(i) - 1);
    std::vector<WordText> factors = operands_at(i, schedule_.start[at(i)]);
    std::string text;
    if (waits > 0)
      for (std::size_t f = 0; f < factors.size(); ++f) {
        const std::string late = fmt::format("{}_factor{}", names_[at(i)], f);
        text += delay_text_of(factors[f].name, late, factors[f].width, waits);
        factors[f].name = late;
      }
    return text + operator_text(node(i), made_name(i), factors);
  }
  /// As delay_text, where `from` may be delayed under several names.
  std::string delay_text_of(const std::string& from, const std::string& to, int width, int edges) {
    return wire_text(to + "_first", width, from) + delay_text(to + "_first", to, width, edges);
  }

  std::string shared_product_text(int i) const {
    for (std::size_t m = 0; m < multipliers_.size(); ++m)
      for (const int product : multipliers_[m].products)
        if (product == i) {
          const std::vector<WordText> factors = operands_at(i, schedule_.start[at(i)]);
          const WordText exact = product_word(SharedMultiplier::product_name(static_cast<int>(m)), factors[0], factors[1]);
          WordText low = exact;  // the multiplier may be wider: the low bits are the product
          low.name = made_name(i) + "_exact";
          return wire_text(low.name, low.width, fmt::format("{}[{}:0]", exact.name, exact.width - 1)) +
                 wire_text(made_name(i), node(i).format.width, rounded(low, node(i).format));
        }
    BUMP_ASSERT(false);
    return "";
  }
  std::string shared_text(std::size_t m) {
    const SharedMultiplier& multiplier = multipliers_[m];
    std::vector<SharedMultiplier::Turn> turns;
    for (const int product : multiplier.products) {
      const int start = schedule_.start[at(product)];
      turns.push_back({node(product).name, start % interval_, operands_at(product, start)});
    }
    const int waits = std::max(0, cycles(multiplier.products.front()) - 1);
    const int index = static_cast<int>(m);
    std::string text = multiplier.steering(index, turns, bits_of_phase());
    for (const char which : {'a', 'b'}) {
      const std::string steered = fmt::format("multiplier{}_{}_steered", m, which), factor = fmt::format("multiplier{}_{}", m, which);
      const int width = which == 'a' ? multiplier.width_a : multiplier.width_b;
      text += waits == 0 ? wire_text(factor, width, steered) : delay_text(steered, factor, width, waits);
    }
    return text + multiplier.product(index);
  }

  void add_leaf(const VerilogModule& leaf) {
    module_.inside_bits += leaf.register_bits;
    const bool known =
        std::any_of(module_.leaves.begin(), module_.leaves.end(), [&](const VerilogModule& m) { return m.name == leaf.name; });
    if (!known) module_.leaves.push_back(leaf);
  }
  std::string clock_port(int stages) {
    if (stages == 0) return "";
    module_.has_clock = true;
    return ".clk(clk), ";
  }

  std::string leaf_text(int i) {
    const Node& n = node(i);
    const auto format = [&](std::size_t operand) { return node(n.operands[operand]).format; };
    const std::vector<WordText> words = operands_at(i, schedule_.start[at(i)]);
    const int stages = n.op == Op::add_sub ? 0 : std::max(0, cycles(i) - 1);
    VerilogModule leaf;
    std::string ports;
    if (n.op == Op::div) {
      leaf = divider_module(format(0), format(1), n.format, stages);
      ports = fmt::format(".a({}), .b({})", words[0].name, words[1].name);
    } else if (n.op == Op::sqrt) {
      leaf = square_root_module(format(0), n.format, stages);
      ports = fmt::format(".a({})", words[0].name);
    } else {
      leaf = adder_subtractor_module(format(1), format(2), n.format);
      ports = fmt::format(".subtract({}), .a({}), .b({})", words[0].name, words[1].name, words[2].name);
    }
    add_leaf(leaf);
    const auto instance = [&](const std::string& result) {
      return fmt::format("  wire {}{};\n  {} {}_operator({}{}, .q({}));\n", verilog_range(n.format.width), result, leaf.name, names_[at(i)],
                         clock_port(stages), ports, result);
    };
    return n.op == Op::add_sub ? staged(i, instance) : instance(made_name(i));
  }

  /// The table node that reads the second port of the ROM that `i` reads, or -1: second ports go to the reads of a table in order.
  int second_reader(int i) const {
    int rank = 0;
    for (int j = 0; j < i; ++j)
      if (node(j).op == Op::table && !node(j).second_port && node(j).table == node(i).table) ++rank;
    for (int j = 0; j < count(); ++j)
      if (node(j).op == Op::table && node(j).second_port && node(j).table == node(i).table && rank-- == 0) return j;
    return -1;
  }

  /// A ROM and its readers; a second port's words are declared here, where the ROM is, and its index is assigned where it is known.
  std::string table_text(int i) {
    const Table& table = *netlist_.tables()[at(node(i).table)];
    if (node(i).second_port) return index_text(i);
    const int second = second_reader(i), stages = std::max(0, cycles(i) - 1);
    TableModules modules = table_modules(scheme_, table, *contents_of(netlist_.tables()[at(node(i).table)]), second < 0 ? 1 : 2, stages);
    add_leaf(modules.reader);
    add_leaf(modules.rom);
    module_.roms[modules.rom_file] = modules.rom_text;
    std::string declared, ports;
    for (const int reader : {i, second}) {
      if (reader < 0) continue;
      const int port = reader == i ? 0 : 1;
      for (std::size_t word = 0; word < node(reader).operands.size(); ++word) {
        declared += fmt::format("  wire {}{};\n", verilog_range(node(node(reader).operands[word]).format.width), index_name(reader, word));
        ports += fmt::format("{}.i{}_{}({})", ports.empty() ? "" : ", ", word, port, index_name(reader, word));
      }
      for (std::size_t column = 0; column < table.columns.size(); ++column) {
        const std::string result = column_name(reader, static_cast<int>(column));
        declared += fmt::format("  wire {}{};\n", verilog_range(table.columns[column].format.width), result);
        ports += fmt::format(", .c{}_{}({})", column, port, result);
      }
    }
    return declared + index_text(i) + fmt::format("  {} {}_rom({}{});\n", modules.reader.name, names_[at(i)], clock_port(stages), ports);
  }
  std::string index_name(int reader, std::size_t word) const { return fmt::format("{}_index{}", names_[at(reader)], word); }
  std::string index_text(int reader) const {
    std::string text;
    const std::vector<WordText> words = operands_at(reader, schedule_.start[at(reader)]);
    for (std::size_t word = 0; word < words.size(); ++word)
      text += fmt::format("  assign {} = {};\n", index_name(reader, word), words[word].name);
    return text;
  }
  /// What a reader's column drives: the word of the column's node.
  std::string column_name(int reader, int column) const {
    for (int j = reader + 1; j < count(); ++j)
      if (node(j).op == Op::column && node(j).operands[0] == reader && node(j).amount == column) return made_name(j);
    return fmt::format("{}_column{}", names_[at(reader)], column);
  }

  std::string registers_text(int i) {
    std::string declared, clocked;
    for (const HeldWord& held : plan_.registers()) {
      if (held.node != i) continue;
      const std::string name = name_at(i, {WordPlace::From::held, held.cycle}), from = word(i, held.cycle - 1).name;
      declared += fmt::format("  reg {}{};\n", verilog_range(node(i).format.width), name);
      const std::string when = interval_ > 1 ? fmt::format("if (phase == {}) ", phase_word((held.cycle - 1) % interval_)) : "";
      clocked += fmt::format("    {}{} <= {};\n", when, name, from);
      module_.register_bits += node(i).format.width;
    }
    if (declared.empty()) return "";
    module_.has_clock = true;
    return declared + "  always @(posedge clk) begin\n" + clocked + "  end\n";
  }

  std::string outputs_text() const {
    std::string text = "\n";
    for (std::size_t i = 0; i < module_.outputs.size(); ++i)
      text += fmt::format("  assign out_{} = {};\n", module_.outputs[i].verilog, word(netlist_.outputs()[i].node, schedule_.latency).name);
    return text;
  }

  int bits_of_phase() const {
    int bits = 1;
    while ((1 << bits) < interval_) ++bits;
    return bits;
  }
  std::string phase_word(int phase) const { return verilog_word(phase, bits_of_phase()); }

  std::vector<std::string> comment() const {
    std::vector<std::string> lines = {
        fmt::format("{} unit of {}: {} cycles, a new token every {}.", netlist_.name(), scheme_, schedule_.latency,
                    interval_ == 1 ? "cycle" : fmt::format("{} cycles", interval_)),
        "Never stalls. x_c7 is x behind the clock edge in front of cycle 7 of a token, x_next what a register takes at the next edge.",
        "Formats: s12.10 is a signed word of 12 bits, 10 of them behind the point; an angle is in turns, turn12 a full turn in 12 bits."};
    if (interval_ > 1) lines.push_back("Multipliers are shared: `phase` counts the cycles of the interval, and a token begins in phase 0.");
    return lines;
  }

  std::string header() const {
    std::vector<std::string> ports;
    if (module_.has_clock) ports.push_back("input wire clk");
    if (interval_ > 1) ports.push_back(fmt::format("input wire {}phase", verilog_range(bits_of_phase())));
    for (const DatapathModule::Port& port : module_.inputs)
      ports.push_back(fmt::format("input wire {}in_{}", verilog_range(port.format.width), port.verilog));
    for (const DatapathModule::Port& port : module_.outputs)
      ports.push_back(fmt::format("output wire {}out_{}", verilog_range(port.format.width), port.verilog));
    std::string text =
        "// A truncated result's low bits have no reader, and factors are widened to their product by the language.\n"
        "/* verilator lint_off UNUSED */\n/* verilator lint_off WIDTH */\nmodule " +
        module_.name + " (\n";
    for (std::size_t i = 0; i < ports.size(); ++i) {
      const std::string format = i + module_.inputs.size() + module_.outputs.size() >= ports.size()
                                     ? "  // " + port_comment(i + module_.inputs.size() + module_.outputs.size() - ports.size())
                                     : "";
      text += "  " + ports[i] + (i + 1 < ports.size() ? "," : "") + format + "\n";
    }
    return text + ");\n";
  }
  std::string port_comment(std::size_t port) const {
    const bool is_input = port < module_.inputs.size();
    const DatapathModule::Port& p = is_input ? module_.inputs[port] : module_.outputs[port - module_.inputs.size()];
    return p.name + ", " + to_string(p.format);
  }

  const std::string scheme_;
  const Netlist& netlist_;
  const Schedule& schedule_;
  const int interval_;
  const RegisterPlan plan_;
  const std::vector<SharedMultiplier> multipliers_;
  std::unique_ptr<Evaluator> constants_;
  std::vector<std::string> names_;       ///< by node
  std::set<std::pair<int, int>> views_;  ///< node, cycle of the place
  DatapathModule module_;
};

}  // namespace

DatapathModule datapath_module(const std::string& scheme, const std::string& unit, const Netlist& netlist, const Schedule& schedule) {
  return DatapathText(scheme, unit, netlist, schedule).module();
}

}  // namespace bump
