#pragma once
// Lee et al. 2007, "Table 2. The comparison of image quality by MSE-based measures", as printed: the proposed method's images against those
// of the method that the row names. Only ever compared with. The paper gives neither formulas (it refers to Al-Otum), light, camera nor
// material, so magnitudes can be compared and single values cannot. Its text says that NMSE and PMSE are below 0.01; 12 of the 18 NMSE
// values are not. RNMSE and RPMSE are the square roots of the other two, to rounding, and therefore no further evidence.

#include <array>
#include <string_view>

namespace bump::published {

struct Table2Row {
  std::string_view scene;      ///< "plane" (wooden wall), "cube" (brick wall), "sphere" (map of the world, 512 x 256 texels)
  std::string_view reference;  ///< "conventional": Cartesian, object space, Blinn's perturbation; "kim": Kim's polar coordinates
  std::array<double, 3> nmse, rnmse, pmse, rpmse;  ///< red, green, blue
  std::string_view source;
};

inline constexpr std::array<Table2Row, 6> table2{{
    {"plane",
     "conventional",
     {0.0126, 0.0072, 0.0068},
     {0.1124, 0.0848, 0.0827},
     {0.0001, 0.0004, 0.0013},
     {0.0110, 0.0204, 0.0361},
     "Table 2, rows \"Conventional Method\", plane"},
    {"cube",
     "conventional",
     {0.0122, 0.0106, 0.0080},
     {0.1105, 0.1029, 0.0894},
     {0.0004, 0.0001, 0.0003},
     {0.0210, 0.0117, 0.0184},
     "Table 2, rows \"Conventional Method\", cube"},
    {"sphere",
     "conventional",
     {0.0168, 0.0137, 0.0170},
     {0.1295, 0.1169, 0.1305},
     {0.0021, 0.0008, 0.0008},
     {0.0456, 0.0285, 0.0277},
     "Table 2, rows \"Conventional Method\", sphere"},
    {"plane",
     "kim",
     {0.0111, 0.0064, 0.0065},
     {0.1055, 0.0800, 0.0808},
     {0.0001, 0.0003, 0.0011},
     {0.0110, 0.0185, 0.0336},
     "Table 2, rows \"Polar Coord. Method (Kim)\", plane"},
    {"cube",
     "kim",
     {0.0112, 0.0101, 0.0073},
     {0.1059, 0.1007, 0.0854},
     {0.0002, 0.0001, 0.0003},
     {0.0156, 0.0117, 0.0165},
     "Table 2, rows \"Polar Coord. Method (Kim)\", cube"},
    {"sphere",
     "kim",
     {0.0147, 0.0111, 0.0157},
     {0.1212, 0.1052, 0.1253},
     {0.0019, 0.0011, 0.0007},
     {0.0438, 0.0329, 0.0273},
     "Table 2, rows \"Polar Coord. Method (Kim)\", sphere"},
}};

/// The row of a scene and a reference, null if Table 2 has none.
inline constexpr const Table2Row* table2_row(std::string_view scene, std::string_view reference) {
  for (const Table2Row& row : table2) {
    if (row.scene == scene && row.reference == reference) return &row;
  }
  return nullptr;
}

}  // namespace bump::published
