#include "testbench/results/summary.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

#include "testbench/published/lee2007_table1.h"

namespace bump {

namespace {

constexpr int columns = 96;

/// 1234567 -> "1,234,567".
std::string grouped(std::int64_t number) {
  std::string digits = fmt::format("{}", number < 0 ? -number : number);
  for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3) digits.insert(static_cast<std::size_t>(i), ",");
  return number < 0 ? "-" + digits : digits;
}

std::string share(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? fmt::format("{:.1f} %", 100.0 * static_cast<double>(part) / static_cast<double>(whole)) : "-";
}

std::string optional(const std::optional<double>& value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : "-";
}

std::string kilobytes(std::int64_t bits) {
  return fmt::format("{:.2f} KB", static_cast<double>(bits) / 8192);
}

std::string heading(const std::string& text) {
  return "\n" + text + "\n";
}

/// A paragraph of lines no wider than the page, indented by two, from the second line on by four.
std::string wrapped(const std::string& text) {
  std::string lines, line = " ";
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > columns) {
      lines += line + "\n";
      line = "   ";
    }
    line += " " + word;
  }
  return lines + line + "\n";
}

class Summary {
 public:
  explicit Summary(const RunReport& report) : report_(report), result_(*report.result) {}

  std::string text() {
    head();
    operators();
    tables();
    texture();
    light_maps();
    modules();
    fifos();
    quality();
    files();
    return std::move(text_);
  }

