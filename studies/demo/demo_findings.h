#pragma once

/// What the demo asked, did and learnt, question by question; each number is that of the results.

#include <string>
#include <vector>

#include "api/compare.h"
#include "api/pads/press_pad.h"
#include "api/scenes/compare_rungs.h"
#include "studies/demo/page_set.h"
#include "studies/questions/demo.h"

namespace thenar {

/// An answer, as the first paragraph of its page and as a line of the summary.
struct Finding {
  Opening opening;
  std::string line;
};

/// How well forces are predicted.
[[nodiscard]] Finding force_finding(const std::vector<SpecimenStudy>& studies);
/// What forces tell of a finger.
[[nodiscard]] Finding finger_finding(const std::vector<SpecimenStudy>& studies);
/// Whether that carries to other hands.
[[nodiscard]] Finding population_finding(const PopulationStudy& study);
/// How sure the forces make us.
[[nodiscard]] Finding posterior_finding(const std::vector<DemoPosterior>& posteriors);
/// Of one of them. Its line is empty.
[[nodiscard]] Finding posterior_finding(const DemoPosterior& posterior);
/// How the extensor hood should be modelled.
[[nodiscard]] Finding hood_finding(const DemoHood& hood);
/// What skewed axes cost a thumb. @param page  its sections, whose table has the sets
[[nodiscard]] Finding thumb_finding(const ThumbStudy& study, const Json& page);
/// Whether a thumb is found again from made-up data, and what measurements add.
[[nodiscard]] Finding thumb_recovery_finding(const ThumbRecoveryResult& result);
/// What becomes of a wine glass, of a thumb on a mug, and how accurate steps are.
[[nodiscard]] Finding glass_finding(const SimulatedScene& glass);
[[nodiscard]] Finding thumb_mug_finding(const DemoMotion& motion);
[[nodiscard]] Finding stepping_finding(const std::vector<WorkPoint>& points);
/// How hands compare in grasping.
[[nodiscard]] Finding hands_finding(const Comparison& comparison);
/// What a pad does under an object, and what models of it cost.
[[nodiscard]] Finding pad_finding(const PressedPad& pressed);
[[nodiscard]] Finding pencil_finding(const RungComparison& pencil);

}  // namespace thenar
