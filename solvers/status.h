#pragma once

/// Status of a numerical method, and outcome of a question.
///
/// All results follow one convention (docs/conventions.md):
///   Status status                   how a numerical method ended; kStopped: by request of the
///   caller Outcome outcome                 how the work on a question of api/ or studies/ ended
///   std::string message             why there is no answer; empty: there is one
///   vector<string> warnings         assumptions and doubts about an answer that there is
/// Enumerations with words of a domain are declared beside what they describe: NetStatus,
/// OdeStatus.

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
  kLimit,       // a limit that the caller set was reached: iterations, evaluations, cuts
  kStopped,     // the caller asked to stop
  kStalled      // the method ended without an answer whose certificate holds
};
inline constexpr std::array kStatusNames{
    EnumName{Status::kSolved, "solved"},       EnumName{Status::kInfeasible, "infeasible"},
    EnumName{Status::kUnbounded, "unbounded"}, EnumName{Status::kLimit, "limit"},
    EnumName{Status::kStopped, "stopped"},     EnumName{Status::kStalled, "stalled"}};
[[nodiscard]] inline std::string name_of(Status status) { return name_in(kStatusNames, status); }

/// How the work on a question ended.
struct Outcome {
  Status status = Status::kSolved;    // kStopped: the result holds what was found by then
  std::size_t done = 0, asked = 0;    // of its parts
  std::string part = "part";          // what these count: "posture"
  std::vector<std::string> warnings;  // assumptions and doubts

  [[nodiscard]] bool stopped() const { return status == Status::kStopped; }
  /// Says how many parts are done: stopped if fewer than were asked for.
  void count_parts(std::size_t these, std::size_t all, const std::string& name) {
    done = these, asked = all, part = name;
    if (done < asked) status = Status::kStopped;
  }
  /// Adds warnings behind the others.
  void warn(const std::vector<std::string>& more) {
    warnings.insert(warnings.end(), more.begin(), more.end());
  }
};

/// Returns whether a method ended without an answer and without a proof that there is none.
[[nodiscard]] inline bool is_undecided(Status status) {
  return status == Status::kLimit || status == Status::kStopped || status == Status::kStalled;
}

}  // namespace thenar
