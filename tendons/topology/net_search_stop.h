#pragma once

/// End of a search for nets.

#include <string>

namespace thenar {

/// Reason why a search for nets ended.
enum class NetSearchStop {
  kAgreed,       // no test of the pool distinguishes the surviving topologies
  kTests,        // the limit of tests is reached, or the pool is used up
  kNoOracle,     // tests are worth measuring, but there is no oracle
  kAsked,        // the caller asked to stop
  kNothingHolds  // no topology carries the loads
};

/// Describes why a search ended.
[[nodiscard]] std::string to_string(NetSearchStop stop);

}  // namespace thenar
