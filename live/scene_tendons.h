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

/// The tendons of all digits that a [[tendon]] or [[muscle]] of a scene pulls: strand_paths() on
/// the moving bones. Others have no tension and are not drawn.
class SceneTendons {
 public:
  SceneTendons() = default;
  explicit SceneTendons(const BuiltScene& built);

  [[nodiscard]] const std::vector<LiveLine>& lines() const { return lines_; }
  /// Returns the names of the muscles whose tensions are needed: "human:skewed/index/FDP2", as in
  /// readings and runs.
  [[nodiscard]] const std::vector<std::string>& muscles() const { return muscles_; }

  /// Points of all lines, one after the other, world [m] (3 each).
  /// @param q     positions of the scene (q)
  /// @param X_WB  of all bodies of the mechanism
  [[nodiscard]] std::vector<Eigen::Vector3d> points(const Eigen::VectorXd& q,
                                                    const std::vector<Pose<double>>& X_WB) const;

  /// Tension of every line before friction in sheaths. Of a digit with a net a strand has what its
  /// muscle gives; what the net makes of it in strands that no muscle pulls is NaN, unknown.
  /// @param t  of muscles(); NaN: unknown [N] (muscles)
  /// @return [N] (lines)
  [[nodiscard]] std::vector<double> tensions(const Eigen::VectorXd& q,
                                             const Eigen::VectorXd& t) const;

 private:
  /// One digit with what is drawn of it.
  struct Part {
    std::shared_ptr<const DigitTendons> tendons;
    int base = 0;                      // body whose frame is the hand's
    std::vector<int> q;                // places of its coordinates (coordinates)
    std::vector<Eigen::Index> muscle;  // of muscles() (muscles)
    std::vector<StrandPath> paths;
  };
  void add(const BuiltScene& built, const DigitPull& pull);

  std::vector<Part> parts_;
  std::vector<LiveLine> lines_;
  std::vector<std::string> muscles_;
};

}  // namespace thenar
