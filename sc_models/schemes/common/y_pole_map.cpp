#include "schemes/common/y_pole_map.h"

#include <cmath>

#include "schemes/common/inverse_tables.h"
#include "schemes/common/trigonometric_tables.h"

namespace bump {

namespace {

constexpr double two_pi = 6.283185307179586476925;
constexpr int guard_bits = 2;  // of products before they are summed
constexpr const char* turned_label = "texel turned by alpha";

/// N' along (e_theta, e_phi) from that along (T, B): T = e_phi turns them by a quarter.
glm::dvec2 along_axes(const glm::dvec3& normal, bool turned) {
  return turned ? glm::dvec2(-normal.y, normal.x) : glm::dvec2(normal.x, normal.y);
}

/// Of half a turn about 0.
Format texel_format(int bits) {
  return angle(bits, bits + 1);
}

Wire mirror_flag(Netlist& n) {
  const Netlist::Label label(n, "mirror flag");
  return n.is_negative("is_mirrored", n.input("mirror", turns(2)));
}

/// The angle where `flag` is clear, its negative where it is set.
Wire negated_if(Netlist& n, const std::string& name, Wire flag, Wire a, const Format& format) {
  const Netlist::Label label(n, "mirror flag");
  return n.select(name + "_unmirrored", flag, n.negate(name + "_mirrored", a, format), a, format);
}

TablePtr turn_table(const YPoleSettings& s, const TurnWidths& widths) {
  return sine_cosine_table("SC_TURN", s.input_angle(), widths.table_bits, widths.word_bits);
}

struct TurnedWires {
  Wire along_theta, along_phi;
};

/// (x, y) along (T, B) turned by alpha: 4 multipliers, 2 adders, 1 table.
TurnedWires turned_plane(Netlist& n, Wire x, Wire y, Wire alpha, const TablePtr& sine_cosine, const TurnWidths& widths) {
  const Format product = sfixed(widths.word_bits + 2 + guard_bits, widths.word_bits + guard_bits);
  const std::vector<Wire> turn = n.table("SC_ALPHA", sine_cosine, alpha);
  const Wire x_cos = n.mul("x_cos", x, turn[1], product), x_sin = n.mul("x_sin", x, turn[0], product);
  const Wire y_cos = n.mul("y_cos", y, turn[1], product), y_sin = n.mul("y_sin", y, turn[0], product);
  const Wire along_theta = n.sub("along_theta", x_cos, y_sin, product);
  return {along_theta, n.add("along_phi", x_sin, y_cos, product)};
}

/// N' of angles turned by alpha about z.
YPoleWires turned_texel(Netlist& n, const YPoleWires& texel, Wire alpha, const YPoleSettings& s, const TurnWidths& widths) {
  const Netlist::Scope scope(n, "turned");
  const Netlist::Label label(n, turned_label);
  const int w = widths.word_bits;
  const Format in = s.input_angle(), component = sfixed(w + 2, w + 1), sum = sfixed(w + 2, w), result = sfixed(w + 2, w + 1);
  const TablePtr sine_cosine = turn_table(s, widths);
  const std::vector<Wire> plus = n.table("SC_PLUS", sine_cosine, n.add("plus", texel.psi, texel.latitude, in));
  const std::vector<Wire> minus = n.table("SC_MINUS", sine_cosine, n.sub("minus", texel.psi, texel.latitude, in));
  const auto half_sum = [&](const std::string& name, Wire a, Wire b) {
    return n.shift(name, n.add("twice_" + name, a, b, sum), -1, component);
  };
  const Wire x = half_sum("x", plus[0], minus[0]), z = half_sum("z", plus[1], minus[1]);
  const Wire y = n.table("SIN_B", sine_table("SIN_TURN", in, widths.table_bits, w), texel.latitude).front();
  const TurnedWires turned = turned_plane(n, x, y, alpha, sine_cosine, widths);
  const auto clamped = [&](const std::string& name, Wire a) { return n.clamp(name, a, -1, 1, result); };
  const AzimuthFormats formats = azimuth_formats(w + 1, s.inverse_table_bits, w, turns(w + 2));
  const Wire psi = azimuth(n, "psi", clamped("sine", turned.along_theta), z, formats);
  const TablePtr arc_sine = arc_sine_table("ASIN_TURN", result, s.inverse_table_bits, angle(w + 1, w + 2));
  const Wire latitude = n.table("ASIN", arc_sine, clamped("latitude_sine", turned.along_phi)).front();
  return {n.shift("psi_word", psi, 0, in), n.shift("latitude_word", latitude, 0, in)};
}

}  // namespace

PolarSettings YPoleSettings::polar() const {
  PolarSettings p;
  p.angle_bits = angle_bits;
  p.inverse_table_bits = inverse_table_bits;
  p.angles = angles;
  p.frame = chart == Chart::parallel ? InPlane::parallel : chart == Chart::meridian ? InPlane::meridian : InPlane::pixel;
  p.mirror = mirror;
  return p;
}

void declare_y_pole_settings(Parameters& p, const std::string& id, TexelAs texel) {
  const YPoleSettings defaults;
  p.integer(id + ".angle_bits", defaults.angle_bits, 5, 16, "bits", "bits of a full turn in the interpolated angles");
  p.integer(id + ".inverse_table_bits", defaults.inverse_table_bits, 4, 14, "bits",
            "address bits of inverse functions: angles formed per pixel, a texel turned per pixel, and the scheme's own");
  if (texel == TexelAs::angles) {
    p.integer(id + ".texel_psi_bits", defaults.texel_psi_bits, 3, 14, "bits", "bits of the longitude in a bump texel, for half a turn");
    p.integer(id + ".texel_latitude_bits", defaults.texel_latitude_bits, 3, 14, "bits",
              "bits of the latitude in a bump texel, for half a turn");
  } else {
    p.integer(id + ".texel_bits", defaults.texel_bits, 3, 14, "bits", "bits of a component of a bump texel");
  }
  p.choice(id + ".map_filter", "linear", {"linear", "nearest"}, "bump texel: filtered channel by channel, or the nearest");
  p.choice(id + ".angles", "vertex", {"vertex", "pixel"},
           "polar angles: interpolated from the vertices, or formed per pixel from interpolated vectors");
  p.choice(
      id + ".frame", "parallel", {"parallel", "meridian", "pixel"},
      "where the tangent points: along parallels or meridians of the z axis, for which the map is made, or anywhere, for which a texel is "
      "turned per pixel");
  p.boolean(id + ".mirror", false, "carry one flag a triangle for mirrored texture charts, and mirror the texel where it is set");
}

YPoleSettings read_y_pole_settings(const Configuration& c, const std::string& id, TexelAs texel) {
  YPoleSettings s;
  s.texel = texel;
  s.angle_bits = static_cast<int>(c.integer(id + ".angle_bits"));
  s.inverse_table_bits = static_cast<int>(c.integer(id + ".inverse_table_bits"));
  if (texel == TexelAs::angles) {
    s.texel_psi_bits = static_cast<int>(c.integer(id + ".texel_psi_bits"));
    s.texel_latitude_bits = static_cast<int>(c.integer(id + ".texel_latitude_bits"));
  } else {
    s.texel_bits = static_cast<int>(c.integer(id + ".texel_bits"));
  }
  s.filtered = c.choice(id + ".map_filter") == "linear";
  s.angles = c.choice(id + ".angles") == "vertex" ? Angles::vertex : Angles::pixel;
  const std::string& frame = c.choice(id + ".frame");
  s.chart = frame == "parallel" ? Chart::parallel : frame == "meridian" ? Chart::meridian : Chart::any;
  s.mirror = c.boolean(id + ".mirror");
  return s;
}

BumpEncoding y_pole_map(const YPoleSettings& s) {
  BumpEncoding map;
  map.filterable = s.filtered;
  const bool turned = s.chart == Chart::parallel && s.texel != TexelAs::tangent_vector;
  if (s.texel != TexelAs::angles) {
    for (const char* component : {"x", "y", "minus_z"})
      map.channels.push_back({component, sfixed(s.texel_bits, s.texel_bits - 1), ChannelKind::linear});
    map.encode = [turned](const glm::dvec3& normal, double* channels) {
      const glm::dvec2 plane = along_axes(normal, turned);
      channels[0] = plane.x;
      channels[1] = plane.y;
      channels[2] = -normal.z;
    };
    map.note = s.filtered ? "a vector, filtered as any texture and not made unit again" : "nearest texel";
    return map;
  }
  map.channels = {{"psi", texel_format(s.texel_psi_bits), ChannelKind::linear},
                  {"latitude", texel_format(s.texel_latitude_bits), ChannelKind::linear}};
  map.encode = [turned](const glm::dvec3& normal, double* channels) {
    const glm::dvec2 plane = along_axes(normal, turned);
    channels[0] = plane.x == 0 && normal.z == 0 ? 0.0 : std::atan2(plane.x, normal.z) / two_pi;
    channels[1] = std::atan2(plane.y, std::hypot(plane.x, normal.z)) / two_pi;
  };
  map.note = s.filtered ? "longitude and latitude about the y axis, 0 on flat texels: they filter as they are" : "nearest texel";
  return map;
}

YPoleWires y_pole_texel(Netlist& n, const YPoleSettings& s, const TurnWidths& widths) {
  const Format in = s.input_angle();
  YPoleWires texel;
  texel.psi = n.input("map.psi", in);
  texel.latitude = n.input("map.latitude", in);
  n.begin_addition();
  if (s.mirror) {
    // B points the other way: n_B is -x where T = e_phi, else y.
    const Wire mirrored = mirror_flag(n);
    Wire& across = s.chart == Chart::parallel ? texel.psi : texel.latitude;
    across = negated_if(n, s.chart == Chart::parallel ? "psi" : "latitude", mirrored, across, in);
  }
  if (s.chart == Chart::any) texel = turned_texel(n, texel, n.input("alpha", in), s, widths);
  n.end_addition();
  return texel;
}

VectorTexelWires vector_texel(Netlist& n, const YPoleSettings& s, const TurnWidths& widths) {
  VectorTexelWires v;
  v.x = n.input("map.x", s.component());
  v.y = n.input("map.y", s.component());
  v.minus_z = n.input("map.minus_z", s.component());
  n.begin_addition();
  if (s.mirror) {
    const bool turned = s.chart == Chart::parallel && s.texel != TexelAs::tangent_vector;
    const Wire mirrored = mirror_flag(n);
    Wire& across = turned ? v.x : v.y;
    across = negated_if(n, turned ? "x" : "y", mirrored, across, s.component());
  }
  if (s.chart == Chart::any) {
    const Wire alpha = n.input("alpha", s.input_angle());
    const Netlist::Scope scope(n, "turned");
    const Netlist::Label label(n, turned_label);
    const TurnedWires turned = turned_plane(n, v.x, v.y, alpha, turn_table(s, widths), widths);
    v.x = turned.along_theta;
    v.y = turned.along_phi;
  }
  n.end_addition();
  return v;
}

}  // namespace bump
