#pragma once
// The commands of the program, one function each; every one returns the process exit code or throws Error. Results go to stdout,
// progress and warnings to stderr.

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

struct ProbeArguments {
  std::string scheme, unit;
  std::vector<std::string> assignments;  ///< "name=value", angles in degrees
  std::vector<std::string> configuration_files;
  std::vector<std::string> settings;
  bool json = false;
};
int probe_command(const ProbeArguments& arguments);

}  // namespace bump
