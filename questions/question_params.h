#pragma once

/// Parameters of questions whose commands also write files or combine several questions.

#include "api/compare.h"
#include "api/fit.h"
#include "api/grasp.h"
#include "api/posterior.h"
#include "api/quality.h"
#include "api/scenes/simulate_scene.h"
#include "api/simulate.h"
#include "questions/request_table.h"

namespace thenar {

[[nodiscard]] RequestTable<ContactQualityRequest> contact_params();
[[nodiscard]] RequestTable<WorldRequest> world_params();
[[nodiscard]] RequestTable<GraspRequest> grasp_params();
[[nodiscard]] RequestTable<CompareRequest> compare_params();
[[nodiscard]] RequestTable<FitRequest> fit_params();
[[nodiscard]] RequestTable<SampleRequest> posterior_params();
[[nodiscard]] RequestTable<DigitMotionRequest> digit_motion_params();
[[nodiscard]] RequestTable<SceneRequest> scene_params();
/// Returns scene_params() and the parameters of a sweep.
[[nodiscard]] RequestTable<SceneRequest> scene_sweep_params();

}  // namespace thenar
