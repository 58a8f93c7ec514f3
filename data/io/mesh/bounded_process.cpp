#include "data/io/mesh/bounded_process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/error.h"

namespace thenar {
namespace {

using Clock = std::chrono::steady_clock;

/// Both ends of a pipe, which it closes.
class Pipe {
 public:
  Pipe() { require(pipe2(ends_.data(), O_CLOEXEC) == 0, "no pipe: {}", std::strerror(errno)); }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] int end(std::size_t i) const { return ends_.at(i); }
  void close_end(std::size_t i) {
    if (ends_.at(i) >= 0) (void)close(ends_.at(i));
    ends_.at(i) = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// Starts the program with its output in a pipe. @returns its process id
pid_t start(const std::vector<std::string>& command, int output) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  // No input, output in the pipe, no errors, no other open file.
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, output, 1);
  posix_spawn_file_actions_addopen(&files, 2, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&files, 3);
  // Default signals, whatever this process has blocked or ignored; a process group of its own.
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);

  // Arguments as C strings.
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = -1;
  const int error =
      posix_spawn(&process, arguments[0], &files, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  require(error == 0, "'{}' cannot be started: {}", command.at(0), std::strerror(error));
  return process;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Reads until the other end is closed, or a limit is reached.
void read_all(int pipe, double seconds, std::size_t most, ProcessEnd& end) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
  std::array<char, 1 << 16> part;
  while (true) {
    // Wait for output until the deadline.
    const double left = std::chrono::duration<double>(deadline - Clock::now()).count();
    pollfd waiting{pipe, POLLIN, 0};
    const int ready = left > 0 ? poll(&waiting, 1, static_cast<int>(1000 * left) + 1) : 0;
    if (ready < 0 && errno == EINTR) continue;
    end.too_long = ready == 0;
    if (ready <= 0) return;
    // Take what has come; nothing means the end.
    const ssize_t got = read(pipe, part.data(), part.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return;
    end.output.append(part.data(), static_cast<std::size_t>(got));
    end.too_much = end.output.size() > most;
    if (end.too_much) return;
  }
}

}  // namespace

std::string ProcessEnd::failure() const {
  if (too_long || signal == SIGXCPU) return "took too long";
  if (too_much) return "gave too much";
  if (signal == SIGKILL) return "was killed";
  if (signal != 0) return fmt::format("crashed ({})", strsignal(signal));
  return exit_code == 0 ? "" : fmt::format("ended with status {}", exit_code);
}

ProcessEnd run_bounded(const std::vector<std::string>& command, double seconds, std::size_t most) {
  const auto begin = Clock::now();
  Pipe pipe;
  // This process must not hold the writing end open.
  const pid_t process = start(command, pipe.end(1));
  pipe.close_end(1);
  ProcessEnd end;
  read_all(pipe.end(0), seconds, most, end);
  // Beyond a limit the program is killed.
  if (end.too_long || end.too_much) (void)kill(process, SIGKILL);
  pipe.close_end(0);
  int status = 0;
  rusage used{};
  // Collect its status and its use of the processor.
  while (wait4(process, &status, 0, &used) < 0)
    if (errno != EINTR) return end;  // children are not waited for here: rely on the output
  end.clock = std::chrono::duration<double>(Clock::now() - begin).count();
  end.processor = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  return end;
}

void end_with_parent() {
  const pid_t parent = getppid();
  (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // the parent has ended already
}

}  // namespace thenar
