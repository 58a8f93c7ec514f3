#pragma once

/// Messages of a command besides its answer: a progress bar, warnings, the end of its output.

#include <cstddef>
#include <string>
#include <vector>

#include "base/progress.h"

namespace thenar {

/// Says on stderr how long work takes, once its pace says that it is more than 10 s; on a terminal
/// draws a progress bar for work longer than a second. Ctrl-C or SIGTERM asks the work to stop and
/// keep what it has, a second one kills.
/// @param kept  what the signal is answered with at once, on stderr, after "stopping": of what is
///              kept; empty: nothing is said of it
[[nodiscard]] Progress terminal_progress(const std::string& kept = "");

/// A line "thenar: warning: .." on stderr for each; to be called before the answer is printed.
void print_warnings(const std::vector<std::string>& warnings);

/// Warns of what a result is accused of, if anything. @throws Error unless it was allowed
void complain(const std::string& complaint, bool allowed);

/// Says how much of the work was done where it was stopped, after its answer was delivered.
/// @param what  "posture"  @throws Stopped if less was done than was asked for
void tell_if_stopped(std::size_t done, std::size_t asked, const std::string& what);

/// Checks that all printed output was written: a full disk may show only now.
/// @param code  the exit code so far  @return the exit code
[[nodiscard]] int after_output(int code);

}  // namespace thenar
