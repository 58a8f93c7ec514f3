#pragma once

/// Tendons of human hands in moving scenes, as lines with their tensions.

#include <memory>
#include <string>
#include <vector>

#include "dynamics/human/digit_pull.h"
#include "dynamics/scene/build_scene.h"
#include "live/live_picture.h"
#include "live/strand_paths.h"

namespace thenar {

/// Tendons of all digits that a [[tendon]] or [[muscle]] of a scene pulls, drawn as strand_paths()
/// on the moving bones. Other digits have no tensions and are not drawn.
class SceneTendons {
 public:
  SceneTendons() = default;
  explicit SceneTendons(const BuiltScene& built);

  [[nodiscard]] const std::vector<LiveLine>& lines() const { return lines_; }
  /// Returns the names of the muscles that tensions() takes, "human:skewed/index/FDP2", as in
  /// readings and recorded runs.
  [[nodiscard]] const std::vector<std::string>& muscles() const { return muscles_; }

  /// Returns the points of all lines, line after line, in the world [m] (3 each).
  /// @param q     positions of the scene (q)
  /// @param X_WB  poses of all bodies of the mechanism
  [[nodiscard]] std::vector<Eigen::Vector3d> points(const Eigen::VectorXd& q,
                                                    const std::vector<Pose<double>>& X_WB) const;

  /// Returns the tension of every line before friction in sheaths [N] (lines). In a digit with a
  /// net, strands that no muscle pulls directly get NaN (unknown).
  /// @param q  positions of the scene (q)
  /// @param t  tensions of muscles(); NaN: unknown [N] (muscles)
  [[nodiscard]] std::vector<double> tensions(const Eigen::VectorXd& q,
                                             const Eigen::VectorXd& t) const;

 private:
  /// Drawn tendons of one digit.
  struct DigitPart {
    std::shared_ptr<const DigitTendons> tendons;
    int base = 0;                      // body whose frame is the hand's frame
    std::vector<int> q;                // entries of the scene's q (coordinates of the digit)
    std::vector<Eigen::Index> muscle;  // entries of muscles() (muscles of the digit)
    std::vector<StrandPath> paths;
  };
  void add_digits(const BuiltScene& built, const DigitPull& pull);

  std::vector<DigitPart> parts_;
  std::vector<LiveLine> lines_;
  std::vector<std::string> muscles_;
};

}  // namespace thenar
