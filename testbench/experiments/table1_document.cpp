// Table 1 for readers: aligned text or Markdown of the same document.

#include <fmt/core.h>

#include <algorithm>
#include <functional>

#include "testbench/experiments/table1_formats.h"
#include "testbench/published/lee2007_table1.h"
#include "testbench/results/text_table.h"

namespace bump {

namespace {

constexpr std::size_t text_columns = 140;

std::string cell(const std::optional<double>& value, const std::string& missing = "-") {
  return value ? table1_number(*value) : missing;
}

/// Per cent and degrees, so that decimals stand below one another.
std::string tenths(const std::optional<double>& value) {
  return value ? fmt::format("{:.1f}", *value) : "-";
}

/// "27/27", "13/11*" where they differ, "27" where nothing is printed, "?/5" without a netlist, "-" for nothing.
std::string pair(const Table1Value* value) {
  if (value == nullptr) return "-";
  if (value->derived.value_or(0) == 0 && value->published.value_or(0) == 0) return "-";
  if (!value->published) return cell(value->derived);
  return cell(value->derived, "?") + "/" + cell(value->published) + (value->differs() ? "*" : "");
}

std::string alone(const Table1Row* row, const std::string& quantity) {
  const Table1Value* value = row == nullptr ? nullptr : row->find(quantity);
  return value == nullptr || value->derived.value_or(0) == 0 ? "-" : cell(value->derived);
}

class Table1Document {
 public:
  Table1Document(const Table1& table, bool markdown) : table_(table), markdown_(markdown) {}

  std::string text() {
    head();
    operators();
    text_counts();
    sizes();
    stored();
    reductions();
    claim();
    interpolators();
    pixel_units();
    fragments();
    vertices();
    frames();
    provenance();
    return std::move(text_);
  }

 private:
  void heading(const std::string& words) {
    if (text_.size() > 1 && text_[text_.size() - 2] == '\n') text_.pop_back();
    text_ += markdown_ ? "\n## " + words + "\n\n" : "\n" + words + "\n" + std::string(words.size(), '=') + "\n\n";
  }
  void paragraph(const std::string& words) { text_ += markdown_ ? words + "\n\n" : folded(words, text_columns) + "\n"; }
  void item(const std::string& mark, const std::string& words) {
    text_ += markdown_ ? (mark == "-" ? "* " : mark + " ") + words + "\n" : folded(words, text_columns, "  " + mark + " ");
  }
  void grid(const TextTable& table) { text_ += (markdown_ ? markdown(table) : aligned(table)) + "\n"; }

  std::vector<const Table1Row*> rows(Table1Section section) const {
    std::vector<const Table1Row*> found;
    for (const Table1Row& row : table_.rows)
      if (row.section == section) found.push_back(&row);
    return found;
  }
  const Table1Row* row(Table1Section section, const std::string& scheme, const std::string& step) const {
    for (const Table1Row& candidate : table_.rows)
      if (candidate.section == section && candidate.scheme == scheme && candidate.step == step) return &candidate;
    return nullptr;
  }
  std::string label(const std::string& scheme) const {
    const std::string& column = table_.scheme(scheme).column;
    return column.empty() ? scheme : column + ", " + scheme;
  }
  static std::string marked(const std::string& words, const Table1Row& row) { return row.reconstruction ? words + " (R)" : words; }
  /// Settings without the scheme's name in front.
  static std::string short_settings(const Table1Row& row) {
    std::string words = row.settings;
    const std::string prefix = row.scheme + ".";
    for (std::size_t at = words.find(prefix); at != std::string::npos; at = words.find(prefix)) words.erase(at, prefix.size());
    return words;
  }

  /// The number of a note, the same for the same words; printed by notes().
  std::string note(const std::string& words) {
    if (words.empty()) return "";
    auto known = std::find(notes_.begin(), notes_.end(), words);
    if (known == notes_.end()) known = notes_.insert(notes_.end(), words);
    return "[" + std::to_string(known - notes_.begin() + 1) + "]";
  }
  void notes() {
    for (std::size_t i = 0; i < notes_.size(); ++i)
      item(markdown_ ? std::to_string(i + 1) + "." : "[" + std::to_string(i + 1) + "]", notes_[i]);
    notes_.clear();
  }

