#pragma once

/// What came of a grasp, from one start or the best of many.

#include <array>
#include <ctime>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "apps/grasp_question.h"
#include "base/progress.h"
#include "grasp/compare/pregrasp.h"

namespace thenar {

/// In the order of GraspAnswer::outcomes.
inline constexpr std::array<GraspOutcome, 6> kOutcomes{
    GraspOutcome::kGrasped, GraspOutcome::kOverlaps, GraspOutcome::kMissed,
    GraspOutcome::kBlocked, GraspOutcome::kTooLong,  GraspOutcome::kEmpty};

struct GraspMeasures;
struct GraspRobustness;

/// What came of it.
struct GraspAnswer {
  Grasp grasp;                                        // the best of all starts
  WrenchSet wrenches;                                 // of its contacts, as measured
  std::array<int, 6> outcomes{};                      // of all starts, by GraspOutcome
  int closures = 0;                                   // starts that ended in force closure
  int best = -1;                                      // its start; -1: none was drawn
  Pregrasp start;                                     // where the best began
  double cpu = 0;                                     // of all, measures included [s]
  std::shared_ptr<const GraspMeasures> measures;      // const, so shared by copies; null: no grasp
  std::shared_ptr<const GraspRobustness> robustness;  // the same; null: not asked

  [[nodiscard]] int started() const { return std::accumulate(outcomes.begin(), outcomes.end(), 0); }
};

/// Starts, and keeps the best. Start n of several is sample_pregrasp() n, as in `thenar compare`,
/// and the object yields to jaws as in centred_grasp(); so it does where the world's own hand goes
/// at it.
/// @param way  farthest approach from the world's own start [m]; 0: the hand stays there
/// Where progress says stop it is the best of the starts until then.
/// @throws Stopped where that is before the first
[[nodiscard]] GraspAnswer answer(const GraspQuestion& question, const CollisionHand& touching,
                                 double way, const Progress& progress = {});

/// The grasp of an answer once more, in a scene that is a little different; the object yields to
/// jaws as in centred_grasp(), also where the hand stays.
[[nodiscard]] Grasp regrasp(const GraspQuestion& question, const CollisionHand& touching,
                            const GraspAnswer& answer, const Scene& scene);

/// Processor time from then on [s].
[[nodiscard]] double cpu_since(std::clock_t start);

/// What was assumed of the hand, and links of it that begin in each other.
[[nodiscard]] std::vector<std::string> warnings_of(const GraspQuestion& question,
                                                   const GraspAnswer& answer);

/// outcome_words(), and what to do where a hand closed on nothing because it stayed where it is.
[[nodiscard]] std::string explanation(const GraspQuestion& question, const GraspAnswer& answer);

/// The contacts' wrenches, with cones or pyramids.
[[nodiscard]] WrenchSet wrenches_of(const GraspQuestion& question,
                                    const std::vector<HandContact>& contacts);

}  // namespace thenar
