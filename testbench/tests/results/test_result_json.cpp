#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "sample_report.h"
#include "testbench/results/result_json.h"

using namespace bump;
using bump::made_up::Sample;
using Json = nlohmann::ordered_json;
using Type = nlohmann::json::value_t;

TEST_CASE("result.json has every field of its contract, in its type") {
  const Sample sample;
  const Json json = Json::parse(to_json(sample.report).dump());
  const std::pair<const char*, Type> fields[] = {
      {"/schema", Type::string},
      {"/schema_version", Type::number_unsigned},
      {"/status", Type::string},
      {"/scene/name", Type::string},
      {"/scheme/id", Type::string},
      {"/engine", Type::string},
      {"/cycles", Type::number_unsigned},
      {"/fragments", Type::number_unsigned},
      {"/fragments_per_cycle", Type::number_float},
      {"/bound/cycles", Type::number_float},
      {"/bound/by", Type::string},
      {"/frames_per_second", Type::number_float},
      {"/operators/environment/built/multipliers", Type::number_unsigned},
      {"/operators/environment/built/square_roots", Type::number_unsigned},
      {"/operators/environment/built/shifters", Type::number_unsigned},
      {"/operators/environment/additional/adders", Type::number_unsigned},
      {"/operators/environment/used_per_fragment/tables", Type::number_float},
      {"/operators/environment/latency", Type::number_unsigned},
      {"/operators/illumination/initiation_interval", Type::number_unsigned},
      {"/tables/0/name", Type::string},
      {"/tables/0/entries", Type::number_unsigned},
      {"/tables/0/bits", Type::number_unsigned},
      {"/tables/0/reads", Type::number_unsigned},
      {"/texture/reads", Type::number_unsigned},
      {"/texture/hits", Type::number_unsigned},
      {"/texture/misses", Type::number_unsigned},
      {"/texture/bytes", Type::number_unsigned},
      {"/texture/hit_rate", Type::number_float},
      {"/geometry/triangles", Type::number_unsigned},
      {"/geometry/triangles_culled", Type::number_unsigned},
      {"/geometry/triangles_empty", Type::number_unsigned},
      {"/geometry/triangles_hidden", Type::number_unsigned},
      {"/geometry/triangles_drawn", Type::number_unsigned},
      {"/modules/1/name", Type::string},
      {"/modules/1/busy", Type::number_unsigned},
      {"/modules/1/starved", Type::number_unsigned},
      {"/modules/1/blocked", Type::number_unsigned},
      {"/fifos/0/depth", Type::number_unsigned},
      {"/fifos/0/max_occupancy", Type::number_unsigned},
      {"/fifos/0/full_cycles", Type::number_unsigned},
      {"/fifos/0/empty_cycles", Type::number_unsigned},
      {"/memory/0/requests", Type::number_unsigned},
      {"/quality/against_reference/psnr_db", Type::number_float},
      {"/quality/against_reference/nmse/2", Type::number_float},
      {"/quality/against_reference/pmse/0", Type::number_float},
      {"/quality/against_double/max_error", Type::number_float},
      {"/quality/against_blinn", Type::null},  // not measured in this run
      {"/angular_error/hardware/0/rms_degrees", Type::number_float},
      {"/inputs/1/path", Type::string},
      {"/inputs/1/sha256", Type::string},
      {"/host/wall_s", Type::number_float},
      {"/host/fragments_per_s", Type::number_float},
      {"/host/peak_rss_mib", Type::number_float},
      {"/host/compiler", Type::string},
      {"/host/version", Type::string},
  };
  for (const auto& [path, type] : fields) {
    INFO(path);
    const Json::json_pointer pointer(path);
    REQUIRE(json.contains(pointer));
    CHECK(json.at(pointer).type() == type);
  }
}

TEST_CASE("derived numbers of result.json follow from the counts beside them") {
  const Sample sample;
  const Json json = to_json(sample.report);
  CHECK(json["fragments_per_cycle"] == 0.25);
  CHECK(json["frames_per_second"] == 100e6 / 1000);
  CHECK(json["texture"]["hit_rate"].get<double>() == Approx(870.0 / 900));
  const Json& geometry = json["geometry"];
  CHECK(geometry["triangles_hidden"] == 1);
  CHECK(geometry["triangles_drawn"] == 2);
  CHECK(json["operators"]["environment"]["used_per_fragment"]["adders"] == 18);       // additions are executed as well
  CHECK(json["operators"]["illumination"]["used_per_fragment"]["multipliers"] == 4);  // two lights
}

