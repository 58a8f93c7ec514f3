#pragma once

/// A comparison of hands as sections of a report.

#include <memory>
#include <string>
#include <vector>

#include "api/compare.h"
#include "report/picture/hand_picture.h"

namespace thenar {

/// A hand as the page draws it.
struct ComparePicture {
  std::string hand;  // name of the hand in the comparison
  std::shared_ptr<const Hand> drawn;
  std::vector<SkinPatch> patches;
};

/// Returns sections "At a glance", "Grasps", "How good", "Best grasps", "Abilities", "How to read
/// this".
///
/// @param objects   those of the comparison, unscaled; others are not drawn
/// @param pictures  hands without one are not drawn
/// @param progress  hears of pictures; what a stop leaves is no page
[[nodiscard]] Json compare_page(const Comparison& comparison, const std::vector<BodySpec>& objects,
                                const std::vector<ComparePicture>& pictures, MeshTable& meshes,
                                const Progress& progress = {});

/// Returns the page of a comparison: the best grasps drawn, every number, and what the numbers
/// depend on.
/// @param progress  hears of pictures; what a stop leaves is no page
[[nodiscard]] Json page_of(const CompareResult& result, const Progress& progress = {});

/// Returns every hand by itself, with its joints where closing begins: a look at what is compared.
[[nodiscard]] Json hands_section(const std::vector<ComparePicture>& pictures, MeshTable& meshes);

}  // namespace thenar
