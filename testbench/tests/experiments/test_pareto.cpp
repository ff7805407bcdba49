#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "datapath/error.h"
#include "testbench/experiments/pareto.h"
#include "testbench/experiments/pareto_formats.h"

using namespace bump;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool beats(const ParetoPoint& a, const ParetoPoint& b, bool high_x, bool high_y) {
  const auto at_least = [](double one, double other, bool high) { return high ? one >= other : one <= other; };
  return at_least(a.x, b.x, high_x) && at_least(a.y, b.y, high_y) && (a.x != b.x || a.y != b.y);
}

ResultTable sample() {
  return table_from_csv(
      "point,id,scene,scheme,depth,status,cycles,built_multipliers,psnr_worst_db,psnr_hardware_to_double_db,reason\n"
      "0,aa,earth,lee2007,1,ok,100,8,25.5,40,\n"
      "1,bb,earth,cart,1,ok,90,6,40,41,\n"
      "2,cc,earth,cart,2,ok,80,6,40,41,\n"
      "3,dd,earth,yp6,1,deadlock,,,,,stuck\n"
      "4,ee,torus,yp6,1,ok,70,10,inf,42,\n"
      "5,ff,torus,yp6,2,ok,60,12,,42,\n",
      "points.csv");
}

ParetoOptions options(const std::string& x, const std::string& y) {
  ParetoOptions options;
  options.x.column = x;
  options.y.column = y;
  options.y.high_is_better = true;
  return options;
}

std::string message(const ParetoOptions& options) {
  try {
    pareto_front(sample(), options);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the front is what trying all pairs says, ties included, whichever ends are better") {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    std::vector<ParetoPoint> points(1 + random() % 60);
    const int range = 2 + static_cast<int>(random() % 30);  // few values: many ties
    for (ParetoPoint& point : points) {
      point.x = static_cast<int>(random() % 1000) % range;
      point.y = random() % 20 == 0 ? infinity : static_cast<int>(random() % 1000) % range;
    }
    const bool high_x = random() % 2 == 0, high_y = random() % 2 == 0;
    mark_front(points, high_x, high_y);
    for (const ParetoPoint& point : points) {
      bool beaten = false;
      for (const ParetoPoint& other : points) beaten = beaten || beats(other, point, high_x, high_y);
      REQUIRE(point.on_front == !beaten);
    }
  }
}

TEST_CASE("failed rows and rows without numbers are left out and counted") {
  const ParetoFront front = pareto_front(sample(), options("multipliers", "psnr"));
  CHECK(front.x.column == "built_multipliers");
  CHECK(front.y.column == "psnr_worst_db");
  CHECK(front.label == "scheme");
  CHECK(front.rows == 6);
  CHECK(front.failed == 1);
  CHECK(front.without_value == 1);
  REQUIRE(front.points.size() == 4);
  CHECK(front.identity == std::vector<std::string>{"scene", "depth"});
  const auto marked = front.front();
  REQUIRE(marked.size() == 3);  // two rows of cart are equal
  CHECK(marked[0]->row == 1);
  CHECK(marked[1]->row == 2);
  CHECK(marked[1]->identity == std::vector<std::string>{"earth", "2"});
  CHECK(marked[2]->y == infinity);

  ParetoOptions some = options("cycles", "psnr_worst_db");
  some.where = {"scene=earth", "depth=1.0"};
  const ParetoFront few = pareto_front(sample(), some);
  CHECK(few.filtered == 3);
  CHECK(few.failed == 1);
  CHECK(few.points.size() == 2);
  CHECK(few.identity.empty());
}

TEST_CASE("designs that do not have the quality of a fit are not on its front") {
  const ResultTable table =
      table_from_csv("scheme,status,area,table_bits\na,reached,10,5\nb,not_reached,1,1\nc,reached,9,6\nd,reached,11,7\n", "fit.csv");
  ParetoOptions costs = options("area", "table_bits");
  costs.y.high_is_better = false;
  const ParetoFront front = pareto_front(table, costs);
  CHECK(front.not_reached == 1);
  CHECK(front.failed == 0);
  REQUIRE(front.front().size() == 2);
  CHECK(front.front()[0]->label == "c");
  CHECK(front.front()[1]->label == "a");
  CHECK(pareto_document(front, false).find("1 that did not reach the quality") != std::string::npos);
}

TEST_CASE("wrong columns and conditions are explained") {
  CHECK(message(options("cycle", "psnr")).empty());
  CHECK(message(options("area", "psnr")).find("the columns of numbers are: point, depth, cycles") != std::string::npos);
  CHECK(message(options("cyclse", "psnr")).find("try: --x cycles") != std::string::npos);
  CHECK(message(options("scheme", "psnr")).find("holds no numbers") != std::string::npos);
  CHECK(message(options("cycles", "_db")).find("may mean 2 columns") != std::string::npos);
  ParetoOptions wrong = options("cycles", "psnr");
  wrong.label = "shceme";
  CHECK(message(wrong).find("--label with scheme") != std::string::npos);
  wrong = options("cycles", "psnr");
  wrong.where = {"scene"};
  CHECK(message(wrong).find("is no condition") != std::string::npos);
  wrong.where = {"scena=earth"};
  CHECK(message(wrong).find("--where with scene") != std::string::npos);
  wrong.where = {"scene=moon"};
  CHECK(message(wrong).find("6 do not meet --where") != std::string::npos);
  wrong = options("point", "psnr");
  wrong.x.logarithmic = true;
  CHECK(message(wrong).find("logarithmic") != std::string::npos);
}

TEST_CASE("all formats tell the same front") {
  const ParetoFront front = pareto_front(sample(), options("multipliers", "psnr"));
  const auto json = nlohmann::json::parse(pareto_json(front));
  CHECK(json["schema"] == pareto_schema);
  CHECK(json["left_out"]["failed"] == 1);
  CHECK(json["points"].size() == 4);
  const ResultTable csv = table_from_csv(pareto_csv(front), "front.csv");
  REQUIRE(csv.rows.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(json["points"][i]["on_front"] == front.points[i].on_front);
    CHECK(csv.rows[i][*csv.find("on_front")] == (front.points[i].on_front ? "true" : "false"));
    CHECK(*csv.number(i, *csv.find("built_multipliers")) == front.points[i].x);
  }
  CHECK(json["points"][3]["y"] == "inf");
  for (const bool markdown : {false, true}) {
    const std::string text = pareto_document(front, markdown);
    CHECK(text.find("3 of 4 points") != std::string::npos);
    CHECK(text.find("of 6 rows left out: 1 that failed, 1 without a number") != std::string::npos);
    CHECK(text.find("cart") != std::string::npos);
    CHECK(text.find("lee2007") == std::string::npos);
  }
  CHECK(axis_title({"area_nand2"}) == "area_nand2 (NAND2 equivalents), low is better");
  CHECK(axis_title({"psnr_db.world_sphere", true}) == "psnr_db.world_sphere (dB), high is better");
  CHECK(axis_title({"built_adders"}) == "built_adders, low is better");
}