TEST_CASE("what does not apply is null, never 0") {
  Sample sample;
  sample.result.timing.cycles = 0;
  sample.result.fragments = 0;
  sample.result.texture = {};
  sample.result.timing.stages[0].last_delivery = -1;
  sample.result.angular_errors = {AngularError{}};
  const Json json = to_json(sample.report);
  CHECK(json["fragments_per_cycle"].is_null());
  CHECK(json["frames_per_second"].is_null());
  CHECK(json["texture"]["hit_rate"].is_null());
  CHECK(json["operators"]["environment"]["used_per_fragment"].is_null());
  CHECK(json["modules"][0]["last_delivery"].is_null());
  CHECK(json["angular_error"]["hardware"][0]["count"] == 0);
  for (const char* of : {"mean_degrees", "rms_degrees", "max_degrees"}) CHECK(json["angular_error"]["hardware"][0][of].is_null());
  CHECK(json["angular_error"]["double"][0]["mean_degrees"] == 3.4);
  CHECK_FALSE(json.contains("config"));
}

TEST_CASE("identical images have a null signal-to-noise ratio and a note") {
  const FrameBuffer frame = made_up::frame(8, 8, 0);
  const Json json = to_json(compare_frames(frame, frame));
  CHECK(json["psnr_db"].is_null());
  CHECK(json["nmse"] == Json::array({0.0, 0.0, 0.0}));
  CHECK(json["note"].get<std::string>().find("identical") != std::string::npos);
  FrameBuffer nothing = frame;
  for (auto& object : nothing.object) object = -1;
  CHECK(to_json(compare_frames(nothing, frame))["note"].get<std::string>().find("no pixel") != std::string::npos);
}

TEST_CASE("the configuration goes into the result with its types") {
  Parameters parameters;
  parameters.integer("fifos.depth", 8, 1, 100, "tokens", "slots");
  parameters.boolean("lee2007.absolute", true, "a switch");
  parameters.choice("filter", "bilinear", {"nearest", "bilinear"}, "a word");
  parameters.number("clock.megahertz", 100, 1, 1000, "MHz", "clock");
  Configuration configuration(parameters);
  configuration.set_text("fifos.depth", "16", {"--set", 0, 0});
  Sample sample;
  sample.report.configuration = &configuration;
  const Json json = to_json(sample.report);
  CHECK(json["config"]["fifos.depth"] == 16);
  CHECK(json["config"]["lee2007.absolute"] == true);
  CHECK(json["config"]["filter"] == "bilinear");
  CHECK(json["config"]["clock.megahertz"] == 100.0);
}

TEST_CASE("a path that is not UTF-8 does not keep the result from being written") {
  Sample sample;
  sample.scene.inputs[0].path = "wo\xff\xfeod.png";
  const Json json = Json::parse(json_text(sample.report));
  CHECK(json["inputs"][0]["path"] == "wo\xEF\xBF\xBD\xEF\xBF\xBDod.png");
}

TEST_CASE("light maps are listed where there are any, and not mentioned otherwise") {
  Sample sample;
  CHECK_FALSE(to_json(sample.report).contains("light_maps"));
  sample.result.light_maps = {{"diffuse", 1024, 16384, 2048, 2048, {250, 200, 50, 3200, 3}}, {"specular", 1024, 16384, 2048, 2048, {}}};
  const Json maps = to_json(sample.report)["light_maps"];
  REQUIRE(maps.size() == 2);
  CHECK(maps[0] == Json({{"name", "diffuse"},
                         {"entries", 1024},
                         {"bits", 16384},
                         {"words_written", 2048},
                         {"bytes_written", 2048},
                         {"reads", 250},
                         {"hits", 200},
                         {"misses", 50},
                         {"hit_rate", 0.8},
                         {"bytes", 3200},
                         {"clipped", 3}}));
  CHECK(maps[1]["hit_rate"].is_null());
}