  void head() {
    if (markdown_) {
      text_ += "# Table 1 of Lee et al. 2007: derived and published\n\nWritten by `bumpsim table1 --format md`.\n\n";
    } else {
      const std::string title = "Table 1 of Lee et al. 2007: derived and published";
      text_ += title + "\n" + std::string(title.size(), '=') + "\n\n";
    }
    paragraph(
        "Derived numbers are counted in the recorded netlists that the simulator executes; published ones are as printed. Per pixel and "
        "for "
        "one light; a subtractor is an adder; signs, clamps, selects and shifts are not operators of the table; maps are large tables with "
        "more than one index; fetches of bump map and texture are not counted.");
    paragraph(
        "27/27 is derived/published, 13/11* differs, 7 alone has no published number, ?/5 has no netlist, - is none. (R) marks a "
        "reconstruction: a unit made to agree with what is known of it. [1] refers to the notes.");
    if (table_.settings.empty()) {
      paragraph("All parameters have their defaults.");
    } else {
      std::string words = "Configured:";
      for (const std::string& setting : table_.settings) words += " " + setting + ";";
      words.back() = '.';
      paragraph(words);
    }
  }

  void operators() {
    heading("Operators");
    TextTable grid_of{{"architecture", "step", "compared", "mult", "add", "div", "sqrt", "tables", "maps", "note"}, {}, 3};
    std::string last;
    for (const Table1Row* r : rows(Table1Section::operators)) {
      std::string step = marked(r->step, *r);
      if (r->kind == Table1Kind::addition) step = r->step == "conversion" ? "+ conversion unit" : "+ additions to it";
      if (r->kind == Table1Kind::reading) step = "= " + short_settings(*r);
      const bool tells = r->kind != Table1Kind::addition && r->why != r->agreement;
      std::vector<std::string> cells = {r->scheme == last ? "" : label(r->scheme), step,
                                        r->kind == Table1Kind::addition ? "" : r->agreement};
      for (const Table1Value& value : r->values) cells.push_back(pair(&value));
      cells.push_back(tells ? note(r->why) : "");
      grid_of.rows.push_back(cells);
      last = r->scheme;
    }
    grid(grid_of);
    item("-",
         "Rows with = are another reading of the cell above, by the settings named: derived with them, beside the same published numbers.");
    item("-", "Rows with + are what the netlists need beside what is published; they are in no total.");
    item("-",
         "By convention: agrees if counted in one way and not in another that is as good. By construction: the netlist was made to agree.");
    text_ += "\n";
    notes();
  }

  void text_counts() {
    heading("Numbers of operators in the text");
    TextTable grid_of{{"said of", "scheme", "where", "mult", "add", "div", "sqrt", "tables", "note"}, {}, 3};
    for (const Table1Row* r : rows(Table1Section::text)) {
      std::vector<std::string> cells = {r->step, marked(r->scheme, *r), r->source};
      for (const char* quantity : {"multipliers", "adders", "dividers", "square_roots", "tables"}) cells.push_back(pair(r->find(quantity)));
      cells.push_back(r->agreement == "not modelled" ? "" : note(r->why));
      grid_of.rows.push_back(cells);
    }
    grid(grid_of);
    notes();
  }

  void sizes() {
    heading("Sizes in the text");
    TextTable grid_of{{"said of", "scheme", "quoted", "derived, bytes", "published, bytes", "note"}, {}, 3};
    for (const Table1Row* r : rows(Table1Section::text_sizes)) {
      const Table1Value& value = r->values.front();
      grid_of.rows.push_back({r->step, marked(r->scheme, *r), r->source, cell(value.derived, "?"),
                              cell(value.published) + (value.differs() ? "*" : ""), r->agreement == "not modelled" ? "" : note(r->why)});
    }
    grid(grid_of);
    notes();
  }

  void stored() {
    heading("Tables and maps, bytes");
    paragraph("One ROM for every read, as one fragment a clock needs; distinct: every content of a step once, maps included.");
    TextTable grid_of{{"scheme", "step", "tables", "distinct", "maps", "in additions", "light maps"}, {}, 2};
    for (const Table1Row* r : rows(Table1Section::storage))
      grid_of.rows.push_back({r->scheme, marked(r->step, *r), alone(r, "table_bytes"), alone(r, "distinct_table_and_map_bytes"),
                              alone(r, "map_bytes"), alone(r, "additional_table_bytes"), alone(r, "light_map_bytes")});
    grid(grid_of);
  }

