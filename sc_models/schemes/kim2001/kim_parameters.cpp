#include "schemes/kim2001/kim_parameters.h"

#include "datapath/error.h"

namespace bump::kim2001 {

void declare_parameters(Parameters& p) {
  KimParameters defaults;
  defaults.angle_bits = 12;
  declare_polar_settings(p, "kim2001", defaults);
  p.choice("kim2001.transform", "matrix", {"matrix", "direct"},
           "matrix: L and H into the space of the map, as Table 1 of Lee 2007 charges (reconstruction); direct: changes of angle added to "
           "those of N in object space");
  p.choice("kim2001.tables", "separate", {"separate", "dual", "shared"},
           "tables of the illumination unit: sine and cosine apart as Table 1 of Lee 2007 counts (12), as one table (8), and those of the "
           "perturbed normal read once (7)");
  p.choice("kim2001.tangent", "phi", {"phi", "theta"},
           "transform = direct: the object's angle that grows along the map's x axis (phi: a map wrapped around the z axis)");
  p.integer("kim2001.table_bits", defaults.table_bits, 3, 12, "bits", "address bits of sine and cosine tables, for a quarter turn");
  p.integer("kim2001.inverse_table_bits", 10, 4, 14, "bits", "address bits of arc cosine and arc tangent tables");
  p.integer("kim2001.word_bits", defaults.word_bits, 4, 18, "bits", "bits of a table word and of a component of T, B, N");
  p.integer("kim2001.light_table_bits", defaults.light_table_bits, 3, 12, "bits", "address bits of the diffuse and specular tables");
  p.integer("kim2001.light_word_bits", 16, 4, 16, "bits", "bits of a word of the light tables, one before the point");
}

KimParameters read_parameters(const Configuration& c) {
  KimParameters p;
  read_polar_settings(c, "kim2001", p);
  p.frame = InPlane::none;  // T, B, N are the frame; and without a transform there is none
  p.transform = c.choice("kim2001.transform") == "matrix" ? Transform::matrix : Transform::direct;
  const std::string& tables = c.choice("kim2001.tables");
  p.tables = tables == "separate" ? Tables::separate : tables == "dual" ? Tables::dual : Tables::shared;
  p.tangent = c.choice("kim2001.tangent") == "phi" ? Tangent::phi : Tangent::theta;
  p.table_bits = static_cast<int>(c.integer("kim2001.table_bits"));
  p.inverse_table_bits = static_cast<int>(c.integer("kim2001.inverse_table_bits"));
  p.word_bits = static_cast<int>(c.integer("kim2001.word_bits"));
  p.light_table_bits = static_cast<int>(c.integer("kim2001.light_table_bits"));
  p.light_word_bits = static_cast<int>(c.integer("kim2001.light_word_bits"));
  if (p.transform == Transform::direct && p.map_filter == MapFilter::vector)
    throw Error(ErrorKind::input, {"kim2001.transform = direct does not go with kim2001.map_filter = vector",
                                   {},
                                   "the map then holds changes of angle, which filter as they are",
                                   "kim2001.map_filter=linear"});
  return p;
}

}  // namespace bump::kim2001
