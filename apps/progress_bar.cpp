#include "apps/progress_bar.h"

#include <chrono>
#include <csignal>
#include <memory>

#include <fmt/format.h>
#include <unistd.h>

namespace thenar {
namespace {

using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t g_signal = 0;  // a signal handler can reach nothing else

void on_interrupt(int signal) {
  g_signal = signal;
  std::signal(signal, SIG_DFL);
}

/// Draws at most ten times a second, and wipes its line when it goes.
class Bar {
 public:
  ~Bar() {
    if (drawn_) fmt::print(stderr, "\r\033[K");
  }

  void draw(double fraction, const std::string& what) {
    const auto now = Clock::now();
    if (now - begin_ < std::chrono::seconds(1) || now - last_ < std::chrono::milliseconds(100))
      return;
    last_ = now;
    drawn_ = true;
    constexpr int kWidth = 30;
    const int full = static_cast<int>(kWidth * std::min(1.0, std::max(0.0, fraction)));
    fmt::print(stderr, "\r\033[K[{:#<{}}{:.<{}}] {:3.0f} % {}", "", full, "", kWidth - full,
               100 * fraction, what);
    std::fflush(stderr);
  }

 private:
  Clock::time_point begin_ = Clock::now(), last_;
  bool drawn_ = false;
};

}  // namespace

Progress terminal_progress() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, on_interrupt);
  Progress progress;
  progress.stop_requested = interrupted;
  if (isatty(STDERR_FILENO) == 0) return progress;
  // Shared: the callback may be copied, the line is one.
  auto bar = std::make_shared<Bar>();
  progress.report = [bar](double fraction, const std::string& what) { bar->draw(fraction, what); };
  return progress;
}

bool interrupted() { return g_signal != 0; }

int exit_code_of_interruption() { return 128 + (interrupted() ? g_signal : SIGINT); }

}  // namespace thenar
