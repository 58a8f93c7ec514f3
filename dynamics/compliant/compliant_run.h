#pragma once

/// Common parts of all runs with compliant contacts: samples, spans of forces, endings.

#include <string>
#include <vector>

#include "base/progress.h"
#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar::internal {

/// Result of a step of an integrator.
struct CompliantStep {
  SceneStatus status = SceneStatus::kDone;  // kDone, kNotFinite, kFailed
  std::string message;                      // what went wrong, where the status is kFailed
};

/// A scene on its way by one integrator.
class CompliantMotion {
 public:
  virtual ~CompliantMotion() = default;

  /// Forces and drives act as at an instant from now on; the integrator starts anew.
  /// @param instant  present, but for rounding [s]
  virtual void begin_span(double instant) = 0;
  /// One step of the integrator, not beyond `stop` [s].
  [[nodiscard]] virtual CompliantStep step(double stop) = 0;
  /// Present state.
  [[nodiscard]] virtual const SceneState& state() const = 0;
  /// Contacts that have a force at present. @param stored  energy of their springs and of stops [J]
  [[nodiscard]] virtual std::vector<ContactSample> contacts(double& stored) = 0;
  /// Accelerations that were computed.
  [[nodiscard]] virtual long evaluations() const = 0;
  /// Steps that were made in vain: their error was too large, Newton's steps did not converge, or
  /// surfaces moved too far.
  [[nodiscard]] virtual long rejected() const = 0;
};

/// Limits the length of steps so that bodies do not pass through each other.
class StepReach {
 public:
  /// @param longest  step [s]
  explicit StepReach(double longest) : longest_(longest), length_(longest) {}

  void restart(double length) { length_ = length; }
  /// Returns the length of the next step [s].
  [[nodiscard]] double length() const { return length_; }

  /// Computes the motion of surfaces in a step, over half of the thinner body's thickness [1];
  /// length() is then half of the length that this motion allows.
  [[nodiscard]] double follow(ContactStep& step, const SceneState& before, const SceneState& after);

 private:
  double longest_, length_;  // [s]
  std::vector<ActiveContact> touching_;
};

/// Runs a motion to the end of its options, keeping samples.
[[nodiscard]] SceneRun run_compliant(CompliantMotion& motion, const MovingScene& scene,
                                     const SceneOptions& options, const Progress& progress);

/// Checks what all compliant methods ask of a scene.
/// @throws InputError as check_scene(), check_scene_options() and check_compliance(), if a pair has
/// a restitution (bounces follow from the dissipation), or if the scene has force elements.
void check_compliant(const MovingScene& scene, const SceneOptions& options);

}  // namespace thenar::internal
