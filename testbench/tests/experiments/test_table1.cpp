#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "system/simulation.h"
#include "testbench/experiments/table1.h"
#include "testbench/experiments/table1_sections.h"

using namespace bump;

namespace {

const char* const columns[] = {"multipliers", "adders", "dividers", "square_roots", "tables", "maps"};

Configuration configured(const std::vector<std::pair<std::string, std::string>>& settings = {}) {
  Configuration configuration(all_parameters());
  for (const auto& [key, value] : settings) configuration.set_text(key, value, Location("test"));
  return configuration;
}

/// Of one process: every default, made once.
const Table1& defaults() {
  static const Table1 table = make_table1(configured());
  return table;
}

const Table1Row* find(const Table1& table, Table1Section section, const std::string& scheme, const std::string& step,
                      const std::string& settings = "") {
  for (const Table1Row& row : table.rows)
    if (row.section == section && row.scheme == scheme && row.step == step && row.settings == settings && row.kind != Table1Kind::addition)
      return &row;
  return nullptr;
}

/// Counts by a walk of its own, without count().
void walk(const Netlist& netlist, std::map<std::string, double>& counts) {
  for (const Node& node : netlist.nodes()) {
    if (node.addition || node.second_port) continue;
    const std::string op = name_of(node.op);
    if (op == "mul") ++counts["multipliers"];
    if (op == "add" || op == "sub" || op == "add_sub") ++counts["adders"];
    if (op == "div") ++counts["dividers"];
    if (op == "sqrt") ++counts["square_roots"];
    if (node.table >= 0 && op == "table")
      ++counts[netlist.tables()[static_cast<std::size_t>(node.table)]->index_words() > 1 ? "maps" : "tables"];
  }
}

std::vector<std::string> split(const std::string& line, char by) {
  std::vector<std::string> parts;
  std::string part;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == by && !quoted) {
      parts.push_back(part);
      part.clear();
    } else {
      part += c;
    }
  }
  parts.push_back(part);
  return parts;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

}  // namespace

TEST_CASE("every derived cell of Table 1 is what a walk over the scheme's netlists counts") {
  const Configuration configuration = configured();
  for (const Scheme* scheme : all_schemes()) {
    const std::string id = scheme->page().id;
    const Design design = scheme->design(configuration, Material{});
    std::map<std::string, double> environment, illumination, total;
    walk(design.environment, environment);
    walk(design.illumination, illumination);
    if (design.light_maps) {
      walk(design.light_maps->address, illumination);
      illumination["maps"] += static_cast<double>(design.light_maps->maps.size());
    }
    const published::Table1Cell* cell = published::table1_cell(id, "illumination");
    if (cell != nullptr && cell->includes_colour_blending) walk(build_scheme(*scheme, configuration).colour, illumination);
    for (const char* column : columns) total[column] = environment[column] + illumination[column];
    CAPTURE(id);
    for (const auto& [step, counts] :
         {std::pair("environment", &environment), std::pair("illumination", &illumination), std::pair("total", &total)}) {
      const Table1Row* row = find(defaults(), Table1Section::operators, id, step);
      REQUIRE(row != nullptr);
      for (const char* column : columns) {
        CAPTURE(step, column);
        CHECK(row->find(column)->derived == (*counts)[column]);
      }
    }
  }
}

TEST_CASE("every registered scheme has its rows, and the columns of Table 1 come first") {
  std::set<std::string> ids;
  for (const Table1Scheme& scheme : defaults().schemes) CHECK(ids.insert(scheme.id).second);
  for (const Scheme* scheme : all_schemes()) CHECK(ids.count(scheme->page().id) == 1);
  std::vector<std::string> order;
  for (const published::Table1Cell& cell : published::table1)
    if (order.empty() || order.back() != cell.scheme) order.emplace_back(cell.scheme);
  for (std::size_t i = 0; i < order.size(); ++i) CHECK(defaults().schemes[i].id == order[i]);
}

