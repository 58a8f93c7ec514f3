#pragma once

/// A digit asked posture by posture: what every answer about a fingertip has in common.

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

/// A digit that was asked posture by posture: what is the same in all results about one.
struct DigitResult {
  Outcome outcome;  // done: postures, or 1 for a map
  std::string subject, digit;
  std::string map;                              // empty: built from bones and tendons
  std::string built;                            // fidelity, or which map, in words
  std::vector<std::string> rows;                // of the balance: joints, or Fx Fy Fz tx ..
  std::vector<std::string> muscles;             //
  PostureGrid grid;                             // postures asked for; none for a map
  std::shared_ptr<const DigitTendons> tendons;  // for pictures; null for a map
  std::vector<SourceText> sources;              // of the subject

  /// Returns one posture, or a map: an answer and no table of answers.
  [[nodiscard]] bool single() const { return grid.varied.empty(); }
};

/// Begins the result of a digit that was built: no posture is done yet.
/// @throws InputError if its hood is a net
[[nodiscard]] DigitResult begin_digit_result(const DigitCase& at);

/// Asks at one posture. @param q  [rad] (coordinates); empty for a map  @return warnings
using AskPosture = std::function<std::vector<std::string>(const Eigen::VectorXd& q)>;
/// Records that there is no answer at a posture, and the message that says why.
using NoAnswer = std::function<void(const Eigen::VectorXd& q, const std::string& message)>;

/// Keeps a posture without an answer among the points of the others, with the reason.
template <typename Point>
[[nodiscard]] NoAnswer kept_in(std::vector<Point>& points) {
  return [&points](const Eigen::VectorXd& q, const std::string& message) {
    Point point;
    point.q = q;
    point.message = message;
    points.push_back(std::move(point));
  };
}

/// Asks at every posture in order, until progress says stop, and counts those that are done. Where
/// only some postures have no answer they are told to `fail`, and a warning says how many.
/// @throws what `ask` throws, if there is one posture only or none has an answer
void ask_postures(DigitResult& result, const AskPosture& ask, const NoAnswer& fail,
                  const Progress& progress);

/// Returns "PIP3=30 DIP3=10 deg": angles of the joints that vary.
[[nodiscard]] std::string varied_angles(const std::vector<std::string>& joints,
                                        const PostureGrid& grid, const Eigen::VectorXd& q);

}  // namespace thenar
