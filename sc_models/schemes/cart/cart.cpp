// CART as one Design: see README.md of this folder.

#include "datapath/error.h"
#include "schemes/cart/units.h"
#include "schemes/common/vertex_vectors.h"
#include "schemes/common/y_pole_vectors.h"

namespace bump::cart {

namespace {

constexpr double axis_limit = 1e-6;  // sine of theta_N below which phi_N comes from T

void record_vertex_program(const CartParameters& p, Design& design) {
  const VertexVectors v = record_vertex_vectors(design);
  interpolate_vector(design, "L", v.light);
  interpolate_vector(design, "H", v.half);
  if (p.normal == NormalFrom::matrix) {
    interpolate_vector(design, "N", v.normal);
    interpolate_vector(design, "T", v.tangent);
    interpolate_vector(design, "B", v.binormal);
    return;
  }
  const PolarWires normal =
      chart_angles(design.vertex, "N_polar", v.normal, v.tangent, p.polar().frame, vertex_polar_formats(), real(), axis_limit);
  design.vertex.output("N.phi", normal.phi);
  design.vertex.output("N.theta", normal.theta);
  for (const char* name : {"N.phi", "N.theta"}) design.interpolants.push_back({name, InterpolantKind::angle});
}

class Cart : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{
        "cart", "The map's normal rotated once, vectors throughout", "this project; in no paper", "this project's",
        "L and H stay vectors in the axes they are given in; the texel, a vector, is rotated out of the frame of N once for "
        "both dot products. Nothing is normalised. The fewest adders and tables of the exact designs."};
    return page;
  }

  void declare(Parameters& p) const override {
    p.choice("cart.normal", "angles", {"angles", "matrix"}, "frame of N: by its two angles, or T, B, N interpolated as vectors");
    p.choice("cart.frame", "parallel", {"parallel", "meridian"},
             "where the tangent points: along parallels or meridians of the z axis (normal = angles)");
    p.choice("cart.texel", "vector", {"vector", "angles"}, "bump texel: a vector, or longitude and latitude about y (normal = angles)");
    p.choice("cart.map_filter", "linear", {"linear", "nearest"}, "bump texel: filtered channel by channel, or the nearest");
    p.integer("cart.angle_bits", 12, 5, 16, "bits", "bits of a full turn in the interpolated angles of N");
    p.integer("cart.texel_bits", 8, 3, 14, "bits", "bits of a component of a bump texel, or of an angle for half a turn");
    p.integer("cart.table_bits", 10, 3, 12, "bits", "address bits of sine and cosine tables, for a quarter turn");
    p.integer("cart.word_bits", 12, 4, 18, "bits", "bits of a table word and of a vector component");
    p.integer("cart.light_table_bits", 10, 3, 12, "bits", "address bits of the diffuse and specular tables");
    p.integer("cart.light_word_bits", 16, 4, 16, "bits", "bits of a word of the diffuse and specular tables");
    p.integer("cart.ports", 1, 1, 2, "ports", "of a sine and cosine ROM: one index a cycle, or two, which halves the ROMs");
  }

  Design design(const Configuration& configuration, const Material& material) const override {
    const CartParameters p = read(configuration);
    Design design;
    record_vertex_program(p, design);
    design.environment = environment_unit(p);
    design.illumination = illumination_unit(p, material);
    design.map = y_pole_map(p);
    design.quantisation_floor_db = y_pole_floor_db(p, material);
    return design;
  }

 private:
  static CartParameters read(const Configuration& c) {
    const auto integer = [&](const char* key) { return static_cast<int>(c.integer(std::string("cart.") + key)); };
    CartParameters p;
    p.normal = c.choice("cart.normal") == "angles" ? NormalFrom::angles : NormalFrom::matrix;
    const bool angles = c.choice("cart.texel") == "angles";
    if (angles && p.normal == NormalFrom::matrix)
      throw Error(ErrorKind::input, {"cart.texel=angles contradicts cart.normal=matrix",
                                     {},
                                     "a matrix turns vectors, and the map would hold angles",
                                     "cart.texel=vector, or cart.normal=angles"});
    p.texel = angles ? TexelAs::angles : p.normal == NormalFrom::angles ? TexelAs::vector : TexelAs::tangent_vector;
    p.chart = c.choice("cart.frame") == "parallel" ? Chart::parallel : Chart::meridian;
    p.filtered = c.choice("cart.map_filter") == "linear";
    p.angle_bits = integer("angle_bits");
    p.texel_bits = p.texel_psi_bits = p.texel_latitude_bits = integer("texel_bits");
    p.table_bits = integer("table_bits");
    p.word_bits = integer("word_bits");
    p.light_table_bits = integer("light_table_bits");
    p.light_word_bits = integer("light_word_bits");
    p.ports = integer("ports");
    return p;
  }
};

BUMP_REGISTER_SCHEME(Cart);

}  // namespace

}  // namespace bump::cart
