#pragma once
// The commands of the program, one function each; every one returns the process exit code or throws Error. Results go to stdout,
// progress and warnings to stderr.

#include <cstdint>
#include <string>
#include <vector>

namespace bump {

struct RunArguments {
  std::string scene;
  std::string scheme = "lee2007";
  std::string engine = "dated";
  std::vector<std::string> configuration_files;
  std::vector<std::string> settings;  ///< "key=value"
  std::string out;                    ///< empty: a new folder under out/
  std::string trace;                  ///< VCD path, stepped engine only
  std::string record;                 ///< file for a timing trace, for `retime`; empty: none
  bool addresses = false;             ///< the trace also holds what the fetch units read
  bool force = false;                 ///< replace an earlier result or trace
  int jobs = 0;                       ///< threads; 0: one per core
  bool no_quality = false;            ///< skip the reference renderings
  bool json = false;
};
int run_command(const RunArguments& arguments);

struct Table1Arguments {
  std::string format = "text";  ///< text, md, csv or json
  std::string out;              ///< file; empty: stdout
  std::vector<std::string> configuration_files;
  std::vector<std::string> settings;
  bool force = false;
  bool json = false;  ///< short for format json
};
int table1_command(const Table1Arguments& arguments);

struct Table2Arguments {
  std::string format = "text";
  std::string out;
  std::string pictures;  ///< folder for the compared images; empty: none
  std::vector<std::string> configuration_files;
  std::vector<std::string> settings;
  bool angles = false;  ///< also sweep the angle between light and viewer
  int jobs = 0;         ///< processes side by side; 0: one per core
  bool force = false;
  bool json = false;
};
int table2_command(const Table2Arguments& arguments);

struct CompareArguments {
  std::string scene;
  std::string schemes = "all";  ///< ids with commas between, or "all"
  std::string engine = "dated";
  std::string format = "text";
  std::string out;  ///< folder: compare.json, .txt, .md, .csv and .png; empty: only the table on stdout
  std::vector<std::string> configuration_files;
  std::vector<std::string> settings;
  int jobs = 0;
  bool force = false;
  bool json = false;
};
int compare_command(const CompareArguments& arguments);

struct PriceArguments {
  std::string schemes;              ///< ids with commas between, or "all"; empty: those of break_even, else all
  std::vector<std::string> prices;  ///< names or files; none: the shipped ones
  std::string scene;                ///< empty: every pixel netlist once, no memory traffic
  std::string break_even;           ///< two ids
  int real_bits = 0;                ///< width of interpolators and vertex work; 0: floating point
  std::string format = "text";      ///< text, md, csv or json
  std::string out;                  ///< file; empty: stdout
  std::vector<std::string> configuration_files;
  std::vector<std::string> settings;
  bool items = false;  ///< text and md: every component of every unit
  int jobs = 0;
  bool force = false;
  bool json = false;  ///< short for format json
};
int price_command(const PriceArguments& arguments);

struct RetimeArguments {
  std::string trace;
  std::vector<std::string> configuration_files;
  std::vector<std::string> settings;
  std::vector<std::string> sweeps;  ///< "key=a,b,c"; none: one configuration
  std::string format = "text";      ///< text, csv or json
  int jobs = 0;                     ///< threads; 0: one per core
  bool json = false;                ///< short for format json
};
int retime_command(const RetimeArguments& arguments);

struct SweepArguments {
  std::string spec;         ///< specification, a TOML file
  std::string out;          ///< folder: journal and tables
  std::string shard;        ///< "2/3"; empty: all
  std::string check = "3";  ///< points dated again that are run in full as well: a number, "5%" or "all"
  int jobs = 0;             ///< processes side by side; 0: one per core
  bool force = false;       ///< forget what the folder has
  bool json = false;
};
int sweep_command(const SweepArguments& arguments);

struct MergeArguments {
  std::vector<std::string> folders;  ///< of finished shards
  std::string out;
  bool force = false;
  bool json = false;
};
int merge_command(const MergeArguments& arguments);

struct FitArguments {
  std::vector<std::string> scenes;
  std::string schemes = "all";        ///< ids with commas between, or "all"
  double psnr_db = 0;                 ///< to reach on the worst scene
  std::string against = "reference";  ///< or "double"
  std::string cost;                   ///< multipliers, adders, table_bits, area or energy; empty: area or energy if priced, else table_bits
  std::vector<std::string> prices;    ///< names or files; none: unpriced
  std::string structure = "search";   ///< or "keep"
  int designs = 600;                  ///< measured at most, for each scheme
  std::string format = "text";        ///< text, md, csv or json
  std::string out;                    ///< file; empty: stdout
  std::vector<std::string> configuration_files;
  std::vector<std::string> settings;  ///< widths and choices among them are left as set
  int jobs = 0;
  bool force = false;
  bool json = false;  ///< short for format json
};
int fit_command(const FitArguments& arguments);

struct ParetoArguments {
  std::string table;  ///< folder of a sweep, or a file: CSV, JSON Lines, or a fit's JSON
  std::string x, y;   ///< columns
  std::string x_better = "low", y_better = "high";
  std::string log;                 ///< axes with a logarithmic scale: "", "x", "y", "xy"
  std::string label;               ///< column; empty: scheme, if there is one
  std::vector<std::string> where;  ///< "column=value": rows to keep
  std::string out;                 ///< SVG file; empty: none
  std::string title;
  std::string format = "text";  ///< text, md, csv or json
  bool force = false;
  bool json = false;  ///< short for format json
};
int pareto_command(const ParetoArguments& arguments);

struct ListArguments {
  std::string what;  ///< "schemes", "scenes", or empty for both
  bool json = false;
};
int list_command(const ListArguments& arguments);

struct DescribeArguments {
  std::string name;  ///< a scheme, a parameter, a module (prefix of parameters), "statistics", or empty for an overview
  bool json = false;
};
int describe_command(const DescribeArguments& arguments);

struct CheckArguments {
  std::string file;
  bool json = false;
};
int check_command(const CheckArguments& arguments);

struct LutsArguments {
  std::string out = "luts/rom";
  std::vector<std::string> configuration_files;
  std::vector<std::string> settings;
  bool json = false;
};
int luts_command(const LutsArguments& arguments);

struct RtlArguments {
  std::string scheme;
  std::string scene;               ///< whose material; empty: the default material
  std::vector<std::string> units;  ///< none: all datapath units
  std::string out;                 ///< folder
  int vectors = 1000;              ///< of each unit
  std::uint64_t seed = 1;
  std::vector<std::string> configuration_files;
  std::vector<std::string> settings;
  bool force = false;
  bool json = false;
};
int rtl_command(const RtlArguments& arguments);

struct ProbeArguments {
  std::string scheme, unit;
  std::vector<std::string> assignments;  ///< "name=value", angles in degrees
  std::vector<std::string> configuration_files;
  std::vector<std::string> settings;
  bool json = false;
};
int probe_command(const ProbeArguments& arguments);

}  // namespace bump
