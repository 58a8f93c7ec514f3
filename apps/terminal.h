#pragma once

/// Messages of a command besides its result: a progress bar, warnings, the end of its output.

#include <cstddef>
#include <string>
#include <vector>

#include "base/progress.h"

namespace thenar {

/// Returns a progress that prints the estimated duration on stderr if it exceeds 10 s, and on a
/// terminal draws a progress bar for work longer than a second. Ctrl-C or SIGTERM requests a stop
/// with results so far, a second one kills.
/// @param kept  text about the results that are kept, printed on stderr after "stopping" at once at
/// the signal; empty: none
[[nodiscard]] Progress terminal_progress(const std::string& kept = "");

/// Prints a line "thenar: warning: .." on stderr for each. Call it before the answer is printed.
void print_warnings(const std::vector<std::string>& warnings);

/// Prints a complaint about a result as a warning, if there is one. @throws Error unless it is
/// allowed
void complain(const std::string& complaint, bool allowed);

/// Reports the completed part of stopped work, after its answer was delivered.
/// @param what  "posture"  @throws Stopped if less was done than requested
void throw_if_stopped(std::size_t done, std::size_t asked, const std::string& what);

/// Checks that all printed output was written; an error such as a full disk may appear only at the
/// end.
/// @param code  the exit code so far  @return the exit code
[[nodiscard]] int after_output(int code);

}  // namespace thenar
