#include "base/interrupt.h"

#include <unistd.h>
#include <csignal>

namespace thenar {
namespace {

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

/// Returns whether this signal is caught by us; if so it ends the program from now on.
bool let_end(int signal) {
  struct sigaction now {};
  if (sigaction(signal, nullptr, &now) != 0 || now.sa_handler != on_interrupt) return false;
  std::signal(signal, SIG_DFL);
  return true;
}

}  // namespace

void catch_interrupts(const std::string& answer) {
  g_answer_size = answer.copy(g_answer, sizeof(g_answer) - 1);
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, on_interrupt);
}

bool interrupted() { return g_signal != 0; }

int exit_code_of_interruption() { return 128 + (interrupted() ? g_signal : SIGINT); }

SignalsEndAtOnce::SignalsEndAtOnce()
    : caught_interrupt_(let_end(SIGINT)), caught_terminate_(let_end(SIGTERM)) {}

SignalsEndAtOnce::~SignalsEndAtOnce() {
  if (caught_interrupt_) std::signal(SIGINT, on_interrupt);
  if (caught_terminate_) std::signal(SIGTERM, on_interrupt);
}

}  // namespace thenar
