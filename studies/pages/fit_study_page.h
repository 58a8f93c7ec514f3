#pragma once

/// Sections of a page about specimens fitted by every solver and cross-validated.

#include <vector>

#include "report/picture/mesh_table.h"
#include "studies/questions/fit_study.h"

namespace thenar {

/// Returns the first section: relative errors of all methods on all experiments.
[[nodiscard]] Json accuracy_page(const std::vector<SpecimenStudy>& studies);

/// Returns a section about every solver: final cost, error, time; and a chart.
[[nodiscard]] Json solver_page(const std::vector<SpecimenStudy>& studies);

/// Returns a section with measured and predicted force vectors, in sample and left out.
[[nodiscard]] Json force_page(const std::vector<SpecimenStudy>& studies);

/// Returns the page about parameters: what the data determine, and what they cannot.
[[nodiscard]] Json parameter_page(const std::vector<SpecimenStudy>& studies);

/// Returns a section about several specimens as one population, and about unseen specimens.
[[nodiscard]] Json population_page(const PopulationStudy& study,
                                   const std::vector<SpecimenStudy>& studies);

/// Returns a section with the fitted finger in 3D, its axes before and after the fit. @param meshes
/// receives the meshes of its skin
[[nodiscard]] Json finger_page(const std::vector<SpecimenStudy>& studies, MeshTable& meshes);

}  // namespace thenar
