#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <new>
#include <stdexcept>
#include <thread>

#include "testbench/experiments/child_processes.h"

namespace bump {

namespace {

ChildTask task_of(const std::string& name, const std::function<std::string()>& work) {
  return {name, [work](const ReportShare&) { return work(); }};
}

std::vector<ChildOutcome> run(const std::vector<ChildTask>& tasks, int jobs = 2) {
  ChildOptions options;
  options.jobs = jobs;
  return run_in_children(tasks, options);
}

bool has_children() {
  return !(::waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD);
}

/// Runs the work in one child and returns the error that it ends with.
Error failure(const std::function<std::string()>& work) {
  const auto outcomes = run({task_of("the task", work)});
  REQUIRE(outcomes.size() == 1);
  REQUIRE(outcomes[0].error.has_value());
  CHECK(outcomes[0].bytes.empty());
  return *outcomes[0].error;
}

/// Bytes of every value, zeros included, of a length that depends on the task.
std::string long_text(std::size_t task) {
  std::string text(task * 999983, '\0');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>((i * (task + 7) + i / 251) & 255);
  return text;
}

}  // namespace

TEST_CASE("children hand back bytes of any length, in the order of the tasks, with any number of jobs") {
  std::vector<ChildTask> tasks;
  for (std::size_t i = 0; i < 23; ++i) {
    tasks.push_back(task_of("task " + std::to_string(i), [i] {
      if (i % 5 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
      if (i == 11) throw Error({"no eleven", {}, "", ""});
      return i % 3 == 2 ? long_text(i) : std::to_string(i * i);
    }));
  }
  for (const int jobs : {1, 2, 7, 0, 1000}) {
    const auto outcomes = run(tasks, jobs);
    REQUIRE(outcomes.size() == tasks.size());
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      CHECK(outcomes[i].error.has_value() == (i == 11));
      if (i != 11) CHECK((outcomes[i].bytes == (i % 3 == 2 ? long_text(i) : std::to_string(i * i))));
    }
  }
  CHECK_FALSE(has_children());
}

TEST_CASE("no tasks have no outcomes") {
  CHECK(run({}).empty());
}

TEST_CASE("an empty result is a result") {
  const auto outcomes = run({task_of("nothing", [] { return std::string(); })});
  CHECK_FALSE(outcomes.at(0).error.has_value());
  CHECK(outcomes.at(0).bytes.empty());
}

TEST_CASE("children run at the same time") {
  // Each waits for the other, through pipes of their own: one after another neither would end.
  int forth[2], back[2];
  REQUIRE(::pipe(forth) == 0);
  REQUIRE(::pipe(back) == 0);
  const auto exchange = [](int to, int from) {
    char byte = 'x';
    if (::write(to, &byte, 1) != 1 || ::read(from, &byte, 1) != 1) throw std::runtime_error("no partner");
    return std::string(1, byte);
  };
  const auto outcomes =
      run({task_of("a", [&] { return exchange(forth[1], back[0]); }), task_of("b", [&] { return exchange(back[1], forth[0]); })}, 2);
  CHECK(outcomes.at(0).bytes == "x");
  CHECK(outcomes.at(1).bytes == "x");
  for (const int file : {forth[0], forth[1], back[0], back[1]}) ::close(file);
}

TEST_CASE("an error arrives with its kind and every part of its text") {
  for (const ErrorKind kind : {ErrorKind::input, ErrorKind::deadlock, ErrorKind::self_check, ErrorKind::internal, ErrorKind::cancelled}) {
    ErrorText text;
    text.what = "what";
    text.where = {"a file\nwith a line feed", 12, 34};
    text.why = std::string(200000, 'y');
    const Error error = failure([&]() -> std::string { throw Error(kind, text); });
    CHECK(error.kind() == kind);
    CHECK(error.text().what == text.what);
    CHECK(error.text().where.file == text.where.file);
    CHECK(error.text().where.line == 12);
    CHECK(error.text().where.column == 34);
    CHECK((error.text().why == text.why));
    CHECK(error.text().try_this.empty());
    CHECK((std::string(error.what()) == Error(kind, text).what()));
  }
}

TEST_CASE("other exceptions name the task") {
  const Error standard = failure([]() -> std::string { throw std::runtime_error("a reason"); });
  CHECK(standard.kind() == ErrorKind::internal);
  CHECK(standard.text().what == "the task: internal error");
  CHECK(standard.text().why == "a reason");
  const Error unknown = failure([]() -> std::string { throw 7; });
  CHECK(unknown.kind() == ErrorKind::internal);
  CHECK(unknown.text().what == "the task: internal error");
  const Error memory = failure([]() -> std::string { throw std::bad_alloc(); });
  CHECK(memory.kind() == ErrorKind::input);
  CHECK(memory.text().what == "the task: out of memory");
}

TEST_CASE("a child that dies is an internal error that names the task and what ended it") {
  const auto text_of = [](const std::function<std::string()>& work) {
    const Error error = failure(work);
    CHECK(error.kind() == ErrorKind::internal);
    return std::string(error.what());
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(text_of([]() -> std::string {
               std::signal(SIGABRT, SIG_DFL);  // the test runner has a handler of its own
               std::abort();
             }),
             Contains("the task") && Contains("SIGABRT"));
  CHECK_THAT(text_of([]() -> std::string {
               ::kill(::getpid(), SIGKILL);
               return "";
             }),
             Contains("the task") && Contains("SIGKILL") && Contains("memory"));
  CHECK_THAT(text_of([]() -> std::string { ::_exit(3); }), Contains("the task") && Contains("exit status 3"));
  CHECK_THAT(text_of([]() -> std::string { ::_exit(0); }), Contains("the task") && Contains("without a result"));
}

TEST_CASE("a child that dies amid its shares and its siblings takes nobody along") {
  const ChildTask dies = {"dies", [](const ReportShare& report) {
                            report(0.5);
                            ::kill(::getpid(), SIGKILL);
                            return std::string();
                          }};
  const auto outcomes = run({task_of("a", [] { return long_text(3); }), dies, task_of("c", [] { return long_text(2); })}, 3);
  CHECK((outcomes.at(0).bytes == long_text(3)));
  CHECK(outcomes.at(1).error.has_value());
  CHECK((outcomes.at(2).bytes == long_text(2)));
}

TEST_CASE("the progress is the mean share of all tasks and ends at one") {
  const auto stepwise = [](const ReportShare& report) {
    for (int i = 0; i <= 1000; ++i) report(i / 1000.0);
    return std::string("done");
  };
  std::vector<double> shares;
  ChildOptions options;
  options.jobs = 2;
  options.progress = [&](double share) { shares.push_back(share); };
  run_in_children({{"a", stepwise}, {"b", stepwise}, {"c", stepwise}}, options);
  REQUIRE_FALSE(shares.empty());
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.front() >= 0);
  CHECK(shares.back() == 1);
}

TEST_CASE("cancelling ends every child") {
  std::atomic<bool> cancelled{false};
  ChildOptions options;
  options.jobs = 2;
  options.cancelled = &cancelled;
  options.progress = [&](double share) { cancelled = share > 0; };
  const ChildTask endless = {"endless", [](const ReportShare& report) -> std::string {
                               for (report(0.5);;) ::pause();
                             }};
  try {
    run_in_children({endless, endless, endless, endless}, options);
    FAIL("endless tasks came to an end");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::cancelled);
  }
  CHECK_FALSE(has_children());
}

