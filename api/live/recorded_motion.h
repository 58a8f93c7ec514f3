#pragma once

/// A run of a scene that was recorded, shown again.

#include "api/live/live_timeline.h"
#include "api/live/scene_picture.h"
#include "api/scenes/read_scene_run.h"
#include "dynamics/mechanism/tree_motion.h"

namespace thenar {

/// A recorded run on its line of time. Between two instants that it kept, positions go straight and
/// bodies turn evenly; contacts are those of the nearer instant.
class RecordedMotion final : public LiveTimeline {
 public:
  explicit RecordedMotion(RecordedScene run);

  [[nodiscard]] const LiveShape& shape() const override { return picture_.shape; }
  [[nodiscard]] LiveInstant instant() const override;
  [[nodiscard]] unsigned long shape_changes() const override { return 0; }
  [[nodiscard]] unsigned long changes() const override { return changes_; }
  /// A step is a 240th of a second.
  [[nodiscard]] LiveTime live_time() const override;

  /// Goes on in time; stops playing at the end.
  MotionQuality step(long count, const Progress& progress) override;
  double seek(double t) override;
  void reset() override;
  /// Speeds, efforts and the balance of energy are of the nearest instant, or not recorded.
  [[nodiscard]] TimelineState state(const MotionParts& parts) const override;
  [[nodiscard]] MotionQuality quality() const override;
  [[nodiscard]] std::vector<std::string> warnings() const override { return run_.warnings; }
  [[nodiscard]] const std::string& name() const override { return run_.name; }

 private:
  [[nodiscard]] const SceneSample& nearest() const { return run_.samples[nearest_]; }
  [[nodiscard]] double end() const { return run_.samples.back().t; }
  [[nodiscard]] Eigen::VectorXd positions() const;
  [[nodiscard]] std::vector<Pose<double>> poses(const Eigen::VectorXd& q) const;

  RecordedScene run_;
  ScenePicture picture_;
  TreeModel model_;
  double t_ = 0;             // that is shown [s]
  std::size_t nearest_ = 0;  // instant of the run
  unsigned long changes_ = 0;
};

}  // namespace thenar
