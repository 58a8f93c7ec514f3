#pragma once

/// A scene that moves while somebody watches, pushes and turns back.

#include <memory>
#include <string>
#include <vector>

#include "live/live_timeline.h"
#include "live/motion_history.h"
#include "live/motion_inputs.h"
#include "live/motion_source.h"
#include "live/scene_picture.h"

namespace thenar {

/// A moving scene, its inputs and its past. What is shown is the newest instant or one that was
/// sought; steps go on from what is shown, and forget what came behind it. Not for use by several
/// threads at once.
class LiveMotion final : public LiveTimeline {
 public:
  /// @throws InputError as SceneStepper
  explicit LiveMotion(MotionSource source, const HistoryLimits& limits = {});

  [[nodiscard]] const LiveShape& shape() const override { return picture_.shape; }
  [[nodiscard]] LiveInstant instant() const override;
  [[nodiscard]] unsigned long shape_changes() const override { return 0; }
  [[nodiscard]] unsigned long changes() const override { return changes_; }
  [[nodiscard]] LiveTime live_time() const override;

  [[nodiscard]] const std::string& name() const override { return source_.name; }
  [[nodiscard]] const MovingScene& scene() const { return source_.built->scene; }
  [[nodiscard]] std::vector<std::string> warnings() const override { return source_.warnings; }

  /// Steps with the inputs that are set.
  ///
  /// Play pauses once where the time of the scene ends, after the step that comes there.
  /// A step that is divided tells and asks between its parts; stopped there, it is not made.
  /// @throws InputError if the state is not finite any more: the motion then stands where it was
  ///         good last.
  MotionQuality step(long count, const Progress& progress) override;
  /// Sets inputs, all or, where one is refused, none.
  /// @throws InputError with the nearest name of what is not there, or where a value is impossible
  ///         or beyond the largest inputs above.
  void set(const MotionInputs& inputs) { inputs_.set(inputs, stepper_); }
  [[nodiscard]] std::vector<MotionInput> inputs() const { return inputs_.list(stepper_); }

  double seek(double t) override;
  /// Returns to the start, and removes all inputs and the history.
  void reset() override;
  [[nodiscard]] TimelineState state(const MotionParts& parts) const override;

  [[nodiscard]] const SceneInstant& shown() const { return history_.at(shown_).at; }
  [[nodiscard]] bool is_newest() const { return shown_ + 1 == history_.size(); }
  [[nodiscard]] const MotionHistory& history() const { return history_; }
  [[nodiscard]] MotionQuality quality() const override;

 private:
  void keep();
  [[nodiscard]] bool passes_end() const;  // of the scene, by the step that was made last
  void take_quality(MotionQuality& of);   // of the steps since it was taken last
  void add_account(const Eigen::VectorXd& beyond, MotionQuality& of) const;
  void begin();
  void stand_still();  // at the last good instant, after a step that failed
  [[nodiscard]] std::vector<ContactSample> contacts() const;
  [[nodiscard]] std::vector<Pose<double>> poses() const;
  [[nodiscard]] std::vector<ElementValue> muscles() const;
  [[nodiscard]] Eigen::VectorXd tension() const;
  [[nodiscard]] MotionEnergy energy() const;
  void add_joints(TimelineState& out) const;
  void add_bodies(TimelineState& out) const;

  MotionSource source_;
  ScenePicture picture_;
  mutable SceneStepper stepper_;  // asked for poses and energies, it uses its room
  MotionSwitches inputs_;
  MotionHistory history_;
  PastInstant newest_;     // its room
  std::size_t shown_ = 0;  // of the history
  SceneSample start_;
  MotionQuality quality_;                // counts alone
  Eigen::VectorXd beyond_;               // of joints, as SceneCost::beyond
  std::vector<ElementValue> readings_;   // at the start: their names and units
  std::vector<std::size_t> tension_at_;  // of the picture's muscles: entry of readings_
  std::vector<std::size_t> moving_;      // bodies: moving_bodies()
  unsigned long changes_ = 0;
};

}  // namespace thenar