TEST_CASE("every number that the paper gives stands in the table") {
  for (const published::Table1Cell& cell : published::table1) {
    const Table1Row* row = find(defaults(), Table1Section::operators, std::string(cell.scheme), std::string(cell.unit));
    REQUIRE(row != nullptr);
    const std::vector<std::optional<double>> numbers = printed(cell.counts);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      CHECK(row->find(columns[i])->published == (cell.available ? numbers[i] : std::optional<double>()));
  }
  std::size_t counts = 0, sizes = 0;
  for (const Table1Row& row : defaults().rows) {
    if (row.section == Table1Section::text) {
      const std::vector<std::optional<double>> numbers = printed(published::text_counts[counts++].counts);
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        const Table1Value* value = row.find(columns[i]);
        CHECK((value != nullptr) == numbers[i].has_value());
        if (value != nullptr) CHECK(value->published == numbers[i]);
      }
    }
    if (row.section == Table1Section::text_sizes) CHECK(row.values.front().published == published::text_sizes[sizes++].bytes);
    if (row.section == Table1Section::claim)
      for (const Table1Value& value : row.values) CHECK(value.published == published::reduction_claim.percent);
  }
  CHECK(counts == published::text_counts.size());
  CHECK(sizes == published::text_sizes.size());
}

TEST_CASE("Table 1 closes at the defaults, and every number that differs has a reason, whatever is configured") {
  for (const Table1Row& row : defaults().rows)
    if (row.section == Table1Section::operators && row.kind == Table1Kind::step) {
      CAPTURE(row.scheme, row.step);
      CHECK(row.agreement != "differs");
    }
  const std::vector<std::vector<std::pair<std::string, std::string>>> settings = {
      {},
      {{"lee2007.form", "13"}},
      {{"lee2007.x_prime", "exact"}},
      {{"lee2007.word_bits", "12"}},
      {{"peercy1997.transform", "vertex"}},
      {{"kim2001.transform", "direct"}, {"kim2001.tables", "dual"}},
      {{"ernst1998.variant", "gouraud"}},
      {{"blinn1978.perturbation", "factored"}}};
  int different = 0;
  for (const auto& setting : settings) {
    const Table1 table = setting.empty() ? defaults() : make_table1(configured(setting));
    for (const Table1Row& row : table.rows)
      for (const Table1Value& value : row.values) {
        if (!value.differs()) continue;
        CAPTURE(row.scheme, row.step, row.settings, value.quantity);
        CHECK_FALSE(value.why.empty());
        ++different;
      }
    if (setting.empty()) continue;
    const std::string id = setting.front().first.substr(0, setting.front().first.find('.'));
    CHECK(table.scheme(id).configured.size() == setting.size());
    CHECK(table.settings.size() == setting.size());
  }
  CHECK(different > 50);
}

TEST_CASE("cells that agree by convention or by construction say what on") {
  int reasons = 0;
  for (const Table1Row& row : defaults().rows) {
    if (row.kind != Table1Kind::step || (row.agreement != "by convention" && row.agreement != "by construction")) continue;
    for (const Table1Value& value : row.values)
      if (*value.published != 0) {
        CHECK_FALSE(value.why.empty());
        ++reasons;
      }
  }
  CHECK(reasons > 20);
}

TEST_CASE("other readings are derived by building them") {
  const Table1Row* thirteen = find(defaults(), Table1Section::operators, "lee2007", "illumination", "lee2007.form=13");
  REQUIRE(thirteen != nullptr);
  CHECK(thirteen->find("adders")->derived == 13);
  CHECK(thirteen->find("adders")->published == 11);
  CHECK(thirteen->agreement == "differs");
  const Table1Row* vertex = find(defaults(), Table1Section::operators, "peercy1997", "environment", "peercy1997.transform=vertex");
  REQUIRE(vertex != nullptr);
  CHECK(vertex->find("multipliers")->derived == 9);
  CHECK(vertex->find("multipliers")->difference() == -18);
}

TEST_CASE("a reading that is configured is the cell itself, and is not repeated") {
  const Table1 table = make_table1(configured({{"lee2007.form", "13"}}));
  CHECK(find(table, Table1Section::operators, "lee2007", "illumination", "lee2007.form=13") == nullptr);
  const Table1Row* row = find(table, Table1Section::operators, "lee2007", "illumination");
  CHECK(row->agreement == "differs");
  CHECK(row->find("adders")->derived == 13);
  CHECK(row->find("adders")->why.find("lee2007.form=13 (default 11)") != std::string::npos);
  CHECK(row->find("adders")->why.find("section 5.2") != std::string::npos);
}

TEST_CASE("a reading that the configuration forbids says so") {
  const Table1 table = make_table1(configured({{"kim2001.map_filter", "vector"}}));
  const Table1Row* row = find(table, Table1Section::operators, "kim2001", "environment", "kim2001.transform=direct");
  REQUIRE(row != nullptr);
  CHECK(row->agreement == "not possible");
  CHECK_FALSE(row->find("multipliers")->derived);
  CHECK(row->why.find("kim2001.map_filter") != std::string::npos);
}

