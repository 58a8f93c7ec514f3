#pragma once

/// What the command says beside its answer: a progress bar, warnings, the end of its output.

#include <string>
#include <vector>

#include "base/progress.h"

namespace thenar {

/// A progress bar on stderr, drawn only on a terminal and only for work longer than a second;
/// Ctrl-C or SIGTERM asks the work to stop and keep what it has, a second one kills.
/// @param kept  what the signal is answered with at once, on stderr, after "stopping": of what is
///              kept; empty: nothing is said of it
[[nodiscard]] Progress terminal_progress(const std::string& kept = "");

/// A line "thenar: warning: .." on stderr for each; to be called before the answer is printed.
void print_warnings(const std::vector<std::string>& warnings);

/// What was printed must have arrived: a full disk may show only now.
/// @param code  the exit code so far  @return the exit code
[[nodiscard]] int after_output(int code);

}  // namespace thenar
