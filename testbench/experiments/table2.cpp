#include "testbench/experiments/table2.h"

#include <algorithm>
#include <utility>

#include "datapath/invariant.h"
#include "schemes/scheme.h"
#include "testbench/experiments/child_processes.h"
#include "testbench/experiments/frame_bytes.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/experiments/table2_filters.h"
#include "testbench/experiments/table2_scenes.h"

namespace bump {

namespace {

/// A simulation of the second round: a picture of the table, one point of the dependence on the light, or one of that on the filter.
struct Drawing {
  std::size_t scene = 0;
  std::string method;
  ShadingSpace space = ShadingSpace::object;
  std::optional<std::size_t> moved;   ///< which of the scene's moved lights
  std::optional<std::string> filter;  ///< of the bump map, where it is not the table's own
};

class Experiment {
 public:
  Experiment(const std::vector<Scene>& shipped, const Configuration& configuration, const Table2Options& options)
      : configuration_(configuration), options_(options) {
    BUMP_ASSERT(shipped.size() == table2_scenes.size());
    for (const ShadingSpace space : shading_spaces) {
      configurations_.push_back(configuration);
      configurations_.back().set("vertex_processor.space", name_of(space), Location("table2"));
    }
    table_.texture_filter = configuration.choice("texture_fetch.filter");
    table_.proposed_filter = configuration.choice("lee2007.map_filter");
    table_.kim_filter = configuration.choice("kim2001.map_filter");
    for (std::size_t s = 0; s < shipped.size(); ++s) {
      const double degrees = table2_scenes[s].light_degrees;
      table_.scenes.push_back(arrange_table2_scene(shipped[s], {degrees, 0}));
      moved_.emplace_back();
      if (!options.angles) continue;
      for (const double angle : table2_angles) move_light(shipped[s], {angle, 0});
      for (const double azimuth : table2_azimuths)
        if (azimuth != 0) move_light(shipped[s], {degrees, azimuth});  // 0 is in the table itself
    }
  }

  Table2 run() {
    draw_all_references();
    draw_all_pictures();
    for (std::size_t s = 0; s < table_.scenes.size(); ++s) compare(std::string(table2_scenes[s].name));
    sort_moved_lights();
    sort_filters();
    return std::move(table_);
  }

 private:
  /// The last scene with its light elsewhere.
  struct Moved {
    Table2Light light;
    Scene scene;
    EightBitImage reference;
  };

  void move_light(const Scene& shipped, const Table2Light& light) {
    moved_.back().push_back({light, arrange_table2_scene(shipped, light), {}});
    // One reference is enough here: without heights, Blinn's is not drawn.
    for (SceneObject& object : moved_.back().back().scene.objects) object.heights = nullptr;
  }

  static constexpr double share_of_references = 0.15;

  std::vector<std::string> in_children(const std::vector<ChildTask>& tasks, double from, double to) {
    ChildOptions children;
    children.jobs = options_.jobs;
    children.cancelled = options_.cancelled;
    if (options_.progress) children.progress = [this, from, to](double share) { options_.progress(from + share * (to - from)); };
    std::vector<std::string> bytes;
    for (ChildOutcome& outcome : run_in_children(tasks, children)) {
      if (outcome.error) throw *outcome.error;
      bytes.push_back(std::move(outcome.bytes));
    }
    return bytes;
  }

  void draw_all_references() {
    std::vector<ChildTask> tasks;
    for (std::size_t s = 0; s < table_.scenes.size(); ++s) {
      tasks.push_back({"references of " + table_.scenes[s].name, [this, s](const ReportShare&) {
                         const References drawn = draw_references(table_.scenes[s], configuration_, options_.cancelled);
                         std::string bytes;
                         append(bytes, drawn.normal_map);
                         if (drawn.blinn) append(bytes, *drawn.blinn);
                         return bytes;
                       }});
      for (const Moved& moved : moved_[s]) {
        const Scene& scene = moved.scene;
        tasks.push_back({"reference of " + scene.name, [this, &scene](const ReportShare&) {
                           std::string bytes;
                           append(bytes, eight_bit(draw_references(scene, configuration_, options_.cancelled).normal_map));
                           return bytes;
                         }});
      }
    }
    const std::vector<std::string> drawn = in_children(tasks, 0, share_of_references);
    std::size_t task = 0;
    for (std::size_t s = 0; s < table_.scenes.size(); ++s) {
      ByteReader reader(drawn[task++]);
      References references;
      reader.read(references.normal_map);
      if (!reader.at_end()) reader.read(references.blinn.emplace());
      references_.push_back(std::move(references));
      for (Moved& moved : moved_[s]) ByteReader(drawn[task++]).read(moved.reference);
    }
  }

