#include "rtl/table_module.h"

#include <fmt/core.h>

#include <algorithm>

#include "datapath/array_registers.h"
#include "datapath/invariant.h"
#include "luts/rom_image.h"
#include "rtl/leaf_text.h"
#include "rtl/table_address.h"

namespace bump {

namespace {

const char* phrase_of(Folding folding) {
  switch (folding) {
    case Folding::none:
      return "not folded";
    case Folding::magnitude:
      return "folded about zero";
    case Folding::quarter:
      return "folded to a quarter turn";
    case Folding::floating:
      return "a short floating-point code";
  }
  return "";
}

class TableWriter {
 public:
  TableWriter(const std::string& scheme, const Table& table, int ports, int stages)
      : table_(table),
        ports_(ports),
        stages_(stages),
        name_(verilog_identifier(scheme + "_" + table.name)),
        rom_name_("rom_" + name_ + (ports == 2 ? "_p2" : "")),
        address_bits_(table.address_bits + table.field_bits()),
        word_bits_(table.word_bits()),
        edges_(table_edges(table, stages)),
        mirrors_(std::any_of(table.columns.begin(), table.columns.end(), [](const Column& column) { return column.mirrors_first; })),
        text_("table_" + name_ + (ports == 2 ? "_p2" : "") + (stages > 0 ? fmt::format("_n{}", stages) : "")) {
    BUMP_ASSERT((ports == 1 || ports == 2) && stages >= 0);
  }

  std::string rom_file() const { return "rom/" + name_ + ".hex"; }

  VerilogModule rom() const {
    LeafText text(rom_name_);
    text.comment(fmt::format("ROM {}: {} words of {} bits: {}.", table_.name, table_.entries(), word_bits_, stored_columns()));
    for (int read = 0; read < reads(); ++read) text.input(fmt::format("address_{}", read), address_bits_);
    for (int read = 0; read < reads(); ++read) text.output(fmt::format("word_{}", read), read_bits(read));
    text.line(fmt::format("reg {}words [0:{}];", verilog_range(word_bits_), table_.entries() - 1));
    text.line(fmt::format("initial $readmemh(\"{}\", words);", rom_file()));
    for (int read = 0; read < reads(); ++read) {
      const std::string word = fmt::format("words[address_{}]", read);
      const bool whole = read_bits(read) == word_bits_;
      text.assign(fmt::format("word_{}", read),
                  whole ? word : fmt::format("{}[{}:{}]", word, word_bits_ - 1, word_bits_ - read_bits(read)));
    }
    return text.module();
  }

  VerilogModule reader() {
    text_.comment(fmt::format("Table {}: {}.", table_.name, table_.formula.empty() ? "no formula" : table_.formula));
    text_.comment(fmt::format("Index {}, {}; {} words.", index_formats(), phrase_of(table_.folding), table_.entries()));
    for (std::size_t i = 0; i < table_.columns.size(); ++i) text_.comment(column_text(i));
    if (stages_ > 0) text_.clock();
    for (int port = 0; port < ports_; ++port)
      for (int i = 0; i < table_.index_words(); ++i)
        text_.input(fmt::format("i{}_{}", i, port),
                    i == 0 ? table_.index.width : table_.fields[static_cast<std::size_t>(i) - 1].index.width,
                    is_partly_read(table_, i) ? LeafText::Read::partly : LeafText::Read::whole);
    for (int port = 0; port < ports_; ++port)
      for (std::size_t i = 0; i < table_.columns.size(); ++i) text_.output(fmt::format("c{}_{}", i, port), table_.columns[i].format.width);
    std::vector<Read> port_reads;
    for (int port = 0; port < ports_; ++port) port_reads.push_back(front(port));
    instance(port_reads);
    for (int port = 0; port < ports_; ++port) back(port, port_reads[static_cast<std::size_t>(port)]);
    const VerilogModule module = text_.module();
    BUMP_ASSERT(module.register_bits == ports_ * edges_.bits());
    return module;
  }

 private:
  /// What a port's read is called in the segment it has reached.
  struct Read {
    std::string address, negative, beyond, word, mirrored;
  };

  int reads() const { return mirrors_ ? 2 * ports_ : ports_; }
  /// Reads behind the ports' own are those of mirrored columns.
  int read_bits(int read) const { return read < ports_ ? word_bits_ : table_.stored_width(table_.columns.front()); }

  bool sign_is_folded(const Column& column) const { return table_.stored_width(column) < column.format.width; }
  bool turns_at_zero(const Column& column) const { return sign_is_folded(column) && column.symmetry.odd_about_zero; }
  bool turns_at_quarter(const Column& column) const {
    return sign_is_folded(column) && table_.folding == Folding::quarter && column.symmetry.odd_about_quarter;
  }

  std::string index_formats() const {
    std::string text = to_string(table_.index);
    for (const MapField& field : table_.fields) text += ", " + to_string(field.index);
    return text;
  }

  std::string stored_columns() const {
    std::string text;
    for (const Column& column : table_.columns)
      if (!column.mirrors_first) text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", column.name, table_.stored_width(column));
    return text;
  }