 private:
  template <typename... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    while (!text_.empty() && text_.back() == ' ') text_.pop_back();
    text_ += '\n';
  }

  void head() {
    const Scene& scene = *report_.scene;
    const SchemePage& page = report_.scheme->page();
    line("{} on {}: {}", page.id, scene.name, page.title);
    line("{}", std::string(columns, '-'));
    line("{} x {} pixels, {} triangles, {} {}, {} engine, {:g} MHz", scene.width, scene.height, grouped(result_.geometry.triangles),
         scene.lights.size(), scene.lights.size() == 1 ? "light" : "lights", report_.engine, result_.clock_megahertz);
    line("");
    line("  {:<20}{:>14}    {:<20}{:>14}", "cycles", grouped(result_.timing.cycles), "fragments", grouped(result_.fragments));
    line("  {:<20}{:>14}    {:<20}{:>14}", "fragments per cycle", optional(fragments_per_cycle(result_), 4), "frames per second",
         optional(frames_per_second(result_), 1));
    const double bound = result_.bound.cycles;
    line("  {:<20}{:>14}    {:<20}{}", "bound, cycles", grouped(std::llround(bound)), "set by", result_.bound.by);
    if (result_.timing.cycles > 0)
      line("  {:<20}{:>14}", "bound reached", fmt::format("{:.1f} %", 100 * bound / static_cast<double>(result_.timing.cycles)));
  }

  /// A column that only designs with logarithms have.
  bool has_shifters() const {
    return std::any_of(result_.units.begin(), result_.units.end(),
                       [](const UnitCost& unit) { return unit.published.shifters + unit.addition.shifters > 0; });
  }

  /// "6 | 6": what the netlist counts, and what Table 1 prints beside it.
  static std::string cell(int built, int published, bool available, bool& differs) {
    if (!available) return built ? fmt::format("{:>3}    ", built) : fmt::format("{:>3}    ", "-");
    if (built == 0 && published == 0) return fmt::format("{:>3}    ", "-");
    differs = differs || built != published;
    return fmt::format("{:>3} |{:>2}", built, published);
  }

  void operator_line(const std::string& name, const Inventory& counts, const published::Table1Cell* published, const std::string& timing) {
    const bool available = published && published->available;
    const published::OperatorCounts printed = available ? published->counts : published::OperatorCounts{};
    bool differs = false;
    const std::pair<int, int> pairs[] = {{counts.multipliers, printed.multipliers}, {counts.adders, printed.adders},
                                         {counts.dividers, printed.dividers},       {counts.square_roots, printed.square_roots},
                                         {counts.tables, printed.tables},           {counts.maps, printed.maps}};
    std::string cells;
    for (const auto& [built, paper] : pairs) cells += fmt::format("{:>9}", cell(built, paper, available, differs));
    if (has_shifters()) cells += fmt::format("{:>9}", fmt::format("{:>3}    ", counts.shifters ? std::to_string(counts.shifters) : "-"));
    line("  {:<18}{}{:>16}", name, cells, timing);
    if (!published) return;
    if (!published->available) notes_.push_back(fmt::format("{}: not available in Table 1", name));
    if (differs) notes_.push_back(fmt::format("{}: Table 1 differs{}{}", name, published->remark.empty() ? "" : "; ", published->remark));
  }

  /// Table 1's step where light maps divide it between units.
  void illumination_step() {
    const published::Table1Cell* cell = published::table1_cell(report_.scheme->page().id, "illumination");
    if (cell == nullptr) return;
    Inventory step;
    for (const UnitCost& unit : result_.units) {
      const bool colour = unit.name == "colour" && cell->includes_colour_blending;
      if (colour || unit.name == "light_map_address" || unit.name == "illumination") step += unit.published;
    }
    operator_line(cell->includes_colour_blending ? "  address to colour" : "  address and it", step, cell, "");
  }

  void operators() {
    if (result_.units.empty()) return;
    text_ += heading("operators built | Table 1 of Lee 2007 (published, where it lists the scheme)");
    line("  {:<18}{:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {}{:>16}", "", "mult  ", "add  ", "div  ", "sqrt  ", "table  ", "map  ",
         has_shifters() ? " shifter " : "", "latency/interval");
    const auto has_unit = [](const UnitCost& unit) { return unit.name == "light_map_address"; };
    const bool in_parts = std::any_of(result_.units.begin(), result_.units.end(), has_unit);
    for (const UnitCost& unit : result_.units) {
      const std::string timing =
          unit.pipeline ? fmt::format("{} / {}", unit.pipeline->latency, unit.pipeline->initiation_interval) : std::string("-");
      const bool is_part = in_parts && unit.name == "illumination";
      operator_line(unit.name, unit.published, is_part ? nullptr : published::table1_cell(report_.scheme->page().id, unit.name), timing);
      const Inventory& more = unit.addition;
      if (more.multipliers + more.adders + more.dividers + more.square_roots + more.tables + more.maps + more.shifters > 0)
        operator_line("  + beside them", more, nullptr, "");
      if (unit.pipeline && unit.pipeline->multipliers < unit.published.multipliers + more.multipliers)
        line("    shared: {} multipliers in hardware", unit.pipeline->multipliers);
    }
    if (in_parts) illumination_step();
    for (const std::string& note : notes_) text_ += wrapped(note);
    line("  interpolated components besides u, v: {}", result_.interpolator_components);
  }

  void tables() {
    if (result_.tables.empty()) return;
    std::int64_t distinct = 0, copies = 0, reads = 0;
    for (const TableUse& table : result_.tables) {
      distinct += table.bits;
      copies += table.bits * table.copies;
      reads += table.reads;
    }
    text_ += heading("tables and texture");
    line("  {:<20}{:>14} in ROMs, {} of distinct contents, {} reads", "tables", kilobytes(copies), kilobytes(distinct), grouped(reads));
  }

  void texture() {
    const TextureCounters& texture = result_.texture;
    if (texture.reads == 0) return;
    if (result_.tables.empty()) text_ += heading("tables and texture");
    const std::optional<double> rate = hit_rate(texture);
    line("  {:<20}{:>14} hits of {} line look-ups, {} texels, {:.1f} KB from memory", "texture cache",
         rate ? fmt::format("{:.2f} %", 100 * *rate) : "-", grouped(texture.accesses), grouped(texture.reads),
         static_cast<double>(texture.bytes) / 1024);
  }

  void light_maps() {
    if (result_.light_maps.empty()) return;
    text_ += heading("light maps, filled once a frame");
    for (const LightMapUse& map : result_.light_maps) {
      const std::optional<double> rate = hit_rate(map.counters);
      line("  {:<20}{:>14} hits of {} reads, {:.1f} KB from memory", map.name, rate ? fmt::format("{:.2f} %", 100 * *rate) : "-",
           grouped(map.counters.reads), static_cast<double>(map.counters.bytes) / 1024);
      line("  {:<20}{:>14} words, {} written each frame", "", grouped(map.words_written), kilobytes(8 * map.bytes_written));
      if (map.counters.clipped > 0)
        line("  {:<20}{:>14} reads of words that were cut off: the lights are too bright for the format", "",
             grouped(map.counters.clipped));
    }
  }

  void modules() {
    if (result_.timing.stages.empty()) return;
    const Cycle cycles = result_.timing.cycles;
    text_ += heading("modules, share of all cycles");
    line("  {:<18}{:>12}{:>10}{:>10}{:>10}{:>14}  {}", "", "tokens", "busy", "starved", "blocked", "output full", "busy");
    for (const StageStatistics& stage : result_.timing.stages) {
      const auto filled = cycles > 0 ? static_cast<std::size_t>(std::clamp<Cycle>((20 * stage.busy + cycles / 2) / cycles, 0, 20)) : 0;
      line("  {:<18}{:>12}{:>10}{:>10}{:>10}{:>14}  {}", stage.name, grouped(stage.tokens), share(stage.busy, cycles),
           share(stage.starved, cycles), share(stage.blocked_room, cycles), share(stage.blocked_output, cycles), std::string(filled, '#'));
    }
    for (const MemoryStatistics& memory : result_.timing.memories)
      line("  {:<18}{:>12}{:>10}   (requests, bus busy)", memory.name, grouped(memory.requests), share(memory.busy, cycles));
  }

  void fifos() {
    if (result_.timing.fifos.empty()) return;
    const Cycle cycles = result_.timing.cycles;
    text_ += heading("FIFOs, share of all cycles");
    line("  {:<42}{:>8}{:>12}{:>10}{:>10}", "", "depth", "most held", "full", "empty");
    for (const FifoStatistics& fifo : result_.timing.fifos)
      line("  {:<42}{:>8}{:>12}{:>10}{:>10}", fifo.name, fifo.depth, fifo.max_occupancy, share(fifo.full_cycles, cycles),
           share(fifo.empty_cycles, cycles));
  }

  void quality_line(const std::string& name, const std::optional<Quality>& quality) {
    if (!quality) return;
    if (quality->pixels == 0) {
      line("  {:<34}no pixel shows the same surface in both", name);
      return;
    }
    const std::string psnr = std::isinf(quality->psnr_db) ? "identical" : fmt::format("{:.2f}", quality->psnr_db);
    line("  {:<34}{:>10}{:>9.1f}{:>9.3f}{:>11.2e}{:>11}{:>10}", name, psnr, quality->max_error, quality->mean_error,
         (quality->nmse[0] + quality->nmse[1] + quality->nmse[2]) / 3, grouped(quality->pixels), grouped(quality->excluded));
  }

  void quality() {
    if (report_.against_reference || report_.against_double || report_.against_blinn || report_.double_against_reference) {
      text_ += heading("image quality over object pixels (errors in steps of 255)");
      line("  {:<34}{:>10}{:>9}{:>9}{:>11}{:>11}{:>10}", "", "PSNR dB", "largest", "mean", "NMSE", "pixels", "left out");
      quality_line("hardware / reference, same map", report_.against_reference);
      quality_line("hardware / scheme in double", report_.against_double);
      quality_line("scheme in double / reference", report_.double_against_reference);
      quality_line("hardware / Blinn from heights", report_.against_blinn);
    } else {
      text_ += heading("image quality: not measured");
    }
    if (result_.angular_errors.empty()) return;
    text_ += heading("angle from the exact vector, degrees");
    line("  {:<34}{:>10}{:>9}{:>9}", "", "mean", "rms", "largest");
    for (const AngularError& error : result_.angular_errors) angle_line(error, "hardware");
    for (const AngularError& error : result_.angular_errors_exact) angle_line(error, "scheme in double");
  }

  void angle_line(const AngularError& error, const std::string& of) {
    const auto angle = [](double degrees) { return std::isnan(degrees) ? "-" : fmt::format("{:.3f}", degrees); };
    line("  {:<34}{:>10}{:>9}{:>9}", error.vector + ", " + of, angle(error.mean_degrees), angle(error.rms_degrees),
         angle(error.max_degrees));
  }

  void files() {
    if (report_.out.empty()) return;
    line("\nresult in {}", report_.out);
    line("  result.json  config.resolved.toml  stats.csv  frame.png  frame.exr{}", report_.error_picture ? "  error.png" : "");
  }

  const RunReport& report_;
  const SimulationResult& result_;
  std::string text_;
  std::vector<std::string> notes_;
};

}  // namespace

std::string summary(const RunReport& report) {
  return Summary(report).text();
}

}  // namespace bump