  const Configuration& configuration_of(ShadingSpace space) const { return configurations_[space == ShadingSpace::eye ? 1 : 0]; }

  /// In a child. Bytes of the frame and, if there is one, of the angular error of L'.
  std::string draw(const Drawing& drawing, const ReportShare& report_share) const {
    SimulationOptions options;
    options.cancelled = options_.cancelled;
    options.progress = report_share;
    if (drawing.filter)
      return draw_filtered(table_.scenes[drawing.scene], find_scheme(scheme_of(drawing.method)), configuration_of(drawing.space),
                           *drawing.filter, references_[drawing.scene].normal_map, options);
    options.measure = !drawing.moved;
    const Scene& scene = drawing.moved ? moved_[drawing.scene][*drawing.moved].scene : table_.scenes[drawing.scene];
    MeasuredRun run(scene, find_scheme(scheme_of(drawing.method)), configuration_of(drawing.space), "dated");
    run.simulate(options);
    std::string bytes;
    if (drawing.moved) {
      append(bytes, eight_bit(run.result().hardware));
      return bytes;
    }
    run.measure(references_[drawing.scene]);  // with it goes the check of the scheme's stated bound
    append(bytes, run.result().hardware);
    for (const AngularError& error : run.result().angular_errors)
      if (error.vector == "L'") append(bytes, error);
    return bytes;
  }

  void draw_all_pictures() {
    std::vector<Drawing> drawings;
    for (std::size_t s = 0; s < table_.scenes.size(); ++s) {
      for (const ShadingSpace space : shading_spaces) {
        for (const char* method : {"proposed", "kim"}) {
          drawings.push_back({s, method, space, {}, {}});
          for (const char* filter : table2_filters)
            if (filter != table_.filter_of(method)) drawings.push_back({s, method, space, {}, filter});
        }
        for (std::size_t m = 0; m < moved_[s].size(); ++m) drawings.push_back({s, "proposed", space, m, {}});
      }
    }
    std::vector<ChildTask> tasks;
    for (const Drawing& drawing : drawings) {
      const std::string name = scheme_of(drawing.method) + " on " + table_.scenes[drawing.scene].name;
      tasks.push_back({name, [this, drawing](const ReportShare& report_share) { return draw(drawing, report_share); }});
    }
    std::vector<std::string> drawn = in_children(tasks, share_of_references, 1);
    for (std::size_t i = 0; i < drawings.size(); ++i) {
      keep(drawings[i], drawn[i]);
      drawn[i] = {};
    }
    for (std::size_t s = 0; s < references_.size(); ++s) {
      const std::string scene(table2_scenes[s].name);
      table_.pictures.push_back({scene, "conventional", {}, std::move(references_[s].normal_map), {}});
      if (references_[s].blinn) table_.pictures.push_back({scene, "blinn", {}, std::move(*references_[s].blinn), {}});
    }
  }

  void keep(const Drawing& drawing, const std::string& bytes) {
    const std::string scene(table2_scenes[drawing.scene].name);
    if (drawing.filter) {
      table_.filtered.push_back({scene, drawing.method, drawing.space, *drawing.filter, {}, 0, {}});
      read_filtered(bytes, table_.filtered.back());
      return;
    }
    ByteReader reader(bytes);
    if (drawing.moved) {
      const Moved& moved = moved_[drawing.scene][*drawing.moved];
      EightBitImage image;
      reader.read(image);
      table_.angles.push_back({scene, drawing.space, moved.light, whole_frame_measures(image, moved.reference).nmse});
      return;
    }
    Table2Picture picture;
    picture.scene = scene;
    picture.method = drawing.method;
    picture.space = drawing.space;
    reader.read(picture.frame);
    if (!reader.at_end()) reader.read(picture.light.emplace());
    table_.pictures.push_back(std::move(picture));
  }

  void compare(const std::string& scene, const std::string& test, const std::string& reference, std::optional<ShadingSpace> space) {
    const Table2Picture* of_test = table_.picture(scene, test, space);
    const Table2Picture* of_reference = table_.picture(scene, reference, reference == "kim" ? space : std::nullopt);
    if (of_test == nullptr || of_reference == nullptr) return;  // no heights, no picture from heights
    Table2Comparison comparison;
    comparison.scene = scene;
    comparison.test = test;
    comparison.reference = reference;
    comparison.space = space;
    comparison.whole = whole_frame_measures(eight_bit(of_test->frame), eight_bit(of_reference->frame));
    comparison.objects = compare_frames(of_test->frame, of_reference->frame);
    if (test == "proposed") comparison.published = published::table2_row(scene, reference == "blinn" ? "conventional" : reference);
    table_.comparisons.push_back(comparison);
  }

