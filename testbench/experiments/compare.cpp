#include "testbench/experiments/compare.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>

#include "datapath/invariant.h"
#include "testbench/experiments/child_processes.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/reference/cores.h"
#include "testbench/results/result_json.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

/// The share of a scheme's work that the simulation is; the rest is measuring.
constexpr double simulation_share = 0.9;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    words.push_back(trimmed(list.substr(begin, end - begin)));
    begin = end + 1;
  }
  return words;
}

[[noreturn]] void unknown_scheme(const std::string& word) {
  std::vector<std::string> ids;
  std::string list;
  for (const Scheme* scheme : all_schemes()) {
    ids.push_back(scheme->page().id);
    list += (list.empty() ? "" : ", ") + scheme->page().id;
  }
  const std::string near = nearest_word(word, ids);
  throw Error({word.empty() ? "a scheme without name between the commas of --schemes" : "unknown scheme '" + word + "'",
               {},
               "the schemes are: " + list,
               near.empty() ? "bumpsim list schemes, or --schemes all" : "--schemes with " + near + " instead"});
}

/// Document, warnings and frame as one string: the length of the JSON text, the text, the colours.
std::string pack(const Json& document, const SmallFrame& frame) {
  const std::string text = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::uint64_t length = text.size();
  std::string bytes(reinterpret_cast<const char*>(&length), sizeof length);
  bytes += text;
  bytes.append(frame.colour.begin(), frame.colour.end());
  return bytes;
}

Json unpack(const std::string& bytes, SmallFrame& frame) {
  std::uint64_t length = 0;
  BUMP_ASSERT(bytes.size() >= sizeof length);
  std::memcpy(&length, bytes.data(), sizeof length);
  BUMP_ASSERT(bytes.size() >= sizeof length + length);
  const char* text = bytes.data() + sizeof length;
  frame.colour.assign(text + length, bytes.data() + bytes.size());
  return Json::parse(text, text + length);
}

struct Task {
  const Scene& scene;
  const Scheme& scheme;
  const Configuration& configuration;
  const References& references;
  const std::string& engine;
  int shrink;  ///< 0: no frame

  std::string operator()(const ReportShare& report_share) const {
    MeasuredRun run(scene, scheme, configuration, engine);
    SimulationOptions options;
    options.progress = [&](double share) { report_share(simulation_share * share); };
    run.simulate(options);
    run.measure(references);
    Json result = to_json(run.report());
    result.erase("host");
    return pack({{"result", result}, {"warnings", run.warnings()}},
                shrink > 0 ? shrink_frame(run.result().hardware, shrink) : SmallFrame{});
  }
};

/// What is told more than once is told once, in the order of the rows.
void add_new(std::vector<std::string>& to, const Json& warnings) {
  for (const Json& warning : warnings)
    if (std::find(to.begin(), to.end(), warning.get<std::string>()) == to.end()) to.push_back(warning);
}

/// The place of a scheme without a result.
SmallFrame nothing_drawn(const SmallFrame& like) {
  return {like.width, like.height, std::vector<std::uint8_t>(like.colour.size(), 0)};
}

/// Errors of a process that died name its task; here the row does.
Error without_name(const Error& error, const std::string& id) {
  ErrorText text = error.text();
  if (text.what.rfind(id + ": ", 0) == 0) text.what.erase(0, id.size() + 2);
  return Error(error.kind(), text);
}

std::vector<std::string> label_of(const ComparisonRow& row) {
  if (row.error) return {marked_id(*row.page), "failed"};
  const Json& quality = row.result["quality"]["against_reference"];
  const Json& psnr = quality["psnr_db"];
  const bool identical = psnr.is_null() && quality["pixels"] > 0;
  return {marked_id(*row.page), psnr.is_number() ? fmt::format("{:.1f} dB", psnr.get<double>()) : identical ? "identical" : "-"};
}

}  // namespace

std::vector<const Scheme*> schemes_of(const std::string& list) {
  const std::vector<const Scheme*> known = all_schemes();
  std::vector<const Scheme*> schemes;
  const auto add = [&](const Scheme* scheme) {
    if (std::find(schemes.begin(), schemes.end(), scheme) == schemes.end()) schemes.push_back(scheme);
  };
  for (const std::string& word : split(list)) {
    const auto found = std::find_if(known.begin(), known.end(), [&](const Scheme* scheme) { return scheme->page().id == word; });
    if (word == "all")
      std::for_each(known.begin(), known.end(), add);
    else if (found == known.end())
      unknown_scheme(word);
    else
      add(*found);
  }
  return schemes;
}

Comparison compare(const Scene& scene, const std::vector<const Scheme*>& schemes, const Configuration& configuration,
                   const ComparisonOptions& options) {
  BUMP_ASSERT(!schemes.empty());
  engine_of(options.engine);
  const References references =
      draw_references(scene, configuration, options.cancelled, options.jobs > 0 ? options.jobs : cores_of_process());
  const PictureGrid grid(scene.width, scene.height, static_cast<int>(schemes.size()) + 1);

  std::vector<ChildTask> tasks;
  for (const Scheme* scheme : schemes)
    tasks.push_back(
        {scheme->page().id, Task{scene, *scheme, configuration, references, options.engine, options.picture ? grid.shrink : 0}});
  ChildOptions child_options;
  child_options.jobs = options.jobs;
  child_options.progress = options.progress;
  child_options.cancelled = options.cancelled;
  std::vector<ChildOutcome> outcomes = run_in_children(tasks, child_options);

  Comparison comparison;
  for (const Scheme* scheme : schemes) add_new(comparison.warnings, warnings_of(scene, scheme->page(), configuration));
  comparison.scene = &scene;
  comparison.configuration = &configuration;
  comparison.engine = options.engine;
  if (options.picture) comparison.reference = shrink_frame(references.normal_map, grid.shrink);
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    ComparisonRow row;
    row.page = &schemes[i]->page();
    if (outcomes[i].error) row.error = without_name(*outcomes[i].error, row.page->id);
    if (!row.error) {
      Json document = unpack(outcomes[i].bytes, row.frame);
      if (options.picture) {
        row.frame.width = grid.width;
        row.frame.height = grid.height;
      }
      row.result = std::move(document["result"]);
      add_new(comparison.warnings, document["warnings"]);
    }
    comparison.rows.push_back(std::move(row));
  }
  return comparison;
}

bool is_reconstruction(const SchemePage& page) {
  return !page.reconstructed.empty();
}

std::string marked_id(const SchemePage& page) {
  return page.id + (is_reconstruction(page) ? " (R)" : "");
}

const ComparisonRow* worst_failure(const Comparison& comparison) {
  const ComparisonRow* worst = nullptr;
  for (const ComparisonRow& row : comparison.rows)
    if (row.error && (worst == nullptr || row.error->kind() > worst->error->kind())) worst = &row;
  return worst;
}

bool is_void(const Comparison& comparison) {
  return std::all_of(comparison.rows.begin(), comparison.rows.end(), [](const ComparisonRow& row) { return row.error.has_value(); });
}

FrameBuffer picture_of(const Comparison& comparison) {
  std::vector<LabelledFrame> frames = {{{"reference"}, comparison.reference}};
  for (const ComparisonRow& row : comparison.rows)
    frames.push_back({label_of(row), row.error ? nothing_drawn(comparison.reference) : row.frame});
  const PictureGrid grid(comparison.scene->width, comparison.scene->height, static_cast<int>(comparison.rows.size()) + 1);
  return side_by_side(grid, frames);
}

}  // namespace bump
