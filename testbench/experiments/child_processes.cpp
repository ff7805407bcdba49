#include "testbench/experiments/child_processes.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>
#include <system_error>

#include "testbench/experiments/child_message.h"
#include "testbench/reference/cores.h"

namespace bump {

namespace {

constexpr std::array<int, 3> interrupting_signals = {SIGINT, SIGTERM, SIGHUP};

Error error_of(ErrorKind kind, const std::string& what, const std::string& why, const std::string& try_this) {
  ErrorText text;
  text.what = what;
  text.why = why;
  text.try_this = try_this;
  return Error(kind, text);
}

// ---- in the child

void write_all(int file, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = ::write(file, bytes.data() + done, bytes.size() - done);
    if (written > 0) done += static_cast<std::size_t>(written);
    if (written < 0 && errno != EINTR) ::_exit(1);  // nobody listens any more
  }
}

std::string work_through(const ChildTask& task, int out) {
  double reported = 0;
  const auto report_share = [&](double share) {
    if (!(share >= reported + 0.005)) return;  // what a progress line can show
    reported = share;
    write_all(out, share_message(share));
  };
  try {
    return result_message(task.work(report_share));
  } catch (const Error& error) {
    return error_message(error);
  } catch (const std::bad_alloc&) {
    return error_message(
        error_of(ErrorKind::input, task.name + ": out of memory", "", "a smaller frame or mesh, or fewer at a time with --jobs 1"));
  } catch (const std::exception& error) {
    return error_message(
        error_of(ErrorKind::internal, task.name + ": internal error", error.what(), "report this with the command that led to it"));
  } catch (...) {
    return error_message(error_of(ErrorKind::internal, task.name + ": internal error", "an exception of unknown type",
                                  "report this with the command that led to it"));
  }
}

/// Whatever interrupts the command reaches the parent too, which ends its children: here such signals would only race with it, and the
/// parent's handlers clean up what belongs to the parent. The child dies with the parent, however that ends.
void leave_signals_to_parent(pid_t parent) {
  for (const int number : interrupting_signals) std::signal(number, SIG_IGN);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
}

/// No exception may leave it: above it on the stack is the parent's work. Neither may destructors and buffers, which are the parent's, run.
[[noreturn]] void be_child(const ChildTask& task, int out) noexcept {
  write_all(out, work_through(task, out));
  ::_exit(0);
}

// ---- in the parent

sigset_t interrupting_set() {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : interrupting_signals) sigaddset(&set, number);
  return set;
}

/// A parent that was told to ignore its children's ends would never learn of them.
class DefaultChildSignal {
 public:
  DefaultChildSignal() {
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    sigemptyset(&action.sa_mask);
    ::sigaction(SIGCHLD, &action, &before_);
  }
  ~DefaultChildSignal() { ::sigaction(SIGCHLD, &before_, nullptr); }
  DefaultChildSignal(const DefaultChildSignal&) = delete;
  DefaultChildSignal& operator=(const DefaultChildSignal&) = delete;

 private:
  struct sigaction before_ {};
};

int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return -1;
  return status;
}

std::string signal_name(int number) {
  const char* name = ::sigabbrev_np(number);
  return name != nullptr ? std::string("SIG") + name : "signal " + std::to_string(number);
}

Error death_of(const std::string& task, int status) {
  if (status != -1 && WIFSIGNALED(status)) {
    const bool killed = WTERMSIG(status) == SIGKILL;
    return error_of(ErrorKind::internal, fmt::format("{}: its process was ended by {}", task, signal_name(WTERMSIG(status))),
                    killed ? "something else ended it; a system that runs out of memory does" : "",
                    killed ? "fewer at a time with --jobs 1, or a smaller frame" : "report this with the command that led to it");
  }
  return error_of(ErrorKind::internal, fmt::format("{}: its process ended without a result", task),
                  status == -1 || !WIFEXITED(status) ? "its status is unknown" : fmt::format("exit status {}", WEXITSTATUS(status)),
                  "report this with the command that led to it");
}

struct Child {
  std::size_t task = 0;
  pid_t process = -1;
  int in = -1;           ///< read end of its pipe
  std::string received;  ///< without the shares
  double share = 0;
};

class Children {
 public:
  Children(const std::vector<ChildTask>& tasks, const ChildOptions& options) : tasks_(tasks), options_(options), outcomes_(tasks.size()) {}
  /// On the way out of an exception too.
  ~Children() {
    for (const Child& child : running_) ::kill(child.process, SIGKILL);
    for (const Child& child : running_) {
      ::close(child.in);
      wait_for(child.process);
    }
  }
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;

