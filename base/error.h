#pragma once

/// Exceptions that this library throws on purpose.
///
/// A bad call or a bad file throws. Bad luck (no convergence, infeasible) is a
/// status in the result, so the caller can still look at the best point found.

#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace thenar {

class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The caller asked for something impossible: wrong shape, sign, name or tier.
class InputError : public Error {
 public:
  using Error::Error;
};

/// A data file is wrong. The message always starts with "path:line: ".
class DataError : public Error {
 public:
  DataError(const std::string& path, int line, const std::string& what)
      : Error(fmt::format("{}:{}: {}", path, line, what)) {}
};

/// Throws InputError unless ok. State what was wanted and the value that came:
///   require(mu >= 0, "contact friction must be >= 0, got {}", mu);
template <typename... Args>
void require(bool ok, fmt::format_string<Args...> message, Args&&... args) {
  if (!ok) throw InputError(fmt::format(message, std::forward<Args>(args)...));
}

}  // namespace thenar
