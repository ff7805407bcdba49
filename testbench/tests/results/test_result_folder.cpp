#include <sys/resource.h>
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "datapath/error.h"
#include "sample_report.h"
#include "testbench/results/pending_folder.h"
#include "testbench/results/result_folder.h"

using namespace bump;
using bump::made_up::read;
using bump::made_up::Sample;
using bump::made_up::Workspace;
namespace fs = std::filesystem;

namespace {

const char* const files[] = {"result.json", "config.resolved.toml", "stats.csv", "frame.png", "frame.exr", "error.png"};

std::string message_of(const std::string& out, const RunReport& report, bool force = false) {
  try {
    write_result(out, report, force);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a result folder holds the six files and nothing is left beside it") {
  const Workspace work;
  const Sample sample;
  write_result(work / "runs/first", sample.report, false);
  for (const char* name : files) CHECK(fs::file_size(work / ("runs/first/" + std::string(name))) > 0);
  CHECK(std::distance(fs::directory_iterator(work / "runs/first"), fs::directory_iterator()) == 6);
  CHECK(std::distance(fs::directory_iterator(work / "runs"), fs::directory_iterator()) == 1);
}

TEST_CASE("without a reference there is no error image") {
  const Workspace work;
  Sample sample;
  sample.report.error_picture.reset();
  write_result(work / "out", sample.report, false);
  CHECK_FALSE(fs::exists(work / "out/error.png"));
}

TEST_CASE("the same run writes the same bytes, whatever the folder") {
  const Workspace work;
  const Sample first, second;
  write_result(work / "a", first.report, false);
  write_result(work / "elsewhere/b", second.report, false);
  for (const char* name : files) CHECK(read(work / ("a/" + std::string(name))) == read(work / ("elsewhere/b/" + std::string(name))));
}

TEST_CASE("an empty folder is filled, and a name may end in a slash") {
  const Workspace work;
  const Sample sample;
  fs::create_directory(work / "out");
  write_result(work / "out/", sample.report, false);
  CHECK(fs::exists(work / "out/result.json"));
  CHECK(work.names() == std::vector<std::string>{"out"});
}

TEST_CASE("an earlier result is replaced only when that is asked for") {
  const Workspace work;
  Sample sample;
  write_result(work / "out", sample.report, false);
  const std::string before = read(work / "out/result.json");
  sample.result.fragments = 123;
  CHECK_THAT(message_of(work / "out", sample.report), Catch::Contains("--force"));
  CHECK_THROWS_AS(check_output_folder(work / "out", false), Error);
  CHECK(read(work / "out/result.json") == before);
  check_output_folder(work / "out", true);
  write_result(work / "out", sample.report, true);
  CHECK(read(work / "out/result.json") != before);
  CHECK(work.names() == std::vector<std::string>{"out"});
}

TEST_CASE("a folder with anything else in it is never touched, not even by force") {
  const Workspace work;
  const Sample sample;
  const std::string content = GENERATE(as<std::string>{}, "", "{}", "{\"schema\": 3}", "not json");
  fs::create_directory(work / "mine");
  std::ofstream(work / "mine/notes.txt") << "keep";
  if (!content.empty()) std::ofstream(work / "mine/result.json") << content;
  CHECK_THAT(message_of(work / "mine", sample.report, true), Catch::Contains("not empty"));
  CHECK(read(work / "mine/notes.txt") == "keep");
  CHECK(work.names() == std::vector<std::string>{"mine"});
}

TEST_CASE("a result that something was added to is not replaced, and the addition is named") {
  const Workspace work;
  const Sample sample;
  write_result(work / "out", sample.report, false);
  const std::string before = read(work / "out/result.json");
  const std::string added = GENERATE(as<std::string>{}, "notes.txt", "frame.png", "old");
  if (added == "notes.txt") std::ofstream(work / "out/notes.txt") << "keep";
  if (added == "old") fs::create_directory(work / "out/old");
  if (added == "frame.png") {
    fs::remove(work / "out/frame.png");
    fs::create_symlink("elsewhere.png", work / "out/frame.png");
  }
  CHECK_THROWS_WITH(check_output_folder(work / "out", true), Catch::Contains("out/" + added));
  CHECK_THAT(message_of(work / "out", sample.report, true), Catch::Contains("out/" + added));
  CHECK(fs::exists(fs::symlink_status(work / ("out/" + added))));
  CHECK(read(work / "out/result.json") == before);
  CHECK(work.names() == std::vector<std::string>{"out"});
}

TEST_CASE("a symbolic link is followed to a folder and refused when it leads nowhere") {
  const Workspace work;
  const Sample sample;
  fs::create_symlink("target", work / "link");
  CHECK_THROWS_WITH(check_output_folder(work / "link", false), Catch::Contains("symbolic link to nothing"));
  CHECK_THROWS_WITH(check_output_folder(work / "link/below", false), Catch::Contains("is not a folder"));
  fs::create_directory(work / "target");
  write_result(work / "link", sample.report, false);
  CHECK(fs::exists(work / "target/result.json"));
  CHECK(fs::is_symlink(work / "link"));
}

TEST_CASE("a file in the way is an error, as the folder and as a parent of it") {
  const Workspace work;
  const Sample sample;
  std::ofstream(work / "file") << "x";
  CHECK_THAT(message_of(work / "file", sample.report, true), Catch::Contains("in the way"));
  CHECK_THAT(message_of(work / "file/out", sample.report, true), Catch::Contains("file"));
  CHECK(read(work / "file") == "x");
  CHECK(work.names() == std::vector<std::string>{"file"});
}

TEST_CASE("a place that cannot be written to is an error that says so") {
  const Sample sample;
  CHECK_THAT(message_of("/proc/bumpsim-result", sample.report),
             Catch::Contains("cannot create the output folder") && Catch::Contains("/proc"));
  CHECK_THAT(message_of("", sample.report), Catch::Contains("--out"));
}

TEST_CASE("a disk that fills up leaves nothing behind and keeps the earlier result") {
  const Workspace work;
  Sample sample(128);  // frame.exr is larger than any limit below
  write_result(work / "out", sample.report, false);
  const std::string before = read(work / "out/result.json");
  const rlim_t limit = GENERATE(rlim_t{10}, rlim_t{4096});

  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = old;
  small.rlim_cur = limit;  // what a full disk does, without one: a write that stops short, then fails
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string replacing = message_of(work / "out", sample.report, true), fresh = message_of(work / "new", sample.report);
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);

  CHECK_THAT(replacing, Catch::Contains("cannot write a result file") && Catch::Contains("File too large"));
  CHECK_THAT(fresh, Catch::Contains("cannot write a result file"));
  CHECK(read(work / "out/result.json") == before);
  CHECK(work.names() == std::vector<std::string>{"out"});
}

TEST_CASE("an exception in the middle of writing removes the partial folder") {
  const Workspace work;
  try {
    PendingFolder folder(work / "out", false);
    folder.write("stats.csv", "half");
    CHECK(fs::exists(folder.partial_path() + "/stats.csv"));
    throw std::runtime_error("stop");
  } catch (const std::runtime_error&) {
  }
  CHECK(work.names().empty());
}

TEST_CASE("a handler that ends the process removes the partial folder and keeps the earlier result") {
  const Workspace work;
  const Sample sample;
  const bool earlier = GENERATE(false, true);
  if (earlier) write_result(work / "out", sample.report, false);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGTERM, [](int) {
      remove_partial_result();
      _exit(42);
    });
    PendingFolder folder(work / "out", true);
    folder.write("stats.csv", "half");
    folder.write("frame.png", "half");
    raise(SIGTERM);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WEXITSTATUS(status) == 42);
  CHECK(work.names() == (earlier ? std::vector<std::string>{"out"} : std::vector<std::string>{}));
  if (earlier) CHECK(fs::exists(work / "out/result.json"));
}

TEST_CASE("a process killed without warning leaves only what is plainly not a result") {
  const Workspace work;
  const pid_t child = fork();
  if (child == 0) {
    PendingFolder folder(work / "out", false);
    folder.write("stats.csv", "half");
    raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status));
  CHECK(work.names() == std::vector<std::string>{"out.partial-" + std::to_string(child)});
  check_output_folder(work / "out", false);  // and the next run is free to write
}

TEST_CASE("without a write in progress the handler's clean-up does nothing") {
  const Workspace work;
  const Sample sample;
  write_result(work / "out", sample.report, false);
  remove_partial_result();
  for (const char* name : files) CHECK(fs::exists(work / ("out/" + std::string(name))));
}
