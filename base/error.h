#pragma once

/// Exceptions that this library throws on purpose.
///
/// A bad call or a bad file throws. Bad luck (no convergence, infeasible) is a
/// status in the result, so the caller can still look at the best point found.

#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/core.h>

namespace thenar {

class Error : public std::runtime_error {
 public:
  /// @param field  of the request that is wrong, left out or of help; empty: none, or not known
  explicit Error(const std::string& what, std::string field = "")
      : std::runtime_error(what), field_(std::move(field)) {}

  /// Returns the name of the field in words joined by "_", as in "centre_of_mass". A command has an
  /// option of that name, a server a parameter, Python a keyword.
  [[nodiscard]] const std::string& field() const { return field_; }

 private:
  std::string field_;
};

/// The caller asked for something impossible: wrong shape, sign, name or tier.
class InputError : public Error {
 public:
  using Error::Error;
};

/// A data file is wrong. The message always starts with "path:line: ".
class DataError : public Error {
 public:
  DataError(const std::string& path, int line, const std::string& what, std::string field = "")
      : Error(fmt::format("{}:{}: {}", path, line, what), std::move(field)) {}
};

/// Throws InputError unless ok. State what was wanted and the value that came:
///   require(mu >= 0, "contact friction must be >= 0, got {}", mu);
template <typename... Args>
void require(bool ok, fmt::format_string<Args...> message, Args&&... args) {
  if (!ok) throw InputError(fmt::format(message, std::forward<Args>(args)...));
}

/// Throws as require(), and names the field of a request:
///   require_field("digit", ok, "wanted a digit; subject '{}' has {}", ..);
template <typename... Args>
void require_field(const char* field, bool ok, fmt::format_string<Args...> message,
                   Args&&... args) {
  if (!ok) throw InputError(fmt::format(message, std::forward<Args>(args)...), field);
}

}  // namespace thenar