TEST_CASE("a progress that throws ends every child") {
  ChildOptions options;
  options.jobs = 3;
  options.progress = [](double) { throw std::runtime_error("no more"); };
  const ChildTask endless = {"endless", [](const ReportShare&) -> std::string {
                               for (;;) ::pause();
                             }};
  CHECK_THROWS_AS(run_in_children({endless, endless, endless}, options), std::runtime_error);
  CHECK_FALSE(has_children());
}

TEST_CASE("children leave interrupts to their parent") {
  const auto outcomes = run({task_of("signalled", [] {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) ::kill(::getpid(), number);
    return std::string("still here");
  })});
  CHECK(outcomes.at(0).bytes == "still here");
}

TEST_CASE("children die with their parent") {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t parent = ::fork();
  if (parent == 0) {
    run({task_of("orphan", []() -> std::string {
      for (;;) ::pause();
    })});
    ::_exit(0);
  }
  ::close(ends[1]);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  char byte;
  CHECK(::read(ends[0], &byte, 1) == 0);  // the end of the stream: the last holder of its other end is gone
  ::close(ends[0]);
}

TEST_CASE("what the parent had buffered is written once") {
  char name[] = "/tmp/bumpsim-test-XXXXXX";
  const int file = ::mkstemp(name);
  REQUIRE(file >= 0);
  std::fflush(stdout);
  const int terminal = ::dup(STDOUT_FILENO);
  ::dup2(file, STDOUT_FILENO);
  std::printf("once\n");
  const auto outcomes = run({task_of("a", [] { return std::string("a"); }), task_of("b", [] { return std::string("b"); })});
  std::fflush(stdout);
  ::dup2(terminal, STDOUT_FILENO);
  ::close(terminal);
  ::close(file);
  std::ifstream in(name);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  ::unlink(name);
  CHECK(outcomes.size() == 2);
  CHECK(text == "once\n");
}

TEST_CASE("children come back although the ends of children are ignored") {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  const auto outcomes = run({task_of("a", [] { return std::string("a"); })});
  CHECK(std::signal(SIGCHLD, before) == SIG_IGN);
  CHECK(outcomes.at(0).bytes == "a");
}

}  // namespace bump
