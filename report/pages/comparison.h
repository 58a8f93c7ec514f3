#pragma once

/// Comparison of hands as sections of a report.

#include <memory>
#include <string>
#include <vector>

#include "api/compare.h"
#include "report/picture/hand_picture.h"

namespace thenar {

/// Hand drawn on the page.
struct ComparePicture {
  std::string hand;  // name of the hand in the comparison
  std::shared_ptr<const Hand> drawn;
  std::vector<SkinPatch> patches;
};

/// Returns the sections "At a glance", "Grasps", "How good", "Best grasps", "Abilities", "How to
/// read this".
///
/// @param objects   unscaled objects of the comparison; others are not drawn
/// @param pictures  hands without one are not drawn
/// @param progress  reports each picture; after a stop the page is incomplete
[[nodiscard]] Json compare_page(const Comparison& comparison, const std::vector<BodySpec>& objects,
                                const std::vector<ComparePicture>& pictures, MeshTable& meshes,
                                const Progress& progress = {});

/// Returns the page of a comparison: the best grasps drawn, every number, and what the numbers
/// depend on.
/// @param progress  reports each picture; after a stop the page is incomplete
[[nodiscard]] Json page_of(const CompareResult& result, const Progress& progress = {});

/// Returns a section with a picture of every hand at the start of closing.
[[nodiscard]] Json hands_section(const std::vector<ComparePicture>& pictures, MeshTable& meshes);

}  // namespace thenar