  void reductions() {
    heading("Multipliers saved");
    const std::string ours(published::proposed);
    paragraph("1 - " + ours +
              "/other, per cent, from published counts and from derived ones; what the total of the proposed design has more in adders and "
              "tables (derived, less is negative); and how far the light vector of each design's environment unit is from the true one.");
    TextTable grid_of{{"against", "env pub", "env der", "illum pub", "illum der", "total pub", "total der", "adders", "tables", "mean deg",
                       "rms deg", "largest deg"},
                      {},
                      1};
    const auto error = [&](std::vector<std::string>& cells, const std::string& scheme) {
      const Table1Row* accuracy = row(Table1Section::beyond, scheme, "accuracy");
      for (const char* quantity : {"mean_error", "rms_error", "largest_error"}) {
        const Table1Value* value = accuracy == nullptr ? nullptr : accuracy->find(quantity);
        cells.push_back(value == nullptr ? "-" : tenths(value->derived));
      }
    };
    std::vector<std::string> self = {ours + " itself", "", "", "", "", "", "", "", ""};
    error(self, ours);
    grid_of.rows.push_back(self);
    for (const Table1Scheme& scheme : table_.schemes) {
      if (scheme.id == ours) continue;
      std::vector<std::string> cells = {scheme.reconstructed.empty() ? scheme.id : scheme.id + " (R)"};
      for (const char* step : {"environment", "illumination", "total"}) {
        const Table1Value& saved = *row(Table1Section::reduction, scheme.id, step)->find("multipliers_saved");
        cells.push_back(tenths(saved.published));
        cells.push_back(tenths(saved.derived));
      }
      const Table1Row* total = row(Table1Section::reduction, scheme.id, "total");
      for (const char* quantity : {"adders_more", "tables_more"}) cells.push_back(cell(total->find(quantity)->derived));
      error(cells, scheme.id);
      grid_of.rows.push_back(cells);
    }
    grid(grid_of);
  }

  void claim() {
    const std::string percent = std::to_string(published::reduction_claim.percent) + " %";
    paragraph("The claim, \"up to " + percent + "\" (" + std::string(published::reduction_claim.source) +
              "), does not name its base. Against the columns of Table 1:");
    std::string maxima;
    for (const Table1Row* r : rows(Table1Section::claim)) {
      const Table1Value &printed = r->values[0], &counted = r->values[1];
      item("-", r->step + ": at most " + tenths(printed.derived) + " % from published counts (" + printed.why + "), " +
                    tenths(counted.derived) + " % from derived ones (" + counted.why + "); " + r->why + ".");
      if (r->agreement == "maximum agrees") maxima += (maxima.empty() ? "" : ", ") + r->step;
    }
    text_ += "\n";
    paragraph(
        (maxima.empty() ? "No base has the claimed number as its maximum." : "It is the maximum of: " + maxima + ".") +
        " That is no proof of what was meant: the same number comes from other bases. No claim is made for designs that Table 1 does not "
        "list. Where the last columns show 0, the vector is turned exactly, and a saving against such a design is paid for with the "
        "error in the first row. - in the last columns: nothing is delivered that could be measured, or the light stays in object space.");
  }

  void interpolators() {
    heading("Beyond the table: interpolators");
    paragraph("Components besides u and v, and the operators of all of them, perspective correction included.");
    TextTable grid_of{{"scheme", "components", "mult", "add", "div"}, {}, 1};
    for (const Table1Row* r : rows(Table1Section::beyond))
      if (r->step == "interpolators")
        grid_of.rows.push_back(
            {r->scheme, alone(r, "interpolated_components"), alone(r, "multipliers"), alone(r, "adders"), alone(r, "dividers")});
    grid(grid_of);
  }

  static bool same(const Table1Row& a, const Table1Row& b) {
    return std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(),
                      [](const Table1Value& x, const Table1Value& y) { return x.quantity == y.quantity && x.derived == y.derived; });
  }

  /// Barrel shifters have a column where any row of the kind has some.
  bool has_shifters(const std::function<bool(const Table1Row&)>& of_kind) const {
    const auto beyond = rows(Table1Section::beyond);
    return std::any_of(beyond.begin(), beyond.end(), [&](const Table1Row* r) {
      const Table1Value* shifters = r->find("shifters");
      return of_kind(*r) && shifters != nullptr && shifters->derived.value_or(0) > 0;
    });
  }

