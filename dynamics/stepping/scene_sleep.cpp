#include "dynamics/stepping/scene_sleep.h"

#include "base/lists.h"

namespace thenar {
namespace {

constexpr double kStillSpeed = 1e-11;  // largest speed at rest [m/s], [rad/s]

/// Returns true if an active drive has a moving target.
bool drives_move(const MovingScene& scene, double t) {
  return any_of(scene.drives, [&](const SceneDrive& drive) {
    return drive.when.contains(t) && drive_target(drive, t, t).speed != 0;
  });
}

}  // namespace

bool is_still(const SceneState& state) {
  return state.v.size() == 0 || state.v.cwiseAbs().maxCoeff() <= kStillSpeed;
}

void SceneSleep::observe_step(ContactStep& step, bool was_still, bool slides, double gap,
                              double touch, SceneState& state) {
  // Count a step at rest: still before and after, no contact slides or closes, nothing starts
  // motion.
  if (was_still && is_still(state) && !slides && gap < touch &&
      !drives_move(step.scene(), state.t) && !step.elements_may_start_motion(state)) {
    state.v.setZero();
    ++steps_;
  } else {
    steps_ = 0;
  }
}

}  // namespace thenar