  void compare(const std::string& scene) {
    for (const ShadingSpace space : shading_spaces) {
      for (const char* reference : {"conventional", "kim", "blinn"}) compare(scene, "proposed", reference, space);
      for (const char* reference : {"conventional", "blinn"}) compare(scene, "kim", reference, space);
    }
    compare(scene, "conventional", "blinn", std::nullopt);
  }

  /// What was swept over the azimuth goes to its own list, with azimuth 0 from the table in front.
  void sort_moved_lights() {
    if (!options_.angles) return;
    std::vector<Table2Angle> all = std::move(table_.angles);
    table_.angles.clear();
    for (const Table2Scene& scene : table2_scenes) {
      for (const ShadingSpace space : shading_spaces) {
        const std::string name(scene.name);
        table_.azimuths.push_back(
            {name, space, {scene.light_degrees, 0}, table_.comparison(name, "proposed", "conventional", space)->whole.nmse});
        for (Table2Angle& one : all)
          if (one.scene == name && one.space == space) (one.light.azimuth == 0 ? table_.angles : table_.azimuths).push_back(one);
      }
    }
  }

  /// In order, with the table's own pictures among them.
  void sort_filters() {
    std::vector<Table2Filtered> all;
    for (const Table2Scene& scene : table2_scenes) {
      const std::string name(scene.name);
      for (const ShadingSpace space : shading_spaces) {
        for (const char* method : {"proposed", "kim"}) {
          for (const char* filter : table2_filters) {
            const Table2Filtered* drawn = table_.filtered_picture(name, method, space, filter);
            const Table2Comparison* own = table_.comparison(name, method, "conventional", space);
            BUMP_ASSERT(drawn != nullptr || filter == table_.filter_of(method));
            all.push_back(drawn != nullptr ? *drawn
                                           : Table2Filtered{name, method, space, filter, own->whole.nmse, own->objects.psnr_db, {}});
          }
        }
      }
    }
    table_.filtered = std::move(all);
  }

  const Configuration& configuration_;
  const Table2Options& options_;
  std::vector<Configuration> configurations_;  ///< one per space
  std::vector<std::vector<Moved>> moved_;      ///< per scene
  std::vector<References> references_;
  Table2 table_;
};

}  // namespace

std::string name_of(ShadingSpace space) {
  return space == ShadingSpace::object ? "object" : "eye";
}

std::string scheme_of(const std::string& method) {
  BUMP_ASSERT(method == "proposed" || method == "kim");
  return method == "proposed" ? "lee2007" : "kim2001";
}

const Table2Picture* Table2::picture(const std::string& scene, const std::string& method, std::optional<ShadingSpace> space) const {
  const auto found = std::find_if(pictures.begin(), pictures.end(),
                                  [&](const Table2Picture& p) { return p.scene == scene && p.method == method && p.space == space; });
  return found == pictures.end() ? nullptr : &*found;
}

const Table2Comparison* Table2::comparison(const std::string& scene, const std::string& test, const std::string& reference,
                                           std::optional<ShadingSpace> space) const {
  const auto found = std::find_if(comparisons.begin(), comparisons.end(), [&](const Table2Comparison& c) {
    return c.scene == scene && c.test == test && c.reference == reference && c.space == space;
  });
  return found == comparisons.end() ? nullptr : &*found;
}

const Table2Filtered* Table2::filtered_picture(const std::string& scene, const std::string& test, ShadingSpace space,
                                               const std::string& filter) const {
  const auto found = std::find_if(filtered.begin(), filtered.end(), [&](const Table2Filtered& p) {
    return p.scene == scene && p.test == test && p.space == space && p.filter == filter;
  });
  return found == filtered.end() ? nullptr : &*found;
}

const std::string& Table2::filter_of(const std::string& method) const {
  BUMP_ASSERT(method == "proposed" || method == "kim");
  return method == "proposed" ? proposed_filter : kim_filter;
}

Table2 measure_table2(const std::vector<Scene>& shipped, const Configuration& configuration, const Table2Options& options) {
  if (configuration.entries().at("vertex_processor.space").origin.file != "default")
    throw Error({"vertex_processor.space cannot be set for this table", configuration.entries().at("vertex_processor.space").origin,
                 "it draws every scene in both spaces", "leave it out"});
  return Experiment(shipped, configuration, options).run();
}

}  // namespace bump