  std::string column_text(std::size_t i) const {
    const Column& column = table_.columns[i];
    std::string text = fmt::format("Column c{}: {}, {}", i, column.name, to_string(column.format));
    if (turns_at_zero(column)) text += ", odd about 0";
    if (turns_at_quarter(column)) text += ", odd about a quarter turn";
    if (column.mirrors_first) text += ", from the first column's words at the complemented address";
    return text + ".";
  }

  /// Address and signs of a port, through the registers in front of the ROM.
  Read front(int port) {
    const std::string suffix = "_" + std::to_string(port);
    std::vector<std::string> index;
    for (int i = 0; i < table_.index_words(); ++i) index.push_back(fmt::format("i{}{}", i, suffix));
    text_.remark("port " + std::to_string(port));
    Read read;
    const std::string address = address_expression(text_, table_, index, suffix);
    text_.word("address" + suffix, address_bits_, address);
    read.address = "address" + suffix;
    const int top = table_.index.width - 1;
    if (std::any_of(table_.columns.begin(), table_.columns.end(), [&](const Column& c) { return turns_at_zero(c); })) {
      text_.bit("negative" + suffix, bits_of(index[0], top, top));
      read.negative = "negative" + suffix;
    }
    if (std::any_of(table_.columns.begin(), table_.columns.end(), [&](const Column& c) { return turns_at_quarter(c); })) {
      text_.bit("beyond" + suffix, bits_of(index[0], top, top) + " ^ " + bits_of(index[0], top - 1, top - 1));
      read.beyond = "beyond" + suffix;
    }
    for (int stage = 1; stage <= edges_.in_front; ++stage) {
      std::vector<LeafText::Register> bank;
      keep(bank, read.address, fmt::format("address_s{}{}", stage, suffix), address_bits_);
      keep_signs(bank, read, stage, suffix);
      text_.registers(bank);
    }
    return read;
  }

  static void keep(std::vector<LeafText::Register>& bank, std::string& word, const std::string& called, int width) {
    bank.push_back({called, width, word});
    word = called;
  }

  static void keep_signs(std::vector<LeafText::Register>& bank, Read& read, int stage, const std::string& suffix) {
    if (!read.negative.empty()) keep(bank, read.negative, fmt::format("negative_s{}{}", stage, suffix), 0);
    if (!read.beyond.empty()) keep(bank, read.beyond, fmt::format("beyond_s{}{}", stage, suffix), 0);
  }

  void instance(std::vector<Read>& port_reads) {
    text_.remark("the words");
    std::vector<std::string> connections;
    for (int read = 0; read < reads(); ++read) {
      Read& of = port_reads[static_cast<std::size_t>(read % ports_)];
      const bool mirrored = read >= ports_;
      const std::string word = fmt::format("{}_{}", mirrored ? "mirrored" : "word", read % ports_);
      text_.line(fmt::format("wire {}{};", verilog_range(read_bits(read)), word));
      connections.push_back(fmt::format(".address_{}({}{}), .word_{}({})", read, mirrored ? "~" : "", of.address, read, word));
      (mirrored ? of.mirrored : of.word) = word;
    }
    text_.line(rom_name_ + " rom (");
    for (std::size_t i = 0; i < connections.size(); ++i) text_.line("  " + connections[i] + (i + 1 < connections.size() ? "," : ""));
    text_.line(");");
  }

  /// The columns of a port, with their signs.
  void back(int port, Read read) {
    const std::string suffix = "_" + std::to_string(port);
    text_.remark("columns of port " + std::to_string(port));
    if (edges_.behind > 0) {
      std::vector<LeafText::Register> bank;
      keep(bank, read.word, "word_r" + suffix, word_bits_);
      if (mirrors_) keep(bank, read.mirrored, "mirrored_r" + suffix, read_bits(ports_));
      keep_signs(bank, read, stages_, suffix);
      text_.registers(bank);
    }
    int above = word_bits_;
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const Column& column = table_.columns[i];
      const int width = table_.stored_width(column);
      std::string stored = read.mirrored;
      if (!column.mirrors_first) {
        above -= width;
        stored = bits_of(read.word, above + width - 1, above);
      }
      assign_column(fmt::format("c{}{}", i, suffix), column, stored, read);
    }
  }

  void assign_column(const std::string& port, const Column& column, const std::string& stored, const Read& read) {
    if (!sign_is_folded(column)) return text_.assign(port, stored);
    const bool both = turns_at_zero(column) && turns_at_quarter(column);
    const std::string sign = both ? "(" + read.negative + " ^ " + read.beyond + ")" : turns_at_zero(column) ? read.negative : read.beyond;
    text_.assign(port, fmt::format("{0} ? -{{1'b0, {1}}} : {{1'b0, {1}}}", sign, stored));
  }

  const Table& table_;
  int ports_, stages_;
  std::string name_, rom_name_;
  int address_bits_, word_bits_;
  TableEdges edges_;
  bool mirrors_;
  LeafText text_;
};

}  // namespace

TableModules table_modules(const std::string& scheme, const Table& table, const TableContents& contents, int ports, int stages) {
  TableWriter writer(scheme, table, ports, stages);
  TableModules modules;
  modules.reader = writer.reader();
  modules.rom = writer.rom();
  modules.rom_file = writer.rom_file();
  modules.rom_text = rom_image(table, contents);
  return modules;
}

}  // namespace bump
