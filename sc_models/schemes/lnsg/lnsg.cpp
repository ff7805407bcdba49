// LNSG as one Design: see README.md of this folder.

#include "schemes/common/light_tables.h"
#include "schemes/common/log_error.h"
#include "schemes/common/polar_error.h"
#include "schemes/common/polar_map.h"
#include "schemes/common/polar_vectors.h"
#include "schemes/lnsg/units.h"
#include "schemes/scheme.h"

namespace bump::lnsg {

namespace {

LnsgParameters read(const Configuration& c) {
  LnsgParameters p;
  read_polar_settings(c, "lnsg", p);
  read_in_plane_settings(c, "lnsg", p);
  const auto bits = [&](const char* key) { return static_cast<int>(c.integer(std::string("lnsg.") + key)); };
  p.table_bits = bits("table_bits");
  p.word_bits = bits("word_bits");
  p.log_bits = bits("log_bits");
  p.log_whole_bits = bits("log_whole_bits");
  p.antilog_table_bits = bits("antilog_table_bits");
  p.inverse_table_bits = bits("inverse_table_bits");
  p.light_table_bits = bits("light_table_bits");
  p.light_word_bits = bits("light_word_bits");
  p.ports = bits("ports");
  return p;
}

class Lnsg : public Scheme {
 public:
  const SchemePage& page() const override {
    static const SchemePage page{"lnsg", "Exact dot products of angles in logarithms for any tangent frame, no multiplier",
                                 "this project; in no paper", "this project's",
                                 "LNS with the map's pole on z, where the angle of the tangent is one addition: general meshes need no map "
                                 "of their own. Five products "
                                 "a vector, each a sum of logarithms brought back by a table and a barrel shifter."};
    return page;
  }

  void declare(Parameters& p) const override {
    LnsgParameters defaults;
    defaults.angle_bits = 12;
    declare_polar_settings(p, "lnsg", defaults);
    declare_in_plane_settings(p, "lnsg");
    p.integer("lnsg.table_bits", defaults.table_bits, 3, 12, "bits", "address bits of logarithms of sine and cosine, for a quarter turn");
    p.integer("lnsg.word_bits", defaults.word_bits, 4, 18, "bits", "bits of an antilogarithm");
    p.integer("lnsg.log_bits", defaults.log_bits, 4, 18, "bits", "fraction bits of a logarithm");
    declare_log_whole_bits(p, "lnsg");
    p.integer("lnsg.antilog_table_bits", defaults.antilog_table_bits, 3, 14, "bits", "address bits of the antilogarithm's table");
    p.integer("lnsg.inverse_table_bits", 10, 4, 14, "bits", "address bits of arc tangents: angles formed per pixel");
    p.integer("lnsg.light_table_bits", defaults.light_table_bits, 3, 12, "bits", "address bits of the diffuse and specular tables");
    p.integer("lnsg.light_word_bits", defaults.light_word_bits, 6, 16, "bits", "bits of a word of the diffuse and specular tables");
    p.integer("lnsg.ports", defaults.ports, 1, 2, "ports",
              "of a ROM of logarithms: one index a cycle, or two, which halves the ROMs and changes no result");
  }

  Design design(const Configuration& configuration, const Material& material) const override {
    const LnsgParameters p = read(configuration);
    Design design;
    record_polar_vectors(p, NormalAs::angles, design);
    design.environment = environment_unit(p);
    design.illumination = illumination_unit(p, material);
    design.map = polar_map(p);
    const double angles =
        light_word_floor_db(polar_floor_db(p, {p.table_bits, p.word_bits, 0, p.light_table_bits}, material), p.light_word_bits);
    design.quantisation_floor_db = logarithmic_floor_db(angles, p.logs(), 5, 5, material);
    return design;
  }
};

BUMP_REGISTER_SCHEME(Lnsg);

}  // namespace

}  // namespace bump::lnsg
