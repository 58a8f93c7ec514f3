#pragma once

#include <csignal>
#include <string>

#include "base/error.h"
#include "base/progress.h"

namespace thenar {

/// A progress bar on stderr, drawn only on a terminal and only for work longer than a second;
/// Ctrl-C or SIGTERM asks the work to stop and keep what it has, a second one kills.
/// @param kept  what the signal is answered with at once, on stderr, after "stopping": of what is
///              kept; empty: nothing is said of it
[[nodiscard]] Progress terminal_progress(const std::string& kept = "");

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

/// Was Ctrl-C pressed, or SIGTERM sent?
[[nodiscard]] bool interrupted();

/// As shells say of a program that a signal ended: 130 after Ctrl-C, also where another process of
/// the run was told to stop; 143 after SIGTERM.
[[nodiscard]] int exit_code_of_interruption();

/// Thrown by a command that a signal cut short, after it has saved what it had.
class Interrupted : public Error {
 public:
  using Error::Error;
};

}  // namespace thenar
