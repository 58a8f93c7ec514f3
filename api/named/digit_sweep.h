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

namespace thenar {

/// Description of a digit that was asked over postures: names, model and postures.
struct DigitSweep {
  std::string subject, digit;
  std::string map;                              // empty: built from bones and tendons
  std::string built;                            // fidelity, or which map, in words
  std::vector<std::string> rows;                // of the balance: joints, or Fx Fy Fz tx ..
  std::vector<std::string> muscles;             //
  PostureGrid grid;                             // postures asked for; none for a map
  std::size_t done = 0;                         // of them, or 1 for a map; fewer: it was stopped
  std::shared_ptr<const DigitTendons> tendons;  // for pictures; null for a map
  std::vector<SourceText> sources;              // of the subject
  std::vector<std::string> warnings;            // of limits, tendons, and postures without answer

  /// One posture, or a map: an answer and no table of answers.
  [[nodiscard]] bool single() const { return grid.varied.empty(); }
  [[nodiscard]] std::size_t asked() const { return map.empty() ? grid.postures.size() : 1; }
};

/// Returns the description of a digit that was built. @throws InputError if its hood is a net
[[nodiscard]] DigitSweep sweep_of(const DigitCase& at);

/// Asks at one posture. @param q  [rad] (coordinates); empty for a map  @return warnings
using AskPosture = std::function<std::vector<std::string>(const Eigen::VectorXd& q)>;
/// Hears why there is no answer at a posture.
using NoAnswer = std::function<void(const Eigen::VectorXd& q, const std::string& why)>;

/// Keeps a posture without an answer among the points of the others, with the reason.
template <typename Point>
[[nodiscard]] NoAnswer kept_in(std::vector<Point>& points) {
  return [&points](const Eigen::VectorXd& q, const std::string& why) {
    Point point;
    point.q = q;
    point.failure = why;
    points.push_back(std::move(point));
  };
}

/// Asks at every posture in order, until progress says stop, and counts those that are done. Where
/// only some postures have no answer they are told to `fail`, and a warning says how many.
/// @throws what `ask` throws, if there is one posture only or none has an answer
void ask_postures(DigitSweep& sweep, const AskPosture& ask, const NoAnswer& fail,
                  const Progress& progress);

/// "PIP3=30 DIP3=10 deg": angles of the joints that vary.
[[nodiscard]] std::string varied_angles(const std::vector<std::string>& joints,
                                        const PostureGrid& grid, const Eigen::VectorXd& q);

}  // namespace thenar
