#pragma once
// Lee et al. 2007, "Table 1. The comparison of the architectures based on the hardware complexity", as printed, cell by cell, and the
// numbers that its text gives beside it. They are compared with what the netlists count and are never used for anything else. A cell lists
// what it names; an operator that a cell does not name is 0 here. Counts are per pixel and for one light. Bump-map and colour fetches are
// not counted as maps. Beside each number: what it says of which netlist, how the same words can be read otherwise, and what agreement with
// it is worth.

#include <array>
#include <string_view>

namespace bump::published {

struct OperatorCounts {
  int multipliers = 0, adders = 0, dividers = 0, square_roots = 0, tables = 0, maps = 0;
};

/// What it means if a netlist counts as printed.
enum class Agreement {
  exact,        ///< the netlist was written from the equations and counts so
  convention,   ///< it does if something is counted in one way and not in another that is as good
  construction  ///< the numbers do not determine a datapath, and the netlist was made to have them
};

/// Another reading of a cell: the netlist with these settings, for comparison with the same printed numbers.
struct Reading {
  std::string_view settings;  ///< "key=value", blanks between; empty: none
  std::string_view why;       ///< what is read otherwise
};

struct Table1Cell {
  std::string_view scheme;  ///< id of the scheme that models the column
  std::string_view column;  ///< heading of the column, with its reference
  std::string_view unit;    ///< "environment" or "illumination": the rows "Illumination Environment Setup" and "Illumination Calculation"
  bool available = true;    ///< false: the cell says "Not Available"
  OperatorCounts counts{};
  std::string_view source;  ///< where in the paper the numbers stand
  std::string_view remark;  ///< what to know when comparing; may be empty
  Agreement agreement = Agreement::exact;
  bool includes_colour_blending = false;  ///< the numbers include the multiplication by the texel's colour
  std::array<Reading, 2> readings{};
};

/// The design that the paper proposes.
inline constexpr std::string_view proposed = "lee2007";

inline constexpr std::array<Table1Cell, 10> table1{{
    {"peercy1997",
     "Peercy [8]",
     "environment",
     true,
     {27, 18, 9, 3, 0, 0},
     "Table 1, row 1, column 1; section 6",
     "charges to every pixel the two 3 x 3 transforms (18 multipliers, 12 adders) that Peercy does at vertices; the rest is three "
     "normalisations",
     Agreement::convention,
     false,
     {{{"peercy1997.transform=vertex", "as Peercy publishes it: L and H are transformed at the vertices"},
       {"peercy1997.normaliser=table", "reciprocal roots from a table in place of dividers and roots"}}}},
    {"peercy1997",
     "Peercy [8]",
     "illumination",
     false,
     {},
     "Table 1, row 2, column 1",
     "the cell says \"Not Available\"; finished here as the paper counts it for Ernst, so that totals can be compared"},
    {"kugler1998",
     "Kugler [13]",
     "environment",
     true,
     {5, 2, 0, 0, 3, 1},
     "Table 1, row 1, column 2; section 6",
     "two additions and one map access are the three rotations of section 2; the paper does not say what the five multipliers and three "
     "tables do; the conversion from Cartesian to spherical coordinates that has them is made up, and reads tables through second ports "
     "too",
     Agreement::construction},
    {"kugler1998",
     "Kugler [13]",
     "illumination",
     true,
     {8, 4, 0, 0, 5, 2},
     "Table 1, row 2, column 2; section 6",
     "section 6 gives all eight multipliers, four adders and five tables to the address of the light maps, without a datapath; the made-up "
     "address needs 4, 2 and 5, and the count closes only with what follows it, down to the colour blending that the section names as part "
     "of the stage and that no other column includes",
     Agreement::construction,
     true},
    {"kim2001",
     "Kim [9]",
     "environment",
     true,
     {31, 18, 0, 0, 6, 0},
     "Table 1, row 1, column 3; section 6",
     "no datapath is given and the counts do not determine one: three matrix products and 4 multipliers for two conversions is one split "
     "of "
     "several; the azimuths that Eqs 3-4 need have no room in it and are listed as additions",
     Agreement::construction,
     false,
     {{{"kim2001.transform=direct",
        "no transform: changes of angle added in object space, as Kim's claim of few arithmetic units suggests"}}}},
    {"kim2001",
     "Kim [9]",
     "illumination",
     true,
     {6, 5, 0, 0, 12, 0},
     "Table 1, row 2, column 3; sections 5.2 and 6",
     "sine and cosine by one index count as two tables here, but as one table in the column \"Ours\"",
     Agreement::convention,
     false,
     {{{"kim2001.tables=dual", "sine and cosine by one index are one table, as in the column \"Ours\""},
       {"kim2001.tables=shared", "and those of the perturbed normal are read once for both dot products"}}}},
    {"ernst1998",
     "Ernst [12]",
     "environment",
     true,
     {27, 18, 9, 3, 0, 0},
     "Table 1, row 1, column 4; section 6",
     "transform per pixel; the normaliser of (fu, fv, 1) counts in full, although the square of 1 needs no multiplier",
     Agreement::convention,
     false,
     {{{"ernst1998.variant=gouraud", "the low-end engine: a bump term blended onto Gouraud shading"}}}},
    {"ernst1998",
     "Ernst [12]",
     "illumination",
     true,
     {7, 5, 0, 0, 1, 0},
     "Table 1, row 2, column 4; section 6",
     "the table is a power table; closes if it includes the specular coefficient, so that one multiplier is left for the diffuse one",
     Agreement::convention,
     false,
     {{{"ernst1998.variant=gouraud", "the low-end engine: diffuse coefficient and sum"}}}},
    {"lee2007",
     "Ours",
     "environment",
     true,
     {6, 16, 0, 0, 12, 0},
     "Table 1, row 1, column 5; sections 5.1 and 6",
     "two vector rotation units of 3 multipliers, 8 adders and 6 tables (section 5.1); closes if sine and cosine by one index are one "
     "table, "
     "both reciprocals are one table, and signs, clamps and selects count nothing",
     Agreement::convention,
     false,
     {{{"lee2007.x_prime=exact lee2007.eq16=exact", "both approximations undone: what the same structure costs as a true rotation"}}}},
    {"lee2007",
     "Ours",
     "illumination",
     true,
     {2, 11, 0, 0, 8, 0},
     "Table 1, row 2, column 5; section 6",
     "section 5.2 says 13 adders/subtractors for the same unit; 11 are enough if a table holds cos^2(dp/2), an identity that the paper "
     "does "
     "not give",
     Agreement::construction,
     false,
     {{{"lee2007.form=13", "Eqs 24-25 as written: section 5.2 counts 13 adders, Table 1 counts 11"}}}},
}};

/// The cell of a scheme's unit, null if Table 1 has none.
inline constexpr const Table1Cell* table1_cell(std::string_view scheme, std::string_view unit) {
  for (const Table1Cell& cell : table1) {
    if (cell.scheme == scheme && cell.unit == unit) return &cell;
  }
  return nullptr;
}

/// Part of a unit's netlist: the nodes that lead to those whose names (or output ports) begin with one of `to`, all if empty, less the ones
/// that lead to `without`. Prefixes with blanks between.
struct Part {
  std::string_view scheme, unit, settings, to, without;
  bool without_light_tables = false;  ///< leave out tables that hold the material
};

/// Numbers of operators that the text gives for a part of a unit. -1: not said.
struct TextCount {
  std::string_view about;
  Part part;
  OperatorCounts counts;
  std::string_view source;
  std::string_view remark;
};

inline constexpr std::array<TextCount, 10> text_counts{{
    {"perturbation of the normal by Blinn's method",
     {"blinn1978", "environment", "", "N_bumped", ""},
     {20, 8, -1, -1, -1, -1},
     "section 6",
     "Eq 1 as written is 18 and 12; the paper gives no breakdown. 20 and 8 is 18 and a scale of Bu and Bv, and the six vector sums and two "
     "differences of heights without the six subtractions of the cross products"},
    {"transform of L and H, Peercy",
     {"peercy1997", "environment", "peercy1997.transform=pixel", "L_ts H_ts", ""},
     {18, 12, -1, -1, -1, -1},
     "section 6",
     "per pixel here, per vertex in Peercy's paper"},
    {"transform of L and H, Ernst",
     {"ernst1998", "environment", "ernst1998.variant=high_end", "L_ts H_ts", ""},
     {18, 12, -1, -1, -1, -1},
     "section 6",
     ""},
    {"normalisation, Peercy",
     {"peercy1997", "environment", "peercy1997.normaliser=divider", "", "L_ts H_ts"},
     {9, 6, 9, 3, -1, -1},
     "section 6",
     "the text speaks of two transformed vectors; the numbers are those of three normalisers, N' being the third"},
    {"normalisation, Ernst",
     {"ernst1998", "environment", "ernst1998.variant=high_end", "", "L_ts H_ts"},
     {9, 6, 9, 3, -1, -1},
     "section 6",
     "the text speaks of two transformed vectors; the numbers are those of three normalisers, N' being the third"},
    {"vector rotation unit, one vector", {"lee2007", "environment", "", "L_ref", ""}, {3, 8, -1, -1, 6, -1}, "section 5.1", ""},
    {"illumination calculation unit", {"lee2007", "illumination", "lee2007.form=13", "", ""}, {2, 13, -1, -1, -1, -1}, "section 5.2", ""},
    {"illumination of Kim in the text",
     {"kim2001", "illumination", "kim2001.tables=separate", "", ""},
     {6, 5, -1, -1, 12, -1},
     "section 5.2",
     ""},
    {"inner products, Eqs 22-23: multiplications, cosines",
     {"kim2001", "illumination", "kim2001.tables=separate", "", "", true},
     {6, -1, -1, -1, 10, -1},
     "section 4.2",
     "\"cosines\" are sines and cosines here, each a table"},
    {"inner products, Eqs 24-25: multiplications, cosines",
     {"lee2007", "illumination", "lee2007.form=13", "", "", true},
     {2, -1, -1, -1, 6, -1},
     "section 4.2",
     ""},
}};

/// What a size is the size of.
enum class Storage {
  tables,        ///< one ROM for every read
  distinct,      ///< every content of a netlist once
  light_tables,  ///< one of the tables that hold the material
  maps,          ///< tables with more than one index
  light_map,     ///< one of the maps that are filled every frame
  all            ///< tables, maps and light maps
};

struct TextSize {
  std::string_view about;
  Part part;  ///< `unit` empty: environment and illumination together
  Storage storage;
  double bytes;
  std::string_view quoted;  ///< as the source says it
  std::string_view source;
  std::string_view remark;
};

inline constexpr std::array<TextSize, 7> text_sizes{{
    {"tables of the environment setup",
     {"lee2007", "environment", "", "", ""},
     Storage::tables,
     8192,
     "8 Kbytes",
     "section 6",
     "closes with 256 words of 16 bits a column, eight columns a vector; the paper gives no shapes"},
    {"one light table, smallest",
     {"lee2007", "illumination", "lee2007.light_table_bits=8", "", ""},
     Storage::light_tables,
     512,
     "2^8 x 16 bits",
     "section 6",
     ""},
    {"one light table, largest",
     {"lee2007", "illumination", "lee2007.light_table_bits=10", "", ""},
     Storage::light_tables,
     2048,
     "2^10 x 16 bits",
     "section 6",
     ""},
    {"all memory",
     {"kim2001", "", "", "", ""},
     Storage::all,
     17152,
     "16.75 KB",
     "abstract of Kim et al. 2001",
     "Kim's tables are not described; derived are the reconstruction's, one ROM for every read, without a bump map. 16.75 KB would be 16 "
     "KB of "
     "bump map and three tables of 256 bytes"},
    {"perturbation map", {"kugler1998", "environment", "", "", ""}, Storage::maps, 32768, "32 Kbytes", "section 6", ""},
    {"one light map", {"kugler1998", "illumination", "", "", ""}, Storage::light_map, 1048576, "2^20 x 8 bits, 1 MB", "section 6", ""},
    {"all tables and maps",
     {"kugler1998", "", "", "", ""},
     Storage::all,
     3145728,
     "over 3 Mbytes",
     "section 2",
     "a lower bound; what is missing is not described and may be texture memory"},
}};

/// "The proposed architecture reduces up to maximum 78 % compared with the previous approaches", in multiplication operations.
struct ReductionClaim {
  int percent;
  std::string_view source;
};
inline constexpr ReductionClaim reduction_claim{78, "abstract and section 6"};

}  // namespace bump::published
