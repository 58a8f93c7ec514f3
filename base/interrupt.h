#pragma once

/// Ctrl-C and SIGTERM as a request to stop: the first asks the work to keep what it has and end,
/// the second kills.

#include <csignal>
#include <string>

namespace thenar {

/// Catches Ctrl-C and SIGTERM: from now on the first of these signals sets interrupted() and writes
/// `answer` to standard error at once; after it they end the program.
/// @param answer  at most 1023 bytes, the rest is cut off
void catch_interrupts(const std::string& answer);

/// Returns whether Ctrl-C was pressed, or SIGTERM sent, since catch_interrupts().
[[nodiscard]] bool interrupted();

/// Returns the exit code that shells report for a program that a signal ended: 130 after Ctrl-C,
/// also where another process of the run was told to stop; 143 after SIGTERM.
[[nodiscard]] int exit_code_of_interruption();

/// Scope in which Ctrl-C and SIGTERM end the program at once where catch_interrupts() had caught
/// them. It is for work that keeps nothing and does not check whether to stop. Handlers of others,
/// as of an interpreter that loaded this library, stay.
class SignalsEndAtOnce {
 public:
  SignalsEndAtOnce();
  ~SignalsEndAtOnce();
  SignalsEndAtOnce(const SignalsEndAtOnce&) = delete;
  SignalsEndAtOnce& operator=(const SignalsEndAtOnce&) = delete;

 private:
  bool caught_interrupt_, caught_terminate_;
};

}  // namespace thenar
