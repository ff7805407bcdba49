// `bumpsim fit` and `bumpsim pareto` as a user meets them.

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "program_runner.h"

using namespace bump;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::string tiny_scene() {
  std::string scene = small_scene();
  scene.replace(scene.find("width = 96"), 10, "width = 48");
  scene.replace(scene.find("height = 80"), 11, "height = 40");
  return scene;
}

/// Another view of it.
std::string second_scene() {
  std::string scene = tiny_scene();
  scene.replace(scene.find("width = 48"), 10, "width = 40");
  return scene;
}

}  // namespace

TEST_CASE("the design that a fit finds has the quality that a run of it has") {
  const TemporaryFolder folder;
  folder.write("one.toml", tiny_scene());
  folder.write("two.toml", second_scene());
  const Outcome fitted = bumpsim("fit one.toml two.toml --scheme peercy1997 --psnr 45 --json", folder.path());
  INFO(fitted.err);
  REQUIRE(fitted.code == 0);
  const Json fit = Json::parse(fitted.out);
  CHECK(fit["schema"] == "bumpsim-fit");
  CHECK(fit["scenes"].size() == 2);
  REQUIRE(fit["rows"].size() == 1);
  const Json& row = fit["rows"][0];
  CHECK(row["status"] == "reached");
  CHECK(row["search_complete"] == true);
  CHECK(row["choices"].size() == 2);
  CHECK(row["choices_kept"].size() == 2);

  std::string settings;
  for (const Json& width : row["chosen"]) {
    CHECK((width["bits"] >= width["least"] && width["bits"] <= width["most"]));
    settings += " --set " + width["key"].get<std::string>() + "=" + std::to_string(width["bits"].get<int>());
  }
  for (const Json& choice : row["choices"]) {
    CHECK(std::find(choice["values"].begin(), choice["values"].end(), choice["value"]) != choice["values"].end());
    settings += " --set " + choice["key"].get<std::string>() + "=" + choice["value"].get<std::string>();
  }
  double worst = 1e9;
  for (const Json& scene : row["scenes"]) {
    const std::string name = scene["name"];
    const Outcome run = bumpsim("run " + name + ".toml --json --scheme peercy1997 --out out_" + name + settings, folder.path());
    INFO(run.err);
    REQUIRE(run.code == 0);
    const Json result = Json::parse(run.out);
    CHECK(result["quality"]["against_reference"]["psnr_db"] == scene["psnr_hardware_to_reference_db"]);
    CHECK(result["quality"]["against_double"]["psnr_db"] == scene["psnr_hardware_to_double_db"]);
    worst = std::min(worst, scene["psnr_hardware_to_reference_db"].get<double>());
    int multipliers = 0;
    for (const char* unit : {"environment", "illumination"})
      for (const char* portion : {"built", "additional"}) multipliers += result["operators"][unit][portion]["multipliers"].get<int>();
    CHECK(row["multipliers"] == multipliers);
  }
  CHECK(worst >= 45);
  CHECK(row["psnr_worst_db"] == worst);
}

TEST_CASE("a structure that is searched costs no more than the given one, and one that is kept or set stays") {
  const TemporaryFolder folder;
  folder.write("one.toml", tiny_scene());
  const std::string command = "fit one.toml --scheme peercy1997 --psnr 40 --cost multipliers --designs 150 --json";
  const auto row_of = [&](const std::string& more) { return Json::parse(bumpsim(command + more, folder.path()).out)["rows"][0]; };
  const Json searched = row_of(""), kept = row_of(" --structure keep"), set = row_of(" --set peercy1997.transform=pixel");
  CHECK(searched["multipliers"] < kept["multipliers"]);
  CHECK(searched["structure"].get<std::string>().find("transform=vertex") != std::string::npos);
  CHECK(searched["variants_possible"] == 4);
  CHECK(kept["structure"] == "");
  CHECK(kept["choices_not_searched"].size() == 2);
  CHECK(kept["without_effect"] == Json{"peercy1997.root_table_bits"});
  CHECK(set["structure"].get<std::string>().find("transform") == std::string::npos);
  CHECK(set["set"] == Json{"peercy1997.transform"});
  CHECK(set["variants_possible"] == 2);
  CHECK(set["multipliers"] <= kept["multipliers"]);
}

