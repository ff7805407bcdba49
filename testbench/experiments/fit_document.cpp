// A fit for readers.

#include <fmt/core.h>

#include <cmath>

#include "testbench/experiments/compare.h"
#include "testbench/experiments/compare_tables.h"
#include "testbench/experiments/document.h"
#include "testbench/experiments/fit_formats.h"
#include "testbench/experiments/sweep_columns.h"

namespace bump {

namespace {

std::string decibels(double value) {
  return std::isinf(value) ? (value > 0 ? "identical" : "-") : fmt::format("{:.2f}", value);
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// Without the scheme's id.
std::string short_key(const std::string& key) {
  return key.substr(key.find('.') + 1);
}

class Report {
 public:
  Report(const Fit& fit, bool markdown) : fit_(fit), document_(markdown) {}

  std::string text() {
    opening();
    results();
    widths();
    remarks();
    return document_.text();
  }

 private:
  void opening() {
    const FitOptions& options = fit_.options;
    std::vector<std::string> names;
    for (const Scene* scene : fit_.scenes) names.push_back(scene->name);
    document_.heading(1, fmt::format("Equal quality: {:g} dB on {}", options.psnr_db, joined(names, ", ")));
    document_.paragraph(fmt::format(
        "For each scheme the {} of least {} whose fixed-point picture is at least {:g} dB from {} on the worst scene, as far as a "
        "search finds them. Colours are unrounded, the background is left out.",
        options.search_structure ? "structure and widths" : "widths", name_of(options.cost), options.psnr_db,
        options.against == FitAgainst::reference ? "the reference (the same bump map in exact frames, double precision)"
                                                 : "the scheme's own evaluation in double precision, whatever that is worth"));
    std::vector<std::string> settings;
    for (const auto& [key, value, fallback] : differences_of(*fit_.configuration)) settings.push_back(key + "=" + value);
    if (!settings.empty()) document_.paragraph("Settings: " + joined(settings, ", ") + ".");
  }

  void results() {
    const PriceBook& book = fit_.options.book;
    std::vector<std::string> header = {"scheme", "result", "worst dB"};
    if (fit_.scenes.size() > 1)
      for (const Scene* scene : fit_.scenes) header.push_back(scene->name);
    for (const char* name : {"formula dB", "words dB", "mul", "add", "div", "sqrt", "tables", "table bits", "table KB", "texel bits"})
      header.push_back(name);
    if (book.area != nullptr) header.push_back("area NAND2");
    if (book.energy != nullptr) header.push_back("pJ a fragment");
    header.push_back("measured");
    std::vector<std::vector<std::string>> rows;
    for (const FitRow& row : fit_.rows) rows.push_back(cells(row, header.size()));
    document_.table(header, rows, 2);
  }

  std::vector<std::string> cells(const FitRow& row, std::size_t columns) const {
    std::vector<std::string> cells = {marked_id(*row.page), result_of(row)};
    if (row.error) {
      cells.resize(columns, "-");
      return cells;
    }
    cells.push_back(decibels(fit_.worst(row)));
    const bool own = fit_.options.against == FitAgainst::own_double;
    if (fit_.scenes.size() > 1)
      for (const FitQuality& quality : row.qualities) cells.push_back(decibels(own ? quality.to_double : quality.to_reference));
    cells.push_back(decibels(row.worst(&FitQuality::double_to_reference)));
    cells.push_back(decibels(row.worst(&FitQuality::to_double)));
    const DesignSize& size = row.size;
    for (const std::int64_t count :
         {size.multipliers, size.adders, size.dividers, size.square_roots, size.tables + size.maps, size.table_bits})
      cells.push_back(std::to_string(count));
    cells.push_back(fmt::format("{:.2f}", static_cast<double>(size.table_bits) / 8192));
    cells.push_back(std::to_string(size.texel_bits));
    if (fit_.options.book.area != nullptr) cells.push_back(size.area ? fmt::format("{:.0f}", *size.area) : "-");
    if (fit_.options.book.energy != nullptr) cells.push_back(size.energy ? fmt::format("{:.1f}", *size.energy) : "-");
    cells.push_back(std::to_string(row.measured));
    return cells;
  }

  static std::string result_of(const FitRow& row) {
    if (row.error) return "failed";
    if (!row.reached) return "not reached";
    return row.is_upper_bound() ? "reached, upper bound" : "reached";
  }

  void widths() {
    document_.heading(2, fit_.options.search_structure ? "Structure and widths" : "Widths");
    for (const FitRow& row : fit_.rows) {
      if (row.error) {
        document_.item(row.page->id + ": failed: " + reason_of(*row.error));
        continue;
      }
      std::vector<std::string> chosen, others;
      for (std::size_t i = 0; i < row.keys.size(); ++i) chosen.push_back(fmt::format("{} {}", short_key(row.keys[i]), row.widths[i]));
      std::string text = row.page->id + ": ";
      for (const auto& [key, value] : row.taken()) text += short_key(key) + "=" + value + ", ";
      text += chosen.empty() ? "no widths to choose" : joined(chosen, ", ");
      for (const std::string& key : row.set) others.push_back(short_key(key));
      if (!others.empty()) text += "; as set: " + joined(others, ", ");
      others.clear();
      for (const std::string& key : row.idle) others.push_back(short_key(key));
      if (!others.empty()) text += "; without effect here: " + joined(others, ", ");
      document_.item(text);
    }
  }

  void remarks() {
    document_.heading(2, "Remarks");
    document_.item(
        "formula dB: the scheme in double precision against the reference. Words may err in its favour, but hardly ever by much.");
    document_.item("words dB: fixed point against the same scheme in double precision. Both are the worst of the scenes.");
    document_.item(
        "Operators, tables and their bits: per-pixel datapaths without interpolators and colour unit, what is not in the published design "
        "included; one ROM for every read. Texel bits: of the bump map.");
    for (const PriceTable* table : {fit_.options.book.area, fit_.options.book.energy}) {
      if (table == nullptr) continue;
      const Quantity quantity = table == fit_.options.book.area ? Quantity::area : Quantity::energy;
      document_.item(fmt::format("{} ({}) by price table {}: registers of the pipeline included, colour unit, interpolators{} not; {}.",
                                 name_of(quantity), unit_of(quantity), table->name(),
                                 quantity == Quantity::energy ? ", memory traffic" : "", table->accuracy(quantity)));
    }
    for (const FitRow& row : fit_.rows) remark_on(row);
    kept_choices();
  }

  void remark_on(const FitRow& row) {
    if (row.error) return;
    if (!row.reached)
      document_.item(fmt::format("{}: not reached. The best of {} designs has {} dB; its structure and widths are shown. {}{}",
                                 row.page->id, row.measured, decibels(fit_.worst(row)), variants_tried(row), ceiling(row)));
    if (row.is_upper_bound()) {
      std::vector<std::string> keys;
      for (const std::string& key : row.costly_limits) keys.push_back(short_key(key));
      document_.item(fmt::format("{}: what it costs is an upper bound, as {} ended at the least that {} parameters allow.", row.page->id,
                                 joined(keys, ", "), keys.size() == 1 ? "its" : "their"));
    }
    if (!row.complete)
      document_.item(
          fmt::format("{}: the limit of {} designs ended the search before it found nothing better.", row.page->id, fit_.options.limit));
    if (row.failed > 0)
      document_.item(fmt::format("{}: {} of its designs failed when they were run, and were passed over.", row.page->id, row.failed));
  }

  void kept_choices() {
    for (const FitRow& row : fit_.rows) {
      std::vector<std::pair<std::string, std::vector<std::string>>> reasons;
      for (const FitStructure::Kept& kept : row.kept) {
        if (reasons.empty() || reasons.back().first != kept.reason) reasons.push_back({kept.reason, {}});
        reasons.back().second.push_back(short_key(kept.key));
      }
      for (const auto& [reason, keys] : reasons)
        document_.item(fmt::format("{}: {} kept: what {} is {}.", row.page->id, joined(keys, ", "),
                                   keys.size() == 1 ? "it decides" : "they decide", reason));
    }
  }

  /// What was tried of its structure.
  std::string variants_tried(const FitRow& row) const {
    const VariantCounts& variants = row.variants;
    if (!fit_.options.search_structure && !row.left.empty()) return "Its structure was not searched.";
    if (variants.possible == 1) return "There is no choice in its structure.";
    std::string text = fmt::format("Of {} combinations of its choices, {} were measured", variants.possible, variants.measured());
    const int rest = variants.possible - variants.measured() - variants.contradictory;
    if (variants.contradictory > 0)
      text += fmt::format(", {} contradict themselves or make the same design as another", variants.contradictory);
    if (rest > 0) text += fmt::format(", {} were left out by the limits of the search", rest);
    return text + ".";
  }

  std::string ceiling(const FitRow& row) const {
    const double formula = row.worst(&FitQuality::double_to_reference);
    if (fit_.options.against == FitAgainst::own_double || formula >= fit_.options.psnr_db) return "";
    return fmt::format(" The formula of the one shown has {} dB.", decibels(formula));
  }

  const Fit& fit_;
  Document document_;
};

}  // namespace

std::string fit_document(const Fit& fit, bool markdown) {
  return Report(fit, markdown).text();
}

}  // namespace bump
