#include <catch2/catch.hpp>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>

#include "testbench/experiments/pareto_formats.h"
#include "testbench/experiments/svg_axis.h"
#include "testbench/experiments/svg_plot.h"
#include "testbench/experiments/svg_text.h"

using namespace bump;

namespace {

/// What is wrong with it as XML without declarations; empty if nothing is.
std::string xml_fault(const std::string& text) {
  std::vector<std::string> open;
  std::size_t at = 0;
  const auto reference = [&](std::size_t from) {
    for (const char* name : {"&amp;", "&lt;", "&gt;", "&quot;"})
      if (text.compare(from, std::string(name).size(), name) == 0) return true;
    return false;
  };
  bool any = false;
  while (at < text.size()) {
    if (text[at] != '<') {
      if (text[at] == '&' && !reference(at)) return "bare &";
      if (text[at] == '>') return "bare >";
      if (open.empty() && std::isspace(static_cast<unsigned char>(text[at])) == 0) return "text outside";
      ++at;
      continue;
    }
    const bool closing = text[at + 1] == '/';
    at += closing ? 2 : 1;
    const std::size_t name_end = text.find_first_of(" />", at);
    const std::string name = text.substr(at, name_end - at);
    at = name_end;
    if (closing) {
      if (open.empty() || open.back() != name) return "closes " + name;
      open.pop_back();
      if (text[at++] != '>') return "end of " + name;
      continue;
    }
    if (open.empty() && any) return "two roots";
    any = true;
    std::set<std::string> names;
    while (text[at] == ' ') {
      const std::size_t equals = text.find('=', at);
      if (!names.insert(text.substr(at + 1, equals - at - 1)).second) return "attribute twice";
      if (text[equals + 1] != '"') return "attribute without quotes";
      const std::size_t end = text.find('"', equals + 2);
      if (end == std::string::npos) return "attribute without end";
      for (std::size_t i = equals + 2; i < end; ++i)
        if (text[i] == '<' || (text[i] == '&' && !reference(i))) return "bare mark in an attribute";
      at = end + 1;
    }
    if (text[at] == '/') {
      if (text[at + 1] != '>') return "end of " + name;
      at += 2;
    } else {
      if (text[at++] != '>') return "end of " + name;
      open.push_back(name);
    }
  }
  return open.empty() && any ? "" : "not closed";
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

SvgPlot sample() {
  SvgPlot plot;
  plot.title = "bits & <quality>";
  plot.x = {"table_bits (bits)", true};
  plot.y = {"psnr \"dB\"", false};
  for (int i = 0; i < 40; ++i) plot.series.push_back("scheme<" + std::to_string(i) + ">");
  for (int i = 0; i < 40; ++i) {
    const double x = 1000.0 * (i + 1), y = 20 + 30 * std::log10(i + 2.0);
    plot.points.push_back({x, y, static_cast<std::size_t>(i), i % 3 == 0, "scheme<" + std::to_string(i) + ">", "row & hint"});
    if (i % 3 == 0) plot.line.push_back({x, y});
  }
  plot.points.push_back({5000, std::numeric_limits<double>::infinity(), 1, true, "identical", ""});
  return plot;
}

}  // namespace

TEST_CASE("the checker of the tests knows what is well-formed") {
  CHECK(xml_fault("<a b=\"1\"><c/>x &amp; y</a>\n").empty());
  for (const char* wrong : {"<a>", "<a></b>", "<a b=1/>", "<a b=\"1\" b=\"2\"/>", "<a>&</a>", "<a/><b/>", "<a b=\"<\"/>", "x<a/>"}) {
    INFO(wrong);
    CHECK_FALSE(xml_fault(wrong).empty());
  }
}

TEST_CASE("a plot is well-formed SVG, with every series, whatever the names") {
  const SvgPlot plot = sample();
  const std::string svg = svg_plot(plot);
  CHECK(xml_fault(svg) == "");
  CHECK(svg == svg_plot(plot));
  CHECK(svg.find("bits &amp; &lt;quality&gt;") != std::string::npos);
  CHECK(svg.find("and 18 more") != std::string::npos);
  CHECK(count_of(svg, "<title>row &amp; hint</title>") == 40);
  CHECK(count_of(svg, "<polyline") == 1);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf\"") == std::string::npos);

  SvgPlot empty;
  CHECK(xml_fault(svg_plot(empty)) == "");
  empty.points.push_back({3, 4, 0, true, "", ""});
  empty.series = {""};
  CHECK(xml_fault(svg_plot(empty)) == "");
  CHECK(count_of(svg_plot(empty), "<circle") == 1);  // no legend
}

