#pragma once

/// Exceptions of this library.
///
/// A wrong call or a wrong file throws. Failure of a method (no convergence, infeasible) is a
/// status in the result, so that the caller can still use the best point found.

#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/core.h>

namespace thenar {

class Error : public std::runtime_error {
 public:
  /// @param field  field of the request that is wrong, missing or helpful; empty: none, or not
  ///         known
  explicit Error(const std::string& what, std::string field = "")
      : std::runtime_error(what), field_(std::move(field)) {}

  /// Returns the name of the field in words joined by "_": "centre_of_mass". It is the name of an
  /// option of a command, a parameter of the server and a keyword in Python.
  [[nodiscard]] const std::string& field() const { return field_; }
  /// Sets the name of the field, unless it has one.
  void set_field(const std::string& field) {
    if (field_.empty()) field_ = field;
  }

 private:
  std::string field_;
};

/// Error in the arguments of a call: wrong shape, sign, name or rung.
class InputError : public Error {
 public:
  using Error::Error;
};

/// Error in a data file. The message always starts with "path:line: ".
class DataError : public Error {
 public:
  DataError(const std::string& path, int line, const std::string& what, std::string field = "")
      : Error(fmt::format("{}:{}: {}", path, line, what), std::move(field)) {}
};

/// Throws InputError unless ok. The message states the requirement and the actual value:
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

/// Returns the result of `work`, and adds a field to an InputError that names none.
template <typename Work>
auto in_field(const char* field, const Work& work) {
  try {
    return work();
  } catch (InputError& error) {
    error.set_field(field);
    throw;
  }
}

/// Returns the result of `work`, and turns its InputError into a DataError at a line of a file.
template <typename Work>
auto at_line(const std::string& path, int line, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw DataError(path, line, error.what());
  }
}

}  // namespace thenar
