#pragma once

/// A program run for its output, which may crash, hang or say too much without harm to us.

#include <cstddef>
#include <string>
#include <vector>

namespace thenar {

/// What came of it. One of `exit_code` and `signal` is set, unless it took too long.
struct ProcessEnd {
  std::string output;     // of its standard output, as far as it came
  int exit_code = -1;     // negative: it did not exit
  int signal = 0;         // that ended it
  bool too_long = false;  // it was ended at the limit of time
  bool too_much = false;  // or of output
  double clock = 0;       // how long it ran [s]
  double processor = 0;   // what it took of the processor [s]

  /// How it ended in words: "crashed (Segmentation fault)"; empty if it exited with 0.
  [[nodiscard]] std::string failure() const;
};

/// Runs `command` (a path and its arguments) with nothing on its standard input, no standard
/// error, and no file of ours open, in a process group of its own: Ctrl-C reaches us alone. The
/// program itself asks to be ended with its parent (end_with_parent()).
/// @param seconds  of the clock, after which it is ended [s]
/// @param most     bytes of output, beyond which it is ended
/// @throws InputError if it cannot be started.
[[nodiscard]] ProcessEnd run_bounded(const std::vector<std::string>& command, double seconds,
                                     std::size_t most);

/// To be called first in a program that run_bounded() starts: it is killed when its parent ends.
void end_with_parent();

}  // namespace thenar