TEST_CASE("a column that no scheme models keeps its published numbers") {
  const Configuration configuration = configured();
  Table1Context context{configuration, {}};
  context.sources.emplace_back();
  context.sources.back().about.id = "kugler1998";
  Table1 table;
  table.schemes.push_back(context.sources.back().about);
  add_operators(context, table.rows);
  add_text_counts(context, table.rows);
  add_storage(context, table.rows);
  add_beyond(context, table.rows);
  const Table1Row* row = find(table, Table1Section::operators, "kugler1998", "environment");
  REQUIRE(row != nullptr);
  CHECK(row->agreement == "not modelled");
  CHECK_FALSE(row->find("multipliers")->derived);
  CHECK(row->find("multipliers")->published == 5);
  CHECK(row->find("multipliers")->why == "not modelled");
  CHECK(find(table, Table1Section::beyond, "kugler1998", "fragment") == nullptr);
}

TEST_CASE("the claimed saving is the maximum of the totals and of nothing else") {
  const Table1Row* environment = find(defaults(), Table1Section::claim, std::string(published::proposed), "environment");
  const Table1Row* total = find(defaults(), Table1Section::claim, std::string(published::proposed), "total");
  REQUIRE(environment != nullptr);
  REQUIRE(total != nullptr);
  CHECK(total->values[0].derived == Approx(100 * (1 - 8.0 / 37)).margin(0.05));
  CHECK(total->agreement == "maximum agrees");
  CHECK(environment->values[0].derived == Approx(100 * (1 - 6.0 / 31)).margin(0.05));
  CHECK(environment->agreement == "agrees, but is not the maximum");
  CHECK(environment->why.find("peercy1997, ernst1998") != std::string::npos);
}

TEST_CASE("exact rotations deliver the true light vector, and the proposed one does not") {
  for (const char* id : {"peercy1997", "ernst1998", "kim2001", "exact_polar", "lee2007_corrected"})
    CHECK(find(defaults(), Table1Section::beyond, id, "accuracy")->find("largest_error")->derived == 0.0);
  const Table1Row* proposed = find(defaults(), Table1Section::beyond, std::string(published::proposed), "accuracy");
  CHECK(*proposed->find("mean_error")->derived == Approx(17).margin(0.5));
  CHECK(*proposed->find("rms_error")->derived == Approx(21).margin(0.5));
}

TEST_CASE("sizes that the text gives follow from the netlists") {
  for (const Table1Row& row : defaults().rows) {
    if (row.section != Table1Section::text_sizes || row.agreement == "not modelled") continue;
    CAPTURE(row.scheme, row.step);
    if (row.step == "all memory" || row.step == "all tables and maps")
      CHECK_FALSE(row.values.front().why.empty());
    else
      CHECK(row.values.front().difference() == 0.0);
  }
}

TEST_CASE("a fragment executes what its units are built of") {
  for (const Table1Scheme& scheme : defaults().schemes) {
    if (!scheme.modelled) continue;
    std::map<std::string, double> sums;
    for (const char* unit : {"interpolators", "conversion", "environment", "light_map_address", "illumination", "colour"})
      if (const Table1Row* row = find(defaults(), Table1Section::beyond, scheme.id, unit))
        for (const char* column : columns) {
          sums[column] += *row->find(column)->derived;
          if (std::string(column) == "tables") sums[column] += *row->find("second_ports")->derived;
        }
    const Table1Row* fragment = find(defaults(), Table1Section::beyond, scheme.id, "fragment");
    REQUIRE(fragment != nullptr);
    for (const char* column : columns)
      if (std::string(column) != "maps") CHECK(fragment->find(column)->derived == sums[column]);
  }
}

