#pragma once
// A scatter plot with a front as an SVG file: axes with ticks, a light grid, one colour and marker for each series, a legend, the marked
// points larger and labelled where there is room, and a line of steps along them. Nothing but SVG 1.1, no style sheet, no font of its own;
// the same bytes for the same plot. Pointing at a point shows its values. No model of hardware.

#include <array>
#include <string>
#include <vector>

namespace bump {

struct SvgPlot {
  struct Axis {
    std::string title;
    bool logarithmic = false;
  };
  struct Point {
    double x = 0, y = 0;     ///< infinite ones are drawn at the edge
    std::size_t series = 0;  ///< index into `series`
    bool marked = false;
    std::string label;  ///< of marked points
    std::string hint;   ///< what pointing at it shows
  };
  std::string title;
  Axis x, y;
  std::vector<std::string> series;  ///< names in the legend; a single empty one: no legend
  std::vector<Point> points;
  std::vector<std::array<double, 2>> line;  ///< corners of the line, x and y
};

std::string svg_plot(const SvgPlot& plot);

}  // namespace bump