TEST_CASE("points stand where their values are, inside the frame, and coincident ones are drawn once") {
  SvgPlot plot;
  plot.series = {"a"};
  for (int i = 0; i < 5; ++i) plot.points.push_back({1, 1, 0, false, "", ""});
  plot.points.push_back({2, 2, 0, false, "", ""});
  CHECK(count_of(svg_plot(plot), "r=\"3.5\"") == 2);
  const SvgAxis right({10, 20, 30}, false, 100, 500), up({1, 1000}, true, 400, 50);
  CHECK(right.position(10) < right.position(20));
  CHECK(right.position(20) - right.position(10) == Approx(right.position(30) - right.position(20)));
  CHECK(up.position(10) - up.position(1) == Approx(up.position(100) - up.position(10)));
  CHECK(up.position(1000) < up.position(1));
  for (const double value : {10.0, 30.0, 1e9, -1e9, std::numeric_limits<double>::infinity()})
    CHECK((right.position(value) >= 100 && right.position(value) <= 500));
}

TEST_CASE("ticks are round, inside the range, and neither few nor many") {
  for (int power = -6; power < 9; ++power)
    for (const double from : {0.0, 1.0, 3.3, -2.0, 99.7})
      for (const double span : {0.013, 0.7, 1.0, 2.5, 9.0}) {
        const double low = from * std::pow(10.0, power), high = (from + span) * std::pow(10.0, power);
        for (const bool logarithmic : {false, true}) {
          if (logarithmic && low <= 0) continue;
          const SvgAxis axis({low, high}, logarithmic, 0, 1000);
          INFO(low << " to " << high << (logarithmic ? " logarithmic" : ""));
          CHECK(axis.ticks().size() >= 2);
          CHECK(axis.ticks().size() <= 12);
          for (const double tick : axis.ticks()) CHECK((axis.position(tick) > -1e-6 && axis.position(tick) < 1000 + 1e-6));
        }
      }
  CHECK(SvgAxis({100, 100000}, true, 0, 1).ticks() == std::vector<double>{100, 1000, 10000, 100000});
  CHECK(SvgAxis({5, 5}, false, 0, 1).ticks().size() >= 2);
  CHECK(SvgAxis({}, false, 0, 1).ticks().size() >= 2);
  CHECK(tick_text(12500) == "12,500");
  CHECK(tick_text(1234567) == "1,234,567");
  CHECK(tick_text(-1500.5) == "-1,500.5");
  CHECK(tick_text(0.1 + 0.2) == "0.3");
  CHECK(tick_text(100) == "100");
  CHECK(tick_text(0) == "0");
}

TEST_CASE("any bytes become text of XML") {
  CHECK(xml_text("a<b>&\"c\"") == "a&lt;b&gt;&amp;&quot;c&quot;");
  CHECK(xml_text("L\xC3\xA9on \xE2\x82\xAC") == "L\xC3\xA9on \xE2\x82\xAC");
  CHECK(xml_text("\xE9t\xE9 \xC0\x80 \xED\xA0\x80 \xF5") == "?t? ?? ??? ?");
  CHECK(xml_text(std::string("a\0b\x1f", 4)) == "a b ");
}

TEST_CASE("a front is drawn with its steps and its labels") {
  const ResultTable table =
      table_from_csv("scheme,status,area,psnr\nlee2007,ok,8,25\ncart,ok,6,40\nyp6,ok,4,20\nyp4,ok,9,50\n", "points.csv");
  ParetoOptions options;
  options.x.column = "area";
  options.y.column = "psnr";
  options.y.high_is_better = true;
  const std::string svg = pareto_svg(pareto_front(table, options), "");
  CHECK(xml_fault(svg) == "");
  CHECK(count_of(svg, ">cart</text>") == 2);  // at its point and in the legend
  CHECK(count_of(svg, ">lee2007</text>") == 1);
  const std::size_t begin = svg.find("points=\"") + 8;
  const std::string line = svg.substr(begin, svg.find('"', begin) - begin);
  CHECK(count_of(line, ",") == 5);  // three points and a corner between each two
}
