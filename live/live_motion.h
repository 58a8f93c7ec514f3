#pragma once

/// Interactive simulation of a scene: stepping, inputs, and seeking in its history.

#include <string>
#include <vector>

#include "live/live_timeline.h"
#include "live/motion_history.h"
#include "live/motion_inputs.h"
#include "live/motion_source.h"
#include "live/scene_picture.h"

namespace thenar {

/// Moving scene with its inputs and its history. It shows the newest instant or one selected by
/// seek(). step() continues from the instant that is shown and erases all later ones. Not
/// thread-safe.
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

  /// Advances the simulation with the current inputs. Playback pauses after the step that reaches
  /// the duration of the scene. A step that is divided into parts reports progress and checks for a
  /// stop between them; a step that is stopped in this way is discarded.
  /// @throws InputError if the state is no longer finite; the last finite instant is then shown
  MotionQuality step(long count, const Progress& progress) override;
  /// Sets inputs; sets none if any is invalid. @throws InputError as MotionInputTable::set()
  void set(const MotionInputs& inputs) { inputs_.set(inputs, stepper_); }
  [[nodiscard]] std::vector<MotionInput> inputs() const { return inputs_.list(stepper_); }

  double seek(double t) override;
  /// Returns to the start, and clears all inputs and the history.
  void reset() override;
  [[nodiscard]] TimelineState state(const MotionParts& parts) const override;

  [[nodiscard]] const SceneInstant& shown_instant() const { return history_.instant(shown_).scene; }
  [[nodiscard]] bool is_newest() const { return shown_ + 1 == history_.size(); }
  [[nodiscard]] const MotionHistory& history() const { return history_; }
  [[nodiscard]] MotionQuality quality() const override;

 private:
  void record_instant();
  /// Returns true if the last step passed the duration of the scene.
  [[nodiscard]] bool passed_end() const;
  /// Sets the quality of the steps since the last call, and adds it to quality_.
  void collect_quality(MotionQuality& quality);
  /// Adds the energy balance and the limits that were exceeded. @param excess
  /// SceneCost::limit_excess
  void add_balance(const Eigen::VectorXd& excess, MotionQuality& quality) const;
  void start_history();
  /// Returns to the instant that is shown, after a step that failed.
  void restore_shown_instant();
  [[nodiscard]] std::vector<ContactSample> contacts() const;
  [[nodiscard]] std::vector<Pose<double>> poses() const;
  [[nodiscard]] std::vector<ElementValue> muscles() const;
  [[nodiscard]] Eigen::VectorXd tension() const;
  [[nodiscard]] MotionEnergy energy() const;
  void add_joints(TimelineState& out) const;
  void add_bodies(TimelineState& out) const;

  MotionSource source_;
  ScenePicture picture_;
  mutable SceneStepper stepper_;  // mutable: queries of poses and energies use its workspace
  MotionInputTable inputs_;
  MotionHistory history_;
  PastInstant new_record_;  // newest instant, a member to reuse its memory
  std::size_t shown_ = 0;   // entry of history_ that is shown
  SceneSample start_sample_;
  MotionQuality quality_;               // counts and maxima since the start
  Eigen::VectorXd limit_excess_;        // SceneCost::limit_excess since the start (joints)
  std::vector<ElementValue> readings_;  // names, units and initial values of all readings
  std::vector<std::size_t> tension_index_;
  std::vector<std::size_t> moving_bodies_;  // bodies: moving_bodies()
  unsigned long changes_ = 0;
};

}  // namespace thenar
