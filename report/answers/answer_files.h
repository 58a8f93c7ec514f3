#pragma once

/// Input files of a result, for its record: `thenar rerun` names those that have changed.

#include <type_traits>
#include <vector>

#include "api/close.h"
#include "api/compare.h"
#include "api/explain.h"
#include "api/feasible_force.h"
#include "api/grasp.h"
#include "api/import.h"
#include "api/moment_arms.h"
#include "api/pose.h"
#include "api/posterior.h"
#include "api/quality.h"
#include "api/scenes/simulate_scene.h"
#include "api/simulate.h"
#include "api/tendon_infer.h"
#include "api/tendon_solve.h"
#include "api/tip_force.h"
#include "api/validate.h"
#include "base/provenance.h"

namespace thenar {

/// Returns path -> SHA-256 of each file that was read for a result, including meshes of robots and
/// objects; for input results (.h5, .nc), of the file itself.
template <typename Result>
[[nodiscard]] auto files_of(const Result& result) -> decltype(source_digests(result.sources)) {
  return source_digests(result.sources);
}
template <typename Result>
[[nodiscard]] auto files_of(const Result& result)
    -> std::enable_if_t<std::is_same_v<decltype(result.files), FileDigests>, FileDigests> {
  return result.files;
}
[[nodiscard]] FileDigests files_of(const GraspResult& result);
[[nodiscard]] FileDigests files_of(const CloseResult& result);
[[nodiscard]] FileDigests files_of(const ThingExplained& explained);
[[nodiscard]] FileDigests files_of(const Validation& validation);
[[nodiscard]] FileDigests files_of(const Imported& imported);
[[nodiscard]] FileDigests files_of(const ContactQualityResult& result);
[[nodiscard]] FileDigests files_of(const std::vector<ContactQualityResult>& results);
[[nodiscard]] FileDigests files_of(const SceneResult& scene);
[[nodiscard]] FileDigests files_of(const TendonSolveResult& solution);
[[nodiscard]] FileDigests files_of(const TendonSweepResult& sweep);
[[nodiscard]] FileDigests files_of(const FitResult& result);
[[nodiscard]] FileDigests files_of(const PredictResult& result);
[[nodiscard]] FileDigests files_of(const PosteriorPrediction& result);

}  // namespace thenar
