#pragma once

/// The page of a fit, and its parts.

#include <string>

#include "api/fit.h"
#include "report/picture/mesh_table.h"

namespace thenar {

/// Returns the page of a fit: status, errors in sample and left out, forces, information on each
/// parameter, directions that the prior alone determines, and the digit in space.
[[nodiscard]] Json page_of(const FitResult& result);

/// Returns a chart of the intervals of the best-determined coordinates, and of the four
/// worst-determined ones, in prior sds. @param shown  number of the former
[[nodiscard]] Json learnt_forest(const Fit& fit, const std::string& whose, std::size_t shown = 24);

/// Returns a block about the directions along which no measured force changes.
[[nodiscard]] Json open_directions(const Fit& fit, const std::string& whose);

/// Returns a scene with bones, axes and tendons of a specimen before and after the fit, in the
/// first posture of its experiments, within the subject's skin where the digit has the subject's
/// size.
/// @param specimen  index in fit.problem.specimens()
/// @param meshes    receives the meshes of the skin
[[nodiscard]] Json fitted_scene(const Fit& fit, int specimen, MeshTable& meshes);

/// Returns the meanings of the names of free parameters, for the text of a section; kinds that do
/// not occur are left out.
[[nodiscard]] std::string name_rules(const Fit& fit);

}  // namespace thenar
