#pragma once

/// Parameters of the questions whose commands do more than ask: they write files, or take several
/// questions.

#include "api/compare.h"
#include "api/fit.h"
#include "api/grasp.h"
#include "api/posterior.h"
#include "questions/request_table.h"

namespace thenar {

[[nodiscard]] RequestTable<WorldRequest> world_params();
[[nodiscard]] RequestTable<GraspRequest> grasp_params();
[[nodiscard]] RequestTable<CompareRequest> compare_params();
[[nodiscard]] RequestTable<FitRequest> fit_params();
[[nodiscard]] RequestTable<SampleRequest> posterior_params();

}  // namespace thenar