  void pixel_units() {
    heading("Beyond the table: wiring, tables and time of the pixel units");
    paragraph(
        "Additions included. ports: second ports of tables. Latency and interval in cycles at the configured latencies of operators.");
    std::vector<std::string> titles = {"scheme",   "unit",  "clamps",     "selects",  "signs",   "shifts",
                                       "encoders", "ports", "table bits", "distinct", "latency", "interval"};
    std::vector<const char*> quantities = {"clamps",       "selects",    "sign_logic",          "shifts",  "index_encoders",
                                           "second_ports", "table_bits", "distinct_table_bits", "latency", "initiation_interval"};
    if (has_shifters([](const Table1Row& r) { return r.find("clamps") != nullptr; })) {
      titles.insert(titles.begin() + 2, "shifters");
      quantities.insert(quantities.begin(), "shifters");
    }
    TextTable grid_of{titles, {}, 2};
    std::vector<const Table1Row*> colours;
    for (const Table1Row* r : rows(Table1Section::beyond))
      if (r->step == "colour") colours.push_back(r);
    const bool one_colour_unit =
        std::all_of(colours.begin(), colours.end(), [&](const Table1Row* r) { return same(*r, *colours.front()); });
    for (const Table1Row* r : rows(Table1Section::beyond)) {
      if (r->find("clamps") == nullptr || r->step == "interpolators") continue;
      if (one_colour_unit && r->step == "colour" && r != colours.front()) continue;
      std::vector<std::string> cells = {one_colour_unit && r->step == "colour" ? "every scheme" : r->scheme, marked(r->step, *r)};
      for (const char* quantity : quantities) cells.push_back(alone(r, quantity));
      grid_of.rows.push_back(cells);
    }
    grid(grid_of);
  }

  void counted(const std::string& first, const std::vector<std::string>& steps) {
    std::vector<std::string> titles = {"scheme", first, "mult", "add", "div", "sqrt", "tables", "maps", "operations"};
    std::vector<const char*> quantities = {"multipliers", "adders", "dividers", "square_roots", "tables", "maps", "operations"};
    if (has_shifters([&](const Table1Row& r) { return std::find(steps.begin(), steps.end(), r.step) != steps.end(); })) {
      titles.insert(titles.end() - 1, "shifters");
      quantities.insert(quantities.end() - 1, "shifters");
    }
    TextTable grid_of{titles, {}, 2};
    for (const Table1Row* r : rows(Table1Section::beyond)) {
      if (std::find(steps.begin(), steps.end(), r->step) == steps.end()) continue;
      std::vector<std::string> cells = {r->scheme, r->step};
      for (const char* quantity : quantities) cells.push_back(alone(r, quantity));
      grid_of.rows.push_back(cells);
    }
    grid(grid_of);
  }

  void fragments() {
    heading("Beyond the table: executed for each fragment");
    paragraph("One light: interpolators, conversion, environment, illumination and colour unit with their additions, every operator once.");
    counted("for each", {"fragment"});
  }

  void vertices() {
    heading("Beyond the table: executed for each vertex");
    paragraph(
        "vertex: the scheme's program for one light; vertex_per_light: its part that every further light repeats; vertex_transform: clip "
        "coordinates and the vector to the eye, the same for every scheme that reads it.");
    counted("part", {"vertex", "vertex_per_light", "vertex_transform"});
  }

  void frames() {
    const auto beyond = rows(Table1Section::beyond);
    if (std::none_of(beyond.begin(), beyond.end(), [](const Table1Row* r) { return r->step == "frame"; })) return;
    heading("Beyond the table: executed for each frame");
    paragraph("Filling the light maps, for each object and light.");
    counted("for each", {"frame"});
  }

  void provenance() {
    heading("Where the architectures come from");
    for (const Table1Scheme& scheme : table_.schemes) {
      if (!scheme.modelled) {
        item("-", label(scheme.id) + ": not modelled.");
        continue;
      }
      std::string steps;
      for (const std::string& step : scheme.reconstructed) steps += (steps.empty() ? " Reconstructed (R): " : ", ") + step;
      item("-", label(scheme.id) + ": " + scheme.title + ". " + scheme.source + ". Provenance: " + scheme.provenance + "." +
                    (steps.empty() ? "" : steps + "."));
    }
  }

  const Table1& table_;
  bool markdown_;
  std::string text_;
  std::vector<std::string> notes_;
};

}  // namespace

std::string table1_document(const Table1& table, bool markdown) {
  return Table1Document(table, markdown).text();
}

}  // namespace bump
