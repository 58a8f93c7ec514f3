#pragma once

/// Findings of the demo, question by question: question, method and answer; each number is that of
/// the results.

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

/// Returns a page with a finding. @param figure  type of the block that represents it; "":
/// none
[[nodiscard]] SetPage page_for(const std::string& file, const std::string& title,
                               const Finding& finding, Json page, const char* figure);

/// Returns the finding about the accuracy of predicted forces.
[[nodiscard]] Finding force_finding(const std::vector<SpecimenStudy>& studies);
/// Returns the finding about the parameters of a finger that forces determine.
[[nodiscard]] Finding finger_finding(const std::vector<SpecimenStudy>& studies);
/// Returns the finding about the transfer of these parameters to other hands.
[[nodiscard]] Finding population_finding(const PopulationStudy& study);
/// Returns the finding about the uncertainty that remains after forces.
[[nodiscard]] Finding posterior_finding(const std::vector<DemoPosterior>& posteriors);
/// Returns the finding about one posterior. Its line is empty.
[[nodiscard]] Finding posterior_finding(const DemoPosterior& posterior);
/// Returns the finding about the best model of the extensor hood.
[[nodiscard]] Finding hood_finding(const DemoHood& hood);
/// Returns the finding about the cost of skewed axes for a thumb. @param page  its sections, whose
/// table has the sets
[[nodiscard]] Finding thumb_finding(const ThumbStudy& study, const Json& page);
/// Returns the finding about the recovery of a thumb from simulated data, and about the information
/// that measurements add.
[[nodiscard]] Finding thumb_recovery_finding(const ThumbRecoveryResult& result);
/// Returns the findings about a wine glass, about a thumb on a mug, and about the accuracy of
/// steps.
[[nodiscard]] Finding glass_finding(const SceneResult& glass);
[[nodiscard]] Finding thumb_mug_finding(const DemoMotion& motion);
[[nodiscard]] Finding stepping_finding(const std::vector<WorkPoint>& points);
/// Returns the finding about the comparison of hands in grasping.
[[nodiscard]] Finding hands_finding(const Comparison& comparison);
/// Returns the findings about a pad under an object, and about the cost of pad models.
[[nodiscard]] Finding pad_finding(const PressResult& pressed);
[[nodiscard]] Finding pencil_finding(const RungComparison& pencil);

}  // namespace thenar
