#include "data/io/trial_run.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "base/read_file.h"

namespace thenar {
namespace {

constexpr rlim_t kMemory = 1000 * 1000 * 1000;  // beyond what this process has [bytes]

/// Address space of this process [bytes].
rlim_t memory_in_use() {
  constexpr std::size_t kMost = 1000;
  const std::string pages = read_file("/proc/self/statm", kMost);
  return std::stoull(pages) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void lower_limit(int resource, rlim_t value) {
  rlimit limit{};
  if (getrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, value);
  (void)setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

/// What the copy does: nothing of it is seen outside but how it ends.
[[noreturn]] void run_limited(rlim_t memory, int seconds, const std::function<void()>& work) {
  (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGINT, SIGTERM})
    (void)std::signal(signal, SIG_DFL);
  lower_limit(RLIMIT_CORE, 0);
  lower_limit(RLIMIT_CPU, static_cast<rlim_t>(seconds));
#ifndef __SANITIZE_ADDRESS__  // whose shadow takes more than all memory
  lower_limit(RLIMIT_AS, memory + kMemory);
#else
  (void)memory;
#endif
  try {
    work();
  } catch (...) {
    // The message is told by the process itself.
  }
  _exit(0);
}

}  // namespace

void try_first(const std::string& path, int seconds, const std::function<void()>& work) {
  const rlim_t memory = memory_in_use();
  const pid_t copy = fork();
  require(copy >= 0, "no process to read '{}' in: {}", path, std::strerror(errno));
  if (copy == 0) run_limited(memory, seconds, work);
  int status = 0;
  while (waitpid(copy, &status, 0) < 0)
    require(errno == EINTR, "no news of the process that reads '{}': {}", path,
            std::strerror(errno));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGINT || signal == SIGTERM) (void)raise(signal);  // it was meant for us, too
  throw DataError(path, 1,
                  fmt::format("it is damaged: reading it {}",
                              signal == SIGXCPU ? "does not end"
                              : signal == 0     ? "fails"
                                                : fmt::format("crashes ({})", strsignal(signal))));
}

}  // namespace thenar
