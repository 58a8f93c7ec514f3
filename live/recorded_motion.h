#pragma once

/// Playback of a recorded run of a scene.

#include "api/scenes/read_scene_run.h"
#include "dynamics/mechanism/tree_motion.h"
#include "live/recorded_timeline.h"
#include "live/scene_picture.h"

namespace thenar {

/// Recorded run of a scene. Between recorded instants, positions, speeds, energies and tensions are
/// interpolated linearly and orientations of free bodies by slerp; contacts are those of the
/// nearest instant.
class RecordedMotion final : public RecordedTimeline {
 public:
  explicit RecordedMotion(RecordedScene run);

  [[nodiscard]] const LiveShape& shape() const override { return picture_.shape; }
  [[nodiscard]] LiveInstant instant() const override;

  /// Returns the selected parts, without efforts and energy balance, which are not recorded.
  [[nodiscard]] TimelineState state(const MotionParts& parts) const override;
  [[nodiscard]] MotionQuality quality() const override;
  [[nodiscard]] std::vector<std::string> warnings() const override { return run_.warnings; }
  [[nodiscard]] const std::string& name() const override { return run_.name; }

 private:
  [[nodiscard]] const SceneSample& nearest_sample() const {
    return run_.samples[nearest_instant()];
  }
  [[nodiscard]] Eigen::VectorXd positions() const;
  [[nodiscard]] Eigen::VectorXd speeds() const;
  [[nodiscard]] MotionEnergy energy() const;
  [[nodiscard]] Eigen::VectorXd tension() const;
  [[nodiscard]] std::vector<Pose<double>> poses(const Eigen::VectorXd& q) const;

  RecordedScene run_;
  ScenePicture picture_;
  TreeModel model_;
  std::vector<Eigen::Index> tension_of_;  // column of each drawn muscle; -1: not recorded
};

}  // namespace thenar
