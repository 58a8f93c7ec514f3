#include "apps/terminal.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "base/interrupt.h"
#include "base/pace.h"
#include "base/progress_parts.h"

namespace thenar {
namespace {

using Clock = std::chrono::steady_clock;

/// Returns the text that answers a signal.
std::string answer_to_signal(const std::string& kept) {
  return fmt::format("{}thenar: stopping{}{}; Ctrl-C again ends at once\n",
                     isatty(STDERR_FILENO) == 0 ? "" : "\r\033[K", kept.empty() ? "" : ": ", kept);
}

constexpr double kLongDuration = 10;  // shortest estimated duration that is announced [s]

constexpr double kMore = 2;  // times what was told, from which it is told again [1]

/// Reports the duration of long work, and draws a progress bar on a terminal.
class Teller {
 public:
  ~Teller() { wipe(); }

  void hear(double fraction, const std::string& what) {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    pace_.add_report(std::chrono::duration<double>(now - begin_).count(), fraction);
    if (interrupted()) return;
    foretell();
    if (isatty(STDERR_FILENO) != 0) draw(now, fraction, what);
  }

 private:
  void foretell() {
    const std::optional<double> whole = pace_.total_time();
    if (!whole || *whole < std::max(kLongDuration, kMore * told_)) return;
    wipe();
    fmt::print(stderr, "thenar: this takes {}about {}\n", told_ > 0 ? "longer, " : "",
               rough_time(*whole));
    told_ = *whole;
  }

  /// Draws the progress bar, at most ten times a second.
  void draw(Clock::time_point now, double fraction, const std::string& what) {
    if (now - begin_ < std::chrono::seconds(1) || now - last_ < std::chrono::milliseconds(100))
      return;
    last_ = now;
    drawn_ = true;
    constexpr int kWidth = 30;
    const int full = static_cast<int>(kWidth * std::min(1.0, std::max(0.0, fraction)));
    const std::optional<double> left = pace_.remaining_time();
    fmt::print(stderr, "\r\033[K[{:#<{}}{:.<{}}] {:3.0f} %{} {}", "", full, "", kWidth - full,
               100 * fraction, left ? fmt::format(", {} left,", rough_time(*left)) : "", what);
    std::fflush(stderr);
  }

  void wipe() {
    if (drawn_) fmt::print(stderr, "\r\033[K");
    drawn_ = false;
  }

  std::mutex mutex_;
  Clock::time_point begin_ = Clock::now(), last_;
  Pace pace_;
  double told_ = 0;  // [s]; 0: nothing was
  bool drawn_ = false;
};

}  // namespace

Progress terminal_progress(const std::string& kept) {
  catch_interrupts(answer_to_signal(kept));
  Progress progress;
  progress.stop_requested = interrupted;
  // Shared: the callback may be copied, the line is one.
  auto teller = std::make_shared<Teller>();
  progress.report = [teller](double fraction, const std::string& what) {
    teller->hear(fraction, what);
  };
  return progress;
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) fmt::print(stderr, "thenar: warning: {}\n", warning);
}

void complain(const std::string& complaint, bool allowed) {
  if (complaint.empty()) return;
  if (allowed) return print_warnings({complaint});
  // Name the option at the end of the first line, before the colon of a list.
  std::string text = complaint;
  text.insert(std::min(text.find(":\n"), text.size()),
              " (--allow-unconverged to exit without error)");
  throw Error(text);
}

void throw_if_stopped(std::size_t done, std::size_t asked, const std::string& what) {
  if (done >= asked) return;
  if (done == 0) throw Stopped(fmt::format("stopped before the first {} was done", what));
  throw Stopped(fmt::format("stopped after {} of {} {}s; they are kept", done, asked, what));
}

int after_output(int code) {
  std::cout.flush();
  errno = 0;
  const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
  if (written) return code;
  const char* why = errno == 0 ? "is the disk full?" : std::strerror(errno);
  fmt::print(stderr, "thenar: cannot write to standard output: {}\n", why);
  return code == 0 ? 1 : code;
}

}  // namespace thenar