TEST_CASE("a design whose words ended at their least is marked as an upper bound, and names them") {
  const TemporaryFolder folder;
  folder.write("one.toml", tiny_scene());
  const std::string command = "fit one.toml --scheme peercy1997 --structure keep --psnr ";
  const Json easy = Json::parse(bumpsim(command + "12 --json", folder.path()).out)["rows"][0];
  CHECK(easy["upper_bound"] == true);
  for (const Json& width : easy["chosen"]) {
    const bool named = easy["least_allowed"].get<std::string>().find(width["key"].get<std::string>()) != std::string::npos;
    if (named) CHECK(width["bits"] == width["least"]);
  }
  CHECK(bumpsim(command + "12", folder.path()).out.find("reached, upper bound") != std::string::npos);
}

TEST_CASE("a fit is the same for any number of jobs, and widths that are set stay") {
  const TemporaryFolder folder;
  folder.write("one.toml", tiny_scene());
  const std::string command =
      "fit one.toml --scheme lee2007,ernst1998 --against double --psnr 36 --designs 24 --set ernst1998.word_bits=11 --format ";
  for (const std::string format : {"text", "csv", "json"}) {
    const Outcome one = bumpsim(command + format + " --jobs 1", folder.path());
    INFO(one.err);
    REQUIRE(one.code == 0);
    CHECK(one.out == bumpsim(command + format + " --jobs 5", folder.path()).out);
    if (format == "text") CHECK(one.out.find("as set: word_bits") != std::string::npos);
    if (format != "json") continue;
    for (const Json& row : Json::parse(one.out)["rows"]) {
      CHECK(row["status"] == "reached");
      CHECK(row["scenes"][0]["psnr_hardware_to_double_db"] >= 36);
    }
  }
}

TEST_CASE("a quality that a scheme's formula does not have is a row that says so, and no error") {
  const TemporaryFolder folder;
  folder.write("one.toml", tiny_scene());
  const Outcome text = bumpsim("fit one.toml --scheme lee2007 --psnr 60", folder.path());
  INFO(text.err);
  CHECK(text.code == 0);
  CHECK(text.out.find("not reached. The best of") != std::string::npos);
  CHECK(text.out.find("The formula of the one shown has") != std::string::npos);
  const Json fit = Json::parse(bumpsim("fit one.toml --scheme lee2007 --psnr 60 --json", folder.path()).out);
  CHECK(fit["rows"][0]["status"] == "not_reached");
  CHECK(fit["rows"][0]["psnr_worst_db"] < 60);
  CHECK_FALSE(fit["rows"][0]["chosen"].empty());
}

TEST_CASE("prices name their table, and the cheapest area is not more than that of the fewest table bits") {
  const TemporaryFolder folder;
  folder.write("one.toml", tiny_scene());
  const std::string command = "fit one.toml --scheme exact_polar --structure keep --against double --psnr 30 --prices osu018_model --json";
  const Json area = Json::parse(bumpsim(command, folder.path()).out)["rows"][0];
  const Json bits = Json::parse(bumpsim(command + " --cost table_bits", folder.path()).out)["rows"][0];
  CHECK(area["cost"] == "area");
  CHECK(area["area_table"] == "osu018_model");
  CHECK(area["energy_table"].is_null());
  CHECK(area["area_nand2"] <= bits["area_nand2"]);
  CHECK(bits["table_bits"] <= area["table_bits"]);
}

TEST_CASE("a scheme that cannot be built is a row with its reason, and decides the exit code") {
  const TemporaryFolder folder;
  folder.write("one.toml", tiny_scene());
  const Outcome outcome =
      bumpsim("fit one.toml --scheme kim2001,phong1975 --psnr 15 --json --set kim2001.transform=direct --set kim2001.map_filter=vector",
              folder.path());
  INFO(outcome.err);
  CHECK(outcome.code == 2);
  CHECK(outcome.err.find("bumpsim: kim2001: ") != std::string::npos);
  const Json rows = Json::parse(outcome.out)["rows"];
  CHECK(rows[0]["status"] == "error");
  CHECK(rows[0]["reason"].get<std::string>().find("transform") != std::string::npos);
  CHECK(rows[0]["table_bits"].is_null());
  CHECK(rows[1]["status"] == "reached");
}