TEST_CASE("CSV and JSON hold the same values") {
  const nlohmann::json json = nlohmann::json::parse(format_table1(defaults(), "json"));
  CHECK(json.at("schema") == "bumpsim-table1");
  CHECK(json.at("schema_version").is_number_integer());
  const std::vector<std::string> csv = lines(format_table1(defaults(), "csv"));
  const std::vector<std::string> header = split(csv.front(), ',');
  std::size_t at = 1;
  for (const char* section : {"operators", "text", "storage", "text_sizes", "reduction", "claim", "beyond"})
    for (const nlohmann::json& row : json.at(section))
      for (const Table1Row& known : defaults().rows) {
        if (name_of(known.section) != std::string(section) || known.scheme != row.at("scheme") || known.step != row.at("step") ||
            known.settings != row.value("settings", "") ||
            (row.contains("kind") && (row.at("kind") == "addition") != (known.kind == Table1Kind::addition)))
          continue;
        for (const Table1Value& value : known.values) {
          REQUIRE(at < csv.size());
          const std::vector<std::string> fields = split(csv[at++], ',');
          REQUIRE(fields.size() == header.size());
          const nlohmann::json& cell = row.at("cells").at(value.quantity);
          CHECK(fields[1] == known.scheme);
          CHECK(fields[5] == value.quantity);
          for (const auto& [column, key] : {std::pair(7, "derived"), std::pair(8, "published"), std::pair(9, "difference")})
            CHECK(fields[static_cast<std::size_t>(column)] == (cell.at(key).is_null() ? "" : cell.at(key).dump()));
          CHECK(cell.at("published").is_null() == !value.published.has_value());
          if (value.differs()) CHECK_FALSE(cell.at("why").get<std::string>().empty());
          CHECK(fields[10] == (row.at("reconstruction").get<bool>() ? "true" : "false"));
        }
      }
  CHECK(at == csv.size());
}

TEST_CASE("text and Markdown are the same document, and the text fits 140 columns") {
  const std::vector<std::string> text = lines(format_table1(defaults(), "text")), markdown = lines(format_table1(defaults(), "md"));
  for (const std::string& line : text) CHECK(line.size() <= 140);
  // Words in order, without what only one of the two spellings has.
  const auto words = [](const std::vector<std::string>& document) {
    std::vector<std::string> result;
    for (const std::string& line : document) {
      for (std::string word : split(line, ' ')) {
        if (word.find_first_not_of("|=-*#:.") == std::string::npos) continue;
        if (word.front() == '[') word = word.substr(1, word.find(']') - 1);
        if (word.back() == '.' && word.find_first_not_of("0123456789.") == std::string::npos) word.pop_back();
        result.push_back(word.back() == '|' ? word.substr(0, word.size() - 1) : word);
      }
    }
    return result;
  };
  std::vector<std::string> a = words(text), b = words(markdown);
  const auto drop = [](std::vector<std::string>& of, const std::vector<std::string>& sentence) {
    const auto found = std::search(of.begin(), of.end(), sentence.begin(), sentence.end());
    if (found != of.end()) of.erase(found, found + static_cast<std::ptrdiff_t>(sentence.size()));
  };
  drop(b, {"Written", "by", "`bumpsim", "table1", "--format", "md`."});
  CHECK(a == b);
}

TEST_CASE("reconstructions are marked in every format") {
  int marked = 0;
  const std::vector<std::string> text = lines(format_table1(defaults(), "text"));
  for (const Scheme* scheme : all_schemes()) {
    for (const std::string& step : scheme->page().reconstructed) {
      const Table1Row* row = find(defaults(), Table1Section::operators, scheme->page().id, step);
      REQUIRE(row != nullptr);
      CHECK(row->reconstruction);
      ++marked;
    }
  }
  CHECK(marked > 5);
  int in_text = 0;
  for (std::size_t i = 0; i < text.size() && text[i] != "Numbers of operators in the text"; ++i)
    in_text += text[i].find("environment (R) ") != std::string::npos || text[i].find("illumination (R) ") != std::string::npos ? 1 : 0;
  CHECK(in_text == marked);
  const nlohmann::json json = nlohmann::json::parse(format_table1(defaults(), "json"));
  for (const nlohmann::json& scheme : json.at("schemes")) CHECK(scheme.at("reconstruction") == !scheme.at("reconstructed_steps").empty());
}

TEST_CASE("the operators that Markdown shows are the table's") {
  const std::vector<std::string> markdown = lines(format_table1(defaults(), "md"));
  auto line = std::find(markdown.begin(), markdown.end(), "## Operators") + 4;
  for (const Table1Row& row : defaults().rows) {
    if (row.section != Table1Section::operators) continue;
    REQUIRE(line != markdown.end());
    const std::vector<std::string> cells = split(*line++, '|');
    REQUIRE(cells.size() == 12);
    for (std::size_t i = 0; i < std::size(columns); ++i) {
      const Table1Value& value = *row.find(columns[i]);
      const std::string shown = trimmed(cells[4 + i]);
      const std::string derived = value.derived ? std::to_string(std::lround(*value.derived)) : "?";
      const bool nothing = value.derived.value_or(0) == 0 && value.published.value_or(0) == 0;
      if (nothing)
        CHECK(shown == "-");
      else if (!value.published)
        CHECK(shown == derived);
      else
        CHECK(shown == derived + "/" + std::to_string(std::lround(*value.published)) + (value.differs() ? "*" : ""));
    }
  }
}
