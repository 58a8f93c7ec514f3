#pragma once

#include "base/error.h"
#include "base/progress.h"

namespace thenar {

/// A progress bar on stderr, drawn only on a terminal and only for work longer than a second;
/// Ctrl-C asks the work to stop and keep what it has, a second one kills.
[[nodiscard]] Progress terminal_progress();

/// Was Ctrl-C pressed?
[[nodiscard]] bool interrupted();

/// Thrown by a command that Ctrl-C cut short, after it has saved what it had.
class Interrupted : public Error {
 public:
  using Error::Error;
};

}  // namespace thenar
