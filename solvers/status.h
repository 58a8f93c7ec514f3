#pragma once

/// Status of a numerical method, and outcome of a question.
///
/// All results follow one convention (docs/conventions.md):
///  * `Status status`: ending of a numerical method; kStopped: stopped by the caller.
///  * `Outcome outcome`: ending of the work on a question of api/ or studies/.
///  * `std::string message`: reason why there is no answer; empty: there is one.
///  * `std::vector<std::string> warnings`: assumptions and doubts about an answer.
///
/// Enumerations with words of a domain, such as NetStatus and OdeStatus, are declared next to the
/// types that they describe.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/enum_names.h"

namespace thenar {

/// Status of a numerical method. Its result adds a `message`, residuals or a certificate.
enum class Status {
  kSolved,      // the result is an answer, and its certificate holds
  kInfeasible,  // no point obeys the constraints
  kUnbounded,   // the objective grows without limit along feasible points
  kLimit,       // a limit set by the caller was reached: iterations, evaluations, cuts
  kStopped,     // the caller requested a stop
  kStalled      // the method ended without an answer whose certificate holds
};
inline constexpr std::array kStatusNames{
    EnumName{Status::kSolved, "solved"},       EnumName{Status::kInfeasible, "infeasible"},
    EnumName{Status::kUnbounded, "unbounded"}, EnumName{Status::kLimit, "limit"},
    EnumName{Status::kStopped, "stopped"},     EnumName{Status::kStalled, "stalled"}};
[[nodiscard]] inline std::string name_of(Status status) { return name_in(kStatusNames, status); }

/// Outcome of a query.
struct Outcome {
  Status status = Status::kSolved;    // kStopped: the result holds what was computed until then
  std::size_t done = 0, asked = 0;    // number of parts completed, and requested
  std::string part = "part";          // noun for a part: "posture"
  std::vector<std::string> warnings;  // assumptions and caveats

  [[nodiscard]] bool stopped() const { return status == Status::kStopped; }
  /// Records the number of completed parts; the status is kStopped if some are missing.
  void count_parts(std::size_t these, std::size_t all, const std::string& name) {
    done = these, asked = all, part = name;
    if (done < asked) status = Status::kStopped;
  }
  /// Appends warnings.
  void warn(const std::vector<std::string>& more) {
    warnings.insert(warnings.end(), more.begin(), more.end());
  }
};

/// Returns whether a method ended without an answer and without a proof that there is none.
[[nodiscard]] inline bool is_undecided(Status status) {
  return status == Status::kLimit || status == Status::kStopped || status == Status::kStalled;
}

}  // namespace thenar
