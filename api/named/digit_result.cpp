#include "api/named/digit_result.h"

#include <exception>

#include <fmt/format.h>

#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

/// Event at some of the postures: its first occurrence, and their number.
struct Occurrence {
  std::string first_text, first_angles;
  std::size_t count = 0;

  void add(const std::string& text, const std::string& angles) {
    if (count++ > 0) return;
    first_text = text;
    first_angles = angles;
  }

  /// @param kind  "" or "no answer"
  void tell(const std::string& kind, std::size_t of, std::vector<std::string>& warnings) const {
    if (count == 0) return;
    warnings.push_back(of == 1 ? first_text
                               : fmt::format("{}at {} of {} postures, first at {}: {}", kind, count,
                                             of, first_angles, first_text));
  }
};

}  // namespace

DigitResult begin_digit_result(const DigitCase& at) {
  // Copy what the answer is about, and the warnings of building it.
  DigitResult result;
  result.subject = at.subject.name;
  result.digit = at.digit;
  result.map = at.map;
  result.sources = at.sources;
  result.outcome.warnings = at.warnings;
  result.outcome.part = "posture";
  result.outcome.asked = at.map.empty() ? at.grid.postures.size() : 1;
  // A tip map has a single posture, so there is no grid.
  if (!at.map.empty()) {
    const DigitAtPosture map = digit_at(at, {});
    result.built = map.built;
    result.rows = map.rows;
    result.muscles = map.statics.muscles;
    return result;
  }
  require(at.net == nullptr, "wanted tendons whose torque is linear in tensions, got a net");
  result.built = describe(at.bones().fidelity);
  result.rows = at.bones().names.coordinates;
  result.muscles = at.bones().names.muscles;
  result.grid = at.grid;
  result.tendons = at.tendons;
  return result;
}

void compute_postures(DigitResult& result, const ComputePosture& compute,
                      const RecordFailure& record, const Progress& progress) {
  // Collect failures by kind, so that a thousand equal ones make one warning.
  Outcome& outcome = result.outcome;
  const std::size_t count = outcome.asked;
  Occurrence doubts, failures;
  std::exception_ptr first_failure;
  for (; outcome.done < count && !progress.stop(); ++outcome.done) {
    const Eigen::VectorXd q =
        result.map.empty() ? result.grid.postures[outcome.done] : Eigen::VectorXd();
    const std::string angles = varied_angles(result.rows, result.grid, q);
    // Record a posture without a result as a gap, and continue with the next.
    try {
      const std::vector<std::string> warnings = compute(q);
      if (!warnings.empty()) doubts.add(warnings.front(), angles);
    } catch (const InputError& error) {
      if (failures.count == 0) first_failure = std::current_exception();
      failures.add(error.what(), angles);
      record(q, error.what());
    }
    progress(static_cast<double>(outcome.done + 1) / static_cast<double>(count),
             fmt::format("posture {} of {}", outcome.done + 1, count));
  }
  // If no posture has an answer, the first failure is that of the request.
  if (first_failure && failures.count == outcome.done) std::rethrow_exception(first_failure);
  if (outcome.done < count) outcome.status = Status::kStopped;
  doubts.tell("", outcome.done, outcome.warnings);
  failures.tell("no answer ", outcome.done, outcome.warnings);
}

std::string varied_angles(const std::vector<std::string>& joints, const PostureGrid& grid,
                          const Eigen::VectorXd& q) {
  std::string text;
  for (const int joint : grid.varied)
    text += fmt::format("{}={:.4g} ", joints[static_cast<std::size_t>(joint)], q[joint] / kDegree);
  return text + "deg";
}

}  // namespace thenar
