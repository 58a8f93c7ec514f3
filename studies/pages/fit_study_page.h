#pragma once

/// Specimens that every solver fitted and that were cross-validated, as sections of a page.

#include <vector>

#include "report/picture/mesh_table.h"
#include "studies/questions/fit_study.h"

namespace thenar {

/// Returns relative errors of everything beside everything: the first section.
[[nodiscard]] Json accuracy_page(const std::vector<SpecimenStudy>& studies);

/// Returns every solver: cost reached, error, time; and both on one chart.
[[nodiscard]] Json solver_page(const std::vector<SpecimenStudy>& studies);

/// Returns measured against predicted force vectors, in sample and left out.
[[nodiscard]] Json force_page(const std::vector<SpecimenStudy>& studies);

/// Returns the page about parameters: what the data determine, and what they cannot.
[[nodiscard]] Json parameter_page(const std::vector<SpecimenStudy>& studies);

/// Returns several specimens as one population, and specimens that it has not seen.
[[nodiscard]] Json population_page(const PopulationStudy& study,
                                   const std::vector<SpecimenStudy>& studies);

/// Returns the fitted finger in 3D, its axes before and after. @param meshes  gets those of its
/// skin
[[nodiscard]] Json finger_page(const std::vector<SpecimenStudy>& studies, MeshTable& meshes);

}  // namespace thenar