TEST_CASE("a price that is missing is named") {
  const TemporaryFolder folder;
  folder.write("one.toml", tiny_scene());
  folder.write("few.toml",
               "title = \"few\"\ntechnology = \"none\"\nsource = \"made up\"\n[area]\nunit = \"NAND2\"\naccuracy = \"none\"\n"
               "[area.adder]\nform = \"constant\"\nvalue = 1.0\nsource = \"made up\"\naccuracy = \"none\"\n");
  const Outcome outcome = bumpsim("fit one.toml --scheme peercy1997 --psnr 30 --prices few.toml", folder.path());
  CHECK(outcome.code == 2);
  CHECK(outcome.err.find("few") != std::string::npos);
  CHECK(outcome.err.find("multiplier") != std::string::npos);
}

TEST_CASE("the table of a fit goes straight into a front, in either format, with a plot") {
  const TemporaryFolder folder;
  folder.write("one.toml", tiny_scene());
  for (const std::string format : {"csv", "json"})
    REQUIRE(bumpsim("fit one.toml --scheme peercy1997,phong1975,lee2007,ernst1998 --psnr 40 --structure keep --designs 40 --format " +
                        format + " --out fit." + format,
                    folder.path())
                .code == 0);
  const Outcome csv = bumpsim("pareto fit.csv --x table_bits --y psnr --format csv --out plot.svg --log x", folder.path());
  INFO(csv.err);
  REQUIRE(csv.code == 0);
  CHECK(csv.out == bumpsim("pareto fit.json --x table_bits --y psnr --format csv", folder.path()).out);
  CHECK(csv.out.rfind("row,scheme,table_bits,psnr_worst_db,on_front", 0) == 0);
  const std::string svg = read_file(folder.path() / "plot.svg");
  CHECK(svg.rfind("<svg ", 0) == 0);
  CHECK(svg.find("table_bits (bits), low is better") != std::string::npos);
  const Outcome again = bumpsim("pareto fit.csv --x table_bits --y psnr --out plot.svg", folder.path());
  CHECK(again.code == 2);
  CHECK(again.err.find("--force") != std::string::npos);
  CHECK(bumpsim("pareto fit.csv --x table_bits --y psnr --out plot.svg --force", folder.path()).code == 0);
}

TEST_CASE("wrong use of fit and pareto is explained") {
  const TemporaryFolder folder;
  folder.write("one.toml", tiny_scene());
  folder.write("t.csv", "scheme,x,y\na,1,2\n");
  folder.write("broken.csv", "a,b\n1\n");
  struct Case {
    const char* arguments;
    const char* says;
  };
  const Case cases[] = {
      {"fit --psnr 40", "scenes"},
      {"fit one.toml", "--psnr"},
      {"fit one.toml --psnr 4000", "--psnr"},
      {"fit one.toml --psnr 40 --scheme lee2008", "lee2007"},
      {"fit one.toml one.toml --psnr 40", "two scenes are called 'one'"},
      {"fit nowhere.toml --psnr 40", "nowhere.toml"},
      {"fit one.toml --psnr 40 --cost area", "--prices"},
      {"fit one.toml --psnr 40 --cost price", "--cost"},
      {"fit one.toml --psnr 40 --prices osu018_modl", "osu018_model"},
      {"fit one.toml --psnr 40 --set numeric=double", "numeric"},
      {"fit one.toml --psnr 40 --set lee2007.word_bits=99", "allowed"},
      {"fit one.toml --psnr 40 --against truth", "--against"},
      {"fit one.toml --psnr 40 --designs 0", "--designs"},
      {"fit one.toml --psnr 40 --structure all", "--structure"},
      {"pareto t.csv --x x", "--y"},
      {"pareto t.csv --x x --y y --out plot.png", "--out cannot write .png files"},
      {"pareto t.csv --x x --y y --out plot.png", "try: --out plot.svg"},
      {"pareto t.csv --x x --y y --out plot", "has no suffix"},
      {"pareto t.csv --x x --y z", "the columns of numbers are: x, y"},
      {"pareto nothing --x x --y y", "nothing"},
      {"pareto broken.csv --x x --y y", "broken.csv:2"},
      {"pareto . --x x --y y", "points.csv"},
      {"pareto t.csv --x x --y y --where scheme=b", "no row is left"},
      {"pareto t.csv --x x --y y --log z", "--log"},
      {"pareto t.csv --x x --y y --x-better more", "--x-better"},
  };
  for (const Case& wrong : cases) {
    INFO(wrong.arguments);
    const Outcome outcome = bumpsim(wrong.arguments, folder.path());
    CHECK(outcome.code == 2);
    INFO(outcome.err);
    CHECK(outcome.err.find(wrong.says) != std::string::npos);
    CHECK(outcome.out.empty());
  }
}
