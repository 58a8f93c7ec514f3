#pragma once

/// Reasons why a search for nets ends.

#include <string>

namespace thenar {

/// Reason why a search for nets ended.
enum class NetSearchStop {
  kAgreed,       // no test of the pool sets the survivors apart
  kTests,        // as many tests as allowed, or the pool is used up
  kNoOracle,     // tests are worth measuring, and nobody is there to do it
  kAsked,        // stop was requested
  kNothingHolds  // no topology carries the loads
};

/// Describes why a search ended.
[[nodiscard]] std::string to_string(NetSearchStop stop);

}  // namespace thenar
