#pragma once

/// What all runs with compliant contacts have in common: samples, spans of forces, how they end.

#include <string>
#include <vector>

#include "base/progress.h"
#include "dynamics/stepping/simulate_scene.h"

namespace thenar::internal {

/// How a step of an integrator ended.
struct CompliantStep {
  SceneStatus status = SceneStatus::kDone;  // kDone, kNotFinite, kFailed
  std::string reason;                       // of kFailed
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
  /// Slopes that were asked for.
  [[nodiscard]] virtual long slopes() const = 0;
};

/// Runs a motion to the end of its options, keeping samples.
[[nodiscard]] SceneRun run_compliant(CompliantMotion& motion, const MovingScene& scene,
                                     const SceneOptions& options, const Progress& progress);

/// Checks what all compliant methods ask of a scene.
/// @throws InputError as check_scene(), check_scene_options() and check_compliance(), or if a pair
/// has a restitution: bounces follow from the dissipation.
void check_compliant(const MovingScene& scene, const SceneOptions& options);

}  // namespace thenar::internal
