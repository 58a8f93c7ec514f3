#pragma once

/// Common part of all results about a fingertip, posture by posture.

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "api/named/digits.h"
#include "base/progress.h"
#include "solvers/status.h"

namespace thenar {

/// Common part of all results about a digit, posture by posture.
struct DigitResult {
  Outcome outcome;                              // done: postures, or 1 for a map
  std::string subject, digit;                   // names
  std::string map;                              // empty: built from bones and tendons
  std::string built;                            // fidelity, or which map, in words
  std::vector<std::string> rows;                // rows of the balance: joints, or Fx Fy Fz tx ..
  std::vector<std::string> muscles;             // names of muscles, in the order of tensions
  PostureGrid grid;                             // requested postures; none for a map
  std::shared_ptr<const DigitTendons> tendons;  // tendons for pictures; null for a map
  std::vector<SourceText> sources;              // text of the subject

  /// Returns true for a single posture or a map, which has one result instead of a table.
  [[nodiscard]] bool single() const { return grid.varied.empty(); }
};

/// Returns the result of a built digit without any posture.
/// @throws InputError if its hood is a net
[[nodiscard]] DigitResult begin_digit_result(const DigitCase& at);

/// Computes the result at one posture. @param q  [rad] (coordinates); empty for a map  @return
/// warnings
using ComputePosture = std::function<std::vector<std::string>(const Eigen::VectorXd& q)>;
/// Records that there is no answer at a posture, and the message that says why.
using RecordFailure = std::function<void(const Eigen::VectorXd& q, const std::string& message)>;

/// Returns a callback that appends a point with the posture and the message to `points`.
template <typename Point>
[[nodiscard]] RecordFailure failure_recorder(std::vector<Point>& points) {
  return [&points](const Eigen::VectorXd& q, const std::string& message) {
    Point point;
    point.q = q;
    point.message = message;
    points.push_back(std::move(point));
  };
}

/// Computes the result at every posture in order, until progress requests a stop; counts postures.
/// If only some postures have no result, each is recorded as a failure, and a warning counts them.
/// @throws the exception of `compute`, if there is a single posture or none has an answer
void compute_postures(DigitResult& result, const ComputePosture& compute,
                      const RecordFailure& record, const Progress& progress);

/// Returns the angles of the joints that vary: "PIP3=30 DIP3=10 deg".
[[nodiscard]] std::string varied_angles(const std::vector<std::string>& joints,
                                        const PostureGrid& grid, const Eigen::VectorXd& q);

}  // namespace thenar
