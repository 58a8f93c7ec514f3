#include "solvers/status.h"

#include <array>

namespace thenar {

std::string name_of(Status status) {
  constexpr std::array kNames{"solved", "infeasible", "unbounded", "limit", "stopped", "stalled"};
  return kNames[static_cast<std::size_t>(status)];
}

bool is_undecided(Status status) {
  return status == Status::kLimit || status == Status::kStopped || status == Status::kStalled;
}

}  // namespace thenar
