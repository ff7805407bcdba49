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
  bool force = false;                 ///< replace an earlier result or trace
  bool no_quality = false;            ///< skip the reference renderings
  bool json = false;
};
int run_command(const RunArguments& arguments);

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
