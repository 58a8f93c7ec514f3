#pragma once

/// The page of a fit, and its parts.

#include <string>

#include "api/fit.h"
#include "report/picture/mesh_table.h"

namespace thenar {

/// Returns the page of a fit: how it ended, errors in sample and left out, forces, what the data
/// tell of each parameter, what the prior alone decides, and the digit in space.
[[nodiscard]] Json page_of(const FitResult& result);

/// Returns intervals of the coordinates that the data tell most about, and of four that they tell
/// least about, in prior sds. @param shown  rows of the former
[[nodiscard]] Json learnt_forest(const Fit& fit, const std::string& whose, std::size_t shown = 24);

/// Returns directions along which no measured force changes.
[[nodiscard]] Json open_directions(const Fit& fit, const std::string& whose);

/// Returns bones, axes and tendons of a specimen before and after the fit, in the first posture of
/// its experiments, within the subject's skin where the digit has the subject's size.
/// @param specimen  index in fit.problem.specimens()
/// @param meshes    gets those of the skin
[[nodiscard]] Json fitted_scene(const Fit& fit, int specimen, MeshTable& meshes);

/// Returns the meaning of the names of moving parameters, for the text of a section; kinds that do
/// not occur are left out.
[[nodiscard]] std::string name_rules(const Fit& fit);

}  // namespace thenar
