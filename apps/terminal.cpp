#include "apps/terminal.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <unistd.h>

#include "base/interrupt.h"
#include "base/progress_parts.h"

namespace thenar {
namespace {

using Clock = std::chrono::steady_clock;

/// What a signal is answered with.
std::string answer_to_signal(const std::string& kept) {
  return fmt::format("{}thenar: stopping{}{}; Ctrl-C again ends at once\n",
                     isatty(STDERR_FILENO) == 0 ? "" : "\r\033[K", kept.empty() ? "" : ": ", kept);
}

/// Draws at most ten times a second, and wipes its line when it goes.
class Bar {
 public:
  ~Bar() {
    if (drawn_) fmt::print(stderr, "\r\033[K");
  }

  void draw(double fraction, const std::string& what) {
    const auto now = Clock::now();
    if (interrupted() || now - begin_ < std::chrono::seconds(1) ||
        now - last_ < std::chrono::milliseconds(100))
      return;
    last_ = now;
    if (!drawn_) first_ = {now, fraction};
    drawn_ = true;
    constexpr int kWidth = 30;
    const int full = static_cast<int>(kWidth * std::min(1.0, std::max(0.0, fraction)));
    fmt::print(stderr, "\r\033[K[{:#<{}}{:.<{}}] {:3.0f} %{} {}", "", full, "", kWidth - full,
               100 * fraction, time_left(now, fraction), what);
    std::fflush(stderr);
  }

 private:
  /// At the pace since the bar was first drawn: what was there before took no time.
  [[nodiscard]] std::string time_left(Clock::time_point now, double fraction) const {
    constexpr double kTells = 0.02;  // share of the work that says something of the pace
    const double gone = fraction - first_.fraction;
    if (gone < kTells) return "";
    const double taken = std::chrono::duration<double>(now - first_.at).count();
    const long left = std::lround(taken * std::max(0.0, 1 - fraction) / gone);  // [s]
    return left < 120 ? fmt::format(", {} s left,", left)
                      : fmt::format(", {} min left,", (left + 30) / 60);
  }

  struct Mark {
    Clock::time_point at;
    double fraction = 0;
  };

  Clock::time_point begin_ = Clock::now(), last_;
  Mark first_;
  bool drawn_ = false;
};

}  // namespace

Progress terminal_progress(const std::string& kept) {
  catch_interrupts(answer_to_signal(kept));
  Progress progress;
  progress.stop_requested = interrupted;
  if (isatty(STDERR_FILENO) == 0) return progress;
  // Shared: the callback may be copied, the line is one.
  auto bar = std::make_shared<Bar>();
  progress.report = [bar](double fraction, const std::string& what) { bar->draw(fraction, what); };
  return progress;
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) fmt::print(stderr, "thenar: warning: {}\n", warning);
}

void tell_if_stopped(std::size_t done, std::size_t asked, const std::string& what) {
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