  std::vector<ChildOutcome> run() {
    const std::size_t jobs = static_cast<std::size_t>(options_.jobs > 0 ? options_.jobs : cores_of_process());
    while (ended_ < tasks_.size()) {
      stop_if_cancelled();
      while (begun_ < tasks_.size() && running_.size() < jobs && begin(begun_)) ++begun_;
      listen();
      stop_if_cancelled();
      told_ = std::max(told_, share());  // sums of the same shares in another order differ in their last bits
      if (options_.progress) options_.progress(told_);
    }
    return std::move(outcomes_);
  }

 private:
  void stop_if_cancelled() const {
    if (options_.cancelled != nullptr && *options_.cancelled)
      throw error_of(ErrorKind::cancelled, "interrupted", "", "nothing was written");
  }

  double share() const {
    double sum = static_cast<double>(ended_);
    for (const Child& child : running_) sum += std::clamp(child.share, 0.0, 1.0);
    return sum / static_cast<double>(tasks_.size());
  }

  /// False if the system gives no further process or pipe now but others are running: theirs come free.
  bool begin(std::size_t task) {
    const auto refused = [&](const char* what) {
      const int reason = errno;
      if (!running_.empty()) return false;
      throw error_of(ErrorKind::input, std::string("cannot start ") + what + " for " + tasks_[task].name,
                     std::generic_category().message(reason), "free memory, or raise the limits of the shell (ulimit)");
    };
    running_.reserve(running_.size() + 1);  // nothing may fail between fork and the entry here
    std::array<int, 2> pipe_ends{};
    if (::pipe2(pipe_ends.data(), O_CLOEXEC) != 0) return refused("a pipe");

    // What is buffered now would be written once by each process.
    std::fflush(stdout);
    std::fflush(stderr);
    std::cout.flush();
    const sigset_t interrupting = interrupting_set();
    sigset_t before;
    ::sigprocmask(SIG_BLOCK, &interrupting, &before);
    const pid_t parent = ::getpid();
    const pid_t process = ::fork();
    if (process == 0) {
      leave_signals_to_parent(parent);
      ::sigprocmask(SIG_SETMASK, &before, nullptr);
      ::close(pipe_ends[0]);
      for (const Child& child : running_) ::close(child.in);
      be_child(tasks_[task], pipe_ends[1]);
    }
    const int reason = errno;
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    ::close(pipe_ends[1]);
    if (process < 0) {
      ::close(pipe_ends[0]);
      errno = reason;
      return refused("a process");
    }
    Child child;
    child.task = task;
    child.process = process;
    child.in = pipe_ends[0];
    running_.push_back(std::move(child));
    return true;
  }

  /// Waits until a child says something; returns now and then, since a signal may have come just before the wait.
  void listen() {
    std::vector<pollfd> files;
    for (const Child& child : running_) files.push_back({child.in, POLLIN, 0});
    if (::poll(files.data(), files.size(), 100) <= 0) return;
    for (std::size_t i = files.size(); i-- > 0;) {
      if (files[i].revents == 0 || receive(running_[i])) continue;
      Child child = std::move(running_[i]);
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
      end(child);
    }
  }

  /// False at the end of the stream.
  bool receive(Child& child) {
    const ssize_t count = ::read(child.in, buffer_.data(), buffer_.size());
    if (count < 0) return errno == EINTR || errno == EAGAIN;
    if (count == 0) return false;
    child.received.append(buffer_.data(), static_cast<std::size_t>(count));
    take_shares(child.received, child.share);
    return true;
  }

  void end(Child& child) {
    ::close(child.in);
    const int status = wait_for(child.process);
    ++ended_;
    ChildOutcome& outcome = outcomes_[child.task];
    const bool complete = status != -1 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (!complete || !take_outcome(std::move(child.received), outcome)) outcome.error = death_of(tasks_[child.task].name, status);
  }

  const std::vector<ChildTask>& tasks_;
  const ChildOptions& options_;
  std::vector<ChildOutcome> outcomes_;
  std::vector<Child> running_;
  std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 16);
  std::size_t begun_ = 0, ended_ = 0;
  double told_ = 0;  ///< share of the work that was reported last
};

}  // namespace

std::vector<ChildOutcome> run_in_children(const std::vector<ChildTask>& tasks, const ChildOptions& options) {
  const DefaultChildSignal default_child_signal;
  return Children(tasks, options).run();
}

}  // namespace bump
