#pragma once

/// Runs a program for its output, isolated from its crashes, hangs and excessive output.

#include <cstddef>
#include <string>
#include <vector>

namespace thenar {

/// Result of run_bounded(). One of `exit_code` and `signal` is set, unless it took too long.
struct ProcessEnd {
  std::string output;     // standard output until its end
  int exit_code = -1;     // negative: it did not exit
  int signal = 0;         // signal that ended it
  bool too_long = false;  // killed at the time limit
  bool too_much = false;  // killed at the output limit
  double clock = 0;       // running time [s]
  double processor = 0;   // processor time [s]

  /// Describes a failed end: "crashed (Segmentation fault)"; empty if it exited with 0.
  [[nodiscard]] std::string failure() const;
};

/// Runs `command` (a path and its arguments) without standard input, standard error or any of our
/// open files, in a process group of its own: Ctrl-C reaches this process only. The program should
/// call end_with_parent().
/// @param seconds  time limit by the clock [s]
/// @param most     limit of output [bytes]
/// @throws InputError if it cannot be started.
[[nodiscard]] ProcessEnd run_bounded(const std::vector<std::string>& command, double seconds,
                                     std::size_t most);

/// Lets the system kill this process when its parent ends. Call it first in a program that
/// run_bounded() starts.
void end_with_parent();

}  // namespace thenar
