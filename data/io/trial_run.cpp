#include "data/io/trial_run.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>
#include <string_view>

#include <fcntl.h>
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

constexpr std::size_t kLongest = 4000;  // message; a pipe takes it at once [bytes]
constexpr int kRefused = 1, kTooMuch = 2;

/// What the copy does: nothing of it is seen outside but how it ends and a message.
[[noreturn]] void run_limited(rlim_t memory, int seconds, const std::function<void()>& work,
                              int message) {
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
  int end = 0;
  try {
    work();
  } catch (const std::bad_alloc&) {
    end = kTooMuch;
  } catch (const std::exception& error) {
    const std::string_view words = std::string_view(error.what()).substr(0, kLongest);
    end = write(message, words.data(), words.size()) >= 0 ? kRefused : kTooMuch;
  }
  _exit(end);
}

/// What a copy that has ended wrote.
std::string message_in(int pipe) {
  std::string words(kLongest, ' ');
  const ssize_t size = read(pipe, words.data(), words.size());
  words.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  return words;
}

/// Why a copy did not come back with 0, in words. @param message  that it left
std::string reason(int status, const std::string& message, const std::string& path) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    return "it is damaged: reading it does not end";
  if (WIFSIGNALED(status))
    return fmt::format("it is damaged: reading it crashes ({})", strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) == kTooMuch)
    return fmt::format("reading it takes more than {} MB of memory", kMemory / 1'000'000);
  if (WEXITSTATUS(status) != kRefused || message.empty()) return "it is damaged: reading it fails";
  const std::string place = path + ":1: ";
  return message.compare(0, place.size(), place) == 0 ? message.substr(place.size()) : message;
}

}  // namespace

void try_first(const std::string& path, int seconds, const std::function<void()>& work) {
  const rlim_t memory = memory_in_use();
  std::array<int, 2> ends{-1, -1};
  require(pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) == 0, "no pipe to read '{}' through: {}", path,
          std::strerror(errno));
  const pid_t copy = fork();
  if (copy == 0) run_limited(memory, seconds, work, ends[1]);
  const int no_copy = copy < 0 ? errno : 0;
  int status = 0, no_news = 0;
  while (copy > 0 && no_news == 0 && waitpid(copy, &status, 0) < 0)
    if (errno != EINTR) no_news = errno;
  const std::string message = message_in(ends[0]);
  for (const int end : ends) (void)close(end);
  require(no_copy == 0, "no process to read '{}' in: {}", path, std::strerror(no_copy));
  require(no_news == 0, "no news of the process that reads '{}': {}", path, std::strerror(no_news));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGINT || signal == SIGTERM) (void)raise(signal);  // it was meant for us, too
  throw DataError(path, 1, reason(status, message, path));
}

}  // namespace thenar
