#pragma once
// Lee et al. 2007, "Table 1. The comparison of the architectures based on the hardware complexity", as printed, cell by cell. These numbers
// are compared with what the netlists count and are never used for anything else. A cell lists what it names; an operator that a cell does
// not name is 0 here. Counts are per pixel and for one light. Bump-map and colour fetches are not counted as maps.
// Where the paper's own text disagrees with its table, the text is quoted beside the cell.

#include <array>
#include <string_view>

namespace bump::published {

struct OperatorCounts {
  int multipliers = 0, adders = 0, dividers = 0, square_roots = 0, tables = 0, maps = 0;
};

struct Table1Cell {
  std::string_view scheme;  ///< id of the scheme that models the column
  std::string_view column;  ///< heading of the column, with its reference
  std::string_view unit;    ///< "environment" or "illumination": the rows "Illumination Environment Setup" and "Illumination Calculation"
  bool available = true;    ///< false: the cell says "Not Available"
  OperatorCounts counts{};
  std::string_view source;  ///< where in the paper the numbers stand
  std::string_view remark;  ///< what to know when comparing; may be empty
};

inline constexpr std::array<Table1Cell, 10> table1{{
    {"peercy1997",
     "Peercy [8]",
     "environment",
     true,
     {27, 18, 9, 3, 0, 0},
     "Table 1, row 1, column 1; section 6",
     "charges to every pixel the two 3 x 3 transforms (18 multipliers, 12 adders) that Peercy does at vertices; the rest is three "
     "normalisations"},
    {"peercy1997", "Peercy [8]", "illumination", false, {}, "Table 1, row 2, column 1", "the cell says \"Not Available\""},
    {"kugler1998", "Kugler [13]", "environment", true, {5, 2, 0, 0, 3, 1}, "Table 1, row 1, column 2; section 6", "the map has 32 Kbytes"},
    {"kugler1998",
     "Kugler [13]",
     "illumination",
     true,
     {8, 4, 0, 0, 5, 2},
     "Table 1, row 2, column 2; section 6",
     "the two maps are light maps of 1 Mbyte; includes colour blending"},
    {"kim2001",
     "Kim [9]",
     "environment",
     true,
     {31, 18, 0, 0, 6, 0},
     "Table 1, row 1, column 3; section 6",
     "no datapath is given; the counts do not determine one"},
    {"kim2001",
     "Kim [9]",
     "illumination",
     true,
     {6, 5, 0, 0, 12, 0},
     "Table 1, row 2, column 3; sections 5.2 and 6",
     "sine and cosine count as separate tables here, but as one table in the column \"Ours\""},
    {"ernst1998", "Ernst [12]", "environment", true, {27, 18, 9, 3, 0, 0}, "Table 1, row 1, column 4; section 6", ""},
    {"ernst1998",
     "Ernst [12]",
     "illumination",
     true,
     {7, 5, 0, 0, 1, 0},
     "Table 1, row 2, column 4; section 6",
     "the table is a power table"},
    {"lee2007",
     "Ours",
     "environment",
     true,
     {6, 16, 0, 0, 12, 0},
     "Table 1, row 1, column 5; sections 5.1 and 6",
     "two vector rotation units of 3 multipliers, 8 adders and 6 tables (section 5.1)"},
    {"lee2007",
     "Ours",
     "illumination",
     true,
     {2, 11, 0, 0, 8, 0},
     "Table 1, row 2, column 5; section 6",
     "section 5.2 says 13 adders/subtractors for the same unit"},
}};

/// Numbers that the text gives beside the table.
struct TextClaim {
  std::string_view about;
  std::string_view value;
  std::string_view source;
};

inline constexpr std::array<TextClaim, 8> text_claims{{
    {"lee2007 vector rotation unit, one vector", "6 tables, 3 multipliers, 8 adders/subtractors", "section 5.1"},
    {"lee2007 illumination unit", "tables, among them 1 diffuse and 1 specular table, 2 multipliers, 13 adders/subtractors", "section 5.2"},
    {"lee2007 tables of the environment setup, total", "8 Kbytes", "section 6"},
    {"lee2007 light tables, each", "2^8 x 16 to 2^10 x 16 bits", "section 6"},
    {"kugler1998 light maps, each", "at least 2^20 x 8 bits (1 MB)", "section 6"},
    {"kugler1998 perturbation map", "32 Kbytes", "section 6"},
    {"Blinn's perturbation of the normal", "20 multiplications, 8 additions", "section 6"},
    {"reduction of multiplications against earlier approaches", "up to 78 %", "abstract and section 6"},
}};

/// The cell of a scheme's unit, null if Table 1 has none.
inline constexpr const Table1Cell* table1_cell(std::string_view scheme, std::string_view unit) {
  for (const Table1Cell& cell : table1) {
    if (cell.scheme == scheme && cell.unit == unit) return &cell;
  }
  return nullptr;
}

}  // namespace bump::published
