#pragma once

/// Common parts of all simulations with compliant contacts: time loop, samples, step limits.

#include <string>
#include <vector>

#include "base/progress.h"
#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar::internal {

/// Result of one integrator step.
struct CompliantStep {
  SceneStatus status = SceneStatus::kDone;  // kDone, kNotFinite or kFailed
  std::string message;                      // reason of kFailed
};

/// Contacts with a force at an instant.
struct CompliantContacts {
  std::vector<ContactSample> samples;
  double energy = 0;  // energy of their springs and of joint limits [J]
};

/// Scene that is advanced by one integrator.
class CompliantMotion {
 public:
  virtual ~CompliantMotion() = default;

  /// Restarts the integrator for a time span in which the forces and drives of its beginning act.
  /// @param instant  beginning of the span, the present time but for rounding [s]
  virtual void begin_span(double instant) = 0;
  /// Makes one step of the integrator, not beyond the time `stop` [s].
  [[nodiscard]] virtual CompliantStep step(double stop) = 0;
  /// Returns the present state.
  [[nodiscard]] virtual const SceneState& state() const = 0;
  /// Returns the contacts in the present state.
  [[nodiscard]] virtual CompliantContacts contacts() = 0;
  /// Returns the number of evaluations of the accelerations.
  [[nodiscard]] virtual long evaluations() const = 0;
  /// Returns the number of rejected steps: their error was too large, the Newton iteration did not
  /// converge, or surfaces moved too far.
  [[nodiscard]] virtual long rejected() const = 0;
};

/// Limit of the step length that keeps bodies from passing through each other.
class StepLimiter {
 public:
  /// @param longest  longest step [s]
  explicit StepLimiter(double longest) : longest_(longest), length_(longest) {}

  /// Sets the length of the next step [s].
  void set_length(double length) { length_ = length; }
  /// Returns the length of the next step [s].
  [[nodiscard]] double length() const { return length_; }

  /// Returns the motion of surfaces in a step, over half of the thinner body's thickness [1], and
  /// sets length() to half of the length that this motion allows.
  [[nodiscard]] double update(ContactStep& step, const SceneState& before, const SceneState& after);

 private:
  double longest_, length_;              // longest and next step [s]
  std::vector<ActiveContact> touching_;  // workspace: closed contacts
};

/// Runs a motion for the duration of its options, and records samples.
[[nodiscard]] SceneRun run_compliant(CompliantMotion& motion, const MovingScene& scene,
                                     const SceneOptions& options, const Progress& progress);

/// Checks that a scene suits compliant methods.
/// @throws InputError as check_scene(), check_scene_options() and check_compliance(), if a pair has
/// a coefficient of restitution (compliant contacts have a dissipation instead), or if the scene
/// has force elements.
void check_compliant(const MovingScene& scene, const SceneOptions& options);

}  // namespace thenar::internal
