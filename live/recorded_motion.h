#pragma once

/// A run of a scene that was recorded, shown again.

#include "api/scenes/read_scene_run.h"
#include "dynamics/mechanism/tree_motion.h"
#include "live/recorded_timeline.h"
#include "live/scene_picture.h"

namespace thenar {

/// A recorded run on its line of time. Between two instants that it kept, positions, speeds,
/// energies and tensions go straight and bodies turn evenly; contacts are those of the nearer
/// instant.
class RecordedMotion final : public RecordedTimeline {
 public:
  explicit RecordedMotion(RecordedScene run);

  [[nodiscard]] const LiveShape& shape() const override { return picture_.shape; }
  [[nodiscard]] LiveInstant instant() const override;

  /// Efforts and the balance of energy were not recorded.
  [[nodiscard]] TimelineState state(const MotionParts& parts) const override;
  [[nodiscard]] MotionQuality quality() const override;
  [[nodiscard]] std::vector<std::string> warnings() const override { return run_.warnings; }
  [[nodiscard]] const std::string& name() const override { return run_.name; }

 private:
  [[nodiscard]] const SceneSample& nearest_sample() const { return run_.samples[nearest()]; }
  [[nodiscard]] Eigen::VectorXd positions() const;
  [[nodiscard]] Eigen::VectorXd speeds() const;
  [[nodiscard]] MotionEnergy energy() const;
  [[nodiscard]] Eigen::VectorXd tension() const;
  [[nodiscard]] std::vector<Pose<double>> poses(const Eigen::VectorXd& q) const;

  RecordedScene run_;
  ScenePicture picture_;
  TreeModel model_;
  std::vector<Eigen::Index> tension_of_;  // of the picture's muscles: column; -1: not recorded
};

}  // namespace thenar
