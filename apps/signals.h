#pragma once

/// What SIGINT and SIGTERM do while there is nothing to keep.

#include <csignal>

namespace thenar {

/// For as long as it lives, Ctrl-C and SIGTERM end the program at once, whatever
/// terminal_progress() had asked for; then as before. For work that keeps nothing and asks nobody
/// whether to stop.
class SignalsEndAtOnce {
 public:
  SignalsEndAtOnce()
      : interrupt_(std::signal(SIGINT, SIG_DFL)), terminate_(std::signal(SIGTERM, SIG_DFL)) {}
  ~SignalsEndAtOnce() {
    if (interrupt_ != SIG_ERR) std::signal(SIGINT, interrupt_);
    if (terminate_ != SIG_ERR) std::signal(SIGTERM, terminate_);
  }
  SignalsEndAtOnce(const SignalsEndAtOnce&) = delete;
  SignalsEndAtOnce& operator=(const SignalsEndAtOnce&) = delete;

 private:
  using Handler = void (*)(int);
  Handler interrupt_, terminate_;
};

}  // namespace thenar
