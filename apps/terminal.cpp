#include "apps/terminal.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

namespace thenar {
namespace {

using Clock = std::chrono::steady_clock;

// A signal handler can reach nothing but globals, and call hardly more than write().
volatile std::sig_atomic_t g_signal = 0;
char g_answer[1024];
std::size_t g_answer_size = 0;

void on_interrupt(int signal) {
  if (g_signal == 0 && write(STDERR_FILENO, g_answer, g_answer_size) < 0) {
    // Nobody reads: there is nothing else to do about it here.
  }
  g_signal = signal;
  std::signal(signal, SIG_DFL);
}

/// What a signal is answered with.
void prepare_answer(const std::string& kept) {
  const std::string text =
      fmt::format("{}thenar: stopping{}{}; Ctrl-C again ends at once\n",
                  isatty(STDERR_FILENO) == 0 ? "" : "\r\033[K", kept.empty() ? "" : ": ", kept);
  g_answer_size = text.copy(g_answer, sizeof(g_answer));
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
    const int left = static_cast<int>(taken * std::max(0.0, 1 - fraction) / gone + 0.5);  // [s]
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
  prepare_answer(kept);
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
