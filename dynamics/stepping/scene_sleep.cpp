#include "dynamics/stepping/scene_sleep.h"

#include <algorithm>

namespace thenar {
namespace {

constexpr double kStillSpeed = 1e-11;  // Slower is at rest [m/s], [rad/s]

/// Returns whether some drive has a target that moves.
bool drives_move(const MovingScene& scene, double t) {
  return std::any_of(scene.drives.begin(), scene.drives.end(), [&](const SceneDrive& drive) {
    return drive.when.holds(t) && drive_target(drive, t, t).speed != 0;
  });
}

}  // namespace

bool is_still(const SceneState& state) {
  return state.v.size() == 0 || state.v.cwiseAbs().maxCoeff() <= kStillSpeed;
}

void SceneSleep::observe(ContactStep& step, bool was_still, bool slides, double gap, double touch,
                         SceneState& state) {
  // Rest: still before and after, and nothing slides, closes or moves by itself.
  if (was_still && is_still(state) && !slides && gap < touch &&
      !drives_move(step.scene(), state.t) && !step.elements_move(state)) {
    state.v.setZero();
    ++steps_;
  } else {
    steps_ = 0;
  }
}

}  // namespace thenar
