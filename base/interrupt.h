#pragma once

/// Ctrl-C and SIGTERM as a request to stop: the first asks the work to save its results and end,
/// the second kills.

#include <string>

namespace thenar {

/// Catches Ctrl-C and SIGTERM: from now on the first of these signals sets interrupted() and writes
/// `answer` to standard error at once; further ones end the program.
/// @param answer  message, truncated to 1023 bytes
void catch_interrupts(const std::string& answer);

/// Returns true if Ctrl-C was pressed, or SIGTERM sent, since catch_interrupts().
[[nodiscard]] bool interrupted();

/// Returns the exit code that shells report for a program that a signal ended: 130 after Ctrl-C,
/// also if another process of the run received it; 143 after SIGTERM.
[[nodiscard]] int exit_code_of_interruption();

/// Scope in which Ctrl-C and SIGTERM end the program at once where catch_interrupts() had caught
/// them. It is for work that saves nothing and does not check for stop requests. Other handlers,
/// such as those of an interpreter that loaded this library, are kept.
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
