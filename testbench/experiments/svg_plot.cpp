#include "testbench/experiments/svg_plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "testbench/experiments/svg_axis.h"
#include "testbench/experiments/svg_text.h"

namespace bump {

namespace {

constexpr double plot_width = 620, plot_height = 420, left = 86, top = 46, bottom = 58, gap = 20;
constexpr double character = 6.6, line_height = 18;  ///< of text of 12 px, roughly
constexpr std::size_t legend_entries = 22, many_points = 100;
/// Okabe and Ito's colours, without the yellow that white paper swallows, and two more: told apart by colour-blind readers too.
constexpr std::array<const char*, 9> colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9",
                                                "#e69f00", "#000000", "#7f3c8d", "#8c6d31"};
constexpr std::size_t markers = 4;

struct Box {
  double left, top, right, bottom;

  bool overlaps(const Box& other) const { return left < other.right && other.left < right && top < other.bottom && other.top < bottom; }
};

double text_width(const std::string& text) {
  return character * static_cast<double>(text.size());
}

class Drawing {
 public:
  explicit Drawing(const SvgPlot& plot)
      : plot_(plot),
        x_(values(0), plot.x.logarithmic, left, left + plot_width),
        y_(values(1), plot.y.logarithmic, top + plot_height, top) {}

  std::string text() {
    const double width = left + plot_width + gap + legend_width(), height = top + plot_height + bottom;
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\">\n",
        width, height);
    text_ += fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#ffffff\"/>\n", width, height);
    words(left + plot_width / 2, top - 20, "middle", plot_.title, " font-size=\"15\"");
    axes();
    line();
    for (const bool marked : {false, true}) points(marked);
    labels();
    legend();
    return text_ + "</svg>\n";
  }

 private:
  std::vector<double> values(std::size_t axis) const {
    std::vector<double> all;
    for (const SvgPlot::Point& point : plot_.points) all.push_back(axis == 0 ? point.x : point.y);
    return all;
  }
  bool has_legend() const { return plot_.series.size() > 1 || (plot_.series.size() == 1 && !plot_.series.front().empty()); }
  double legend_width() const {
    if (!has_legend()) return 0;
    double widest = 0;
    for (const std::string& name : plot_.series) widest = std::max(widest, text_width(name));
    return std::min(widest, 320.0) + 40;
  }

  void words(double x, double y, const char* anchor, const std::string& what, const std::string& attributes = "") {
    if (!what.empty())
      text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, attributes, xml_text(what));
  }
  void stroke(double x1, double y1, double x2, double y2, const char* colour) {
    text_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1, y1, x2, y2, colour);
  }

  void axes() {
    const double right = left + plot_width, low = top + plot_height;
    for (const double tick : x_.ticks()) {
      stroke(x_.position(tick), top, x_.position(tick), low + 4, "#dddddd");
      words(x_.position(tick), low + 18, "middle", tick_text(tick));
    }
    for (const double tick : y_.ticks()) {
      stroke(left - 4, y_.position(tick), right, y_.position(tick), "#dddddd");
      words(left - 8, y_.position(tick) + 4, "end", tick_text(tick));
    }
    text_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" stroke=\"#444444\"/>\n", left,
                         top, plot_width, plot_height);
    words(left + plot_width / 2, low + 42, "middle", plot_.x.title);
    const double middle = top + plot_height / 2;
    words(18, middle, "middle", plot_.y.title, fmt::format(" transform=\"rotate(-90 18 {:.1f})\"", middle));
  }

  void line() {
    if (plot_.line.size() < 2) return;
    text_ += "<polyline fill=\"none\" stroke=\"#888888\" stroke-dasharray=\"5 3\" points=\"";
    for (const auto& corner : plot_.line) text_ += fmt::format("{:.1f},{:.1f} ", x_.position(corner[0]), y_.position(corner[1]));
    text_.back() = '"';
    text_ += "/>\n";
  }

  /// A marker and colour of the series at a position of the paper.
  std::string marker(double x, double y, double size, std::size_t series) const {
    const std::size_t shape = series / colours.size() % markers;
    if (shape == 0) return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"", x, y, size);
    if (shape == 1)
      return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"", x - size, y - size, 2 * size, 2 * size);
    if (shape == 2)
      return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\"", x, y - size, x + size, y + size, x - size, y + size);
    return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\"", x, y - size, x + size, y, x, y + size,
                       x - size, y);
  }

  double plain_size() const { return plot_.points.size() > many_points ? 2.5 : 3.5; }

  /// Points that fall on one another are drawn once.
  void points(bool marked) {
    std::set<std::tuple<int, int, std::size_t>> drawn;
    for (const SvgPlot::Point& point : plot_.points) {
      if (point.marked != marked) continue;
      const double x = x_.position(point.x), y = y_.position(point.y);
      if (!drawn.insert({static_cast<int>(std::lround(2 * x)), static_cast<int>(std::lround(2 * y)), point.series}).second) continue;
      text_ += marker(x, y, marked ? 5 : plain_size(), point.series);
      text_ +=
          fmt::format(" fill=\"{}\"{}", colours[point.series % colours.size()], marked ? " stroke=\"#ffffff\"" : " fill-opacity=\"0.55\"");
      text_ += point.hint.empty() ? "/>\n" : fmt::format("><title>{}</title></{}>\n", xml_text(point.hint), element(point.series));
    }
  }
  static const char* element(std::size_t series) {
    constexpr std::array<const char*, markers> names = {"circle", "rect", "path", "path"};
    return names[series / colours.size() % markers];
  }

  /// Beside its point where nothing is in the way; else left to the legend.
  void labels() {
    std::vector<Box> taken;
    for (const SvgPlot::Point& point : plot_.points) {
      const double x = x_.position(point.x), y = y_.position(point.y);
      if (point.marked) taken.push_back({x - 5, y - 5, x + 5, y + 5});
    }
    for (const SvgPlot::Point& point : plot_.points) {
      if (!point.marked || point.label.empty()) continue;
      const double x = x_.position(point.x), y = y_.position(point.y), width = text_width(point.label);
      const std::array<Box, 4> places = {{{x + 8, y - 16, x + 8 + width, y - 3},
                                          {x - 8 - width, y - 16, x - 8, y - 3},
                                          {x + 8, y + 4, x + 8 + width, y + 17},
                                          {x - 8 - width, y + 4, x - 8, y + 17}}};
      for (const Box& place : places) {
        const bool inside = place.left > left && place.right < left + plot_width && place.top > top && place.bottom < top + plot_height;
        if (!inside || std::any_of(taken.begin(), taken.end(), [&](const Box& other) { return other.overlaps(place); })) continue;
        words(place.left, place.bottom - 3, "start", point.label);
        taken.push_back(place);
        break;
      }
    }
  }

  void legend() {
    if (!has_legend()) return;
    const double x = left + plot_width + gap + 6;
    double y = top + 10;
    for (std::size_t i = 0; i < plot_.series.size(); ++i, y += line_height) {
      if (i == legend_entries && plot_.series.size() > legend_entries + 1) {
        words(x + 12, y + 4, "start", fmt::format("and {} more", plot_.series.size() - i));
        return;
      }
      text_ += marker(x, y, 5, i) + fmt::format(" fill=\"{}\"/>\n", colours[i % colours.size()]);
      words(x + 12, y + 4, "start", plot_.series[i]);
    }
  }

  const SvgPlot& plot_;
  SvgAxis x_, y_;
  std::string text_;
};

}  // namespace

std::string svg_plot(const SvgPlot& plot) {
  return Drawing(plot).text();
}

}  // namespace bump
