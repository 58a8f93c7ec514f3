#include "apps/grasp_answer.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/progress_parts.h"
#include "grasp/contact/friction_pyramid.h"
#include "report/answers/grasp_words.h"

namespace thenar {
namespace {

/// Grasps before those that are none, and the better ones of them first.
bool is_better(const Grasp& a, const Grasp& b) {
  const bool has = a.outcome == GraspOutcome::kGrasped, had = b.outcome == GraspOutcome::kGrasped;
  return has != had ? has : has && a.quality.lower > b.quality.lower;
}

GraspOptions options_of(const GraspQuestion& question) {
  GraspOptions options;
  options.pads.contact = question.hand.named.contact;
  options.epsilon.limit = question.limit;
  options.epsilon.gap = question.gap;
  options.close.rates = question.hand.named.rates;
  return options;
}

/// One start, measured as was asked.
Grasp grasp_from(const GraspQuestion& question, const CollisionHand& touching,
                 const Pregrasp& start) {
  const GraspOptions options = options_of(question);
  GraspOptions here = options;
  here.way = 0;
  Grasp found = start.way > 0 ? attempt_grasp(touching, start, question.scene, options)
                              : grasp(touching, start.X_WH, start.q, question.scene, here);
  if (question.edges > 0 && found.outcome == GraspOutcome::kGrasped)
    found.quality = epsilon(wrenches_of(question, found.contacts), options.epsilon);
  return found;
}

/// Counts a start, and keeps it if it is the best so far.
void note(GraspAnswer& found, Grasp grasp, int number, const Pregrasp& start) {
  ++found.outcomes[static_cast<std::size_t>(grasp.outcome)];
  found.closures += grasp.outcome == GraspOutcome::kGrasped && grasp.quality.force_closure ? 1 : 0;
  if (number > 0 && !is_better(grasp, found.grasp)) return;
  found.grasp = std::move(grasp);
  found.best = number;
  found.start = start;
}

}  // namespace

WrenchSet wrenches_of(const GraspQuestion& question, const std::vector<HandContact>& contacts) {
  const SceneBody& object = question.scene.object;
  const WrenchSet set = wrench_set(contacts_without_hand(contacts), object.com, object.reach);
  return question.edges > 0 ? pyramids(set, question.edges) : set;
}

GraspAnswer answer(const GraspQuestion& question, const CollisionHand& touching, double way,
                   const Progress& progress) {
  GraspAnswer found;
  if (question.starts == 0) {
    report_or_stop(progress, 0, "closing the hand");
    const Pregrasp own{question.hand.X_WH, question.hand.q, way};
    note(found, grasp_from(question, touching, own), -1, own);
  }
  for (int i = 0; i < question.starts && (i == 0 || !progress.stop()); ++i) {
    report_or_stop(progress, static_cast<double>(i) / question.starts,
                   fmt::format("start {} of {}", i + 1, question.starts));
    const Pregrasp drawn = sample_pregrasp(touching, question.scene.object, question.seed, i);
    note(found, grasp_from(question, touching, drawn), i, drawn);
  }
  found.wrenches = wrenches_of(question, found.grasp.contacts);
  return found;
}

Grasp regrasp(const GraspQuestion& question, const CollisionHand& touching,
              const GraspAnswer& answer, const Scene& scene) {
  return attempt_grasp(touching, answer.start, scene, options_of(question));
}

double cpu_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

namespace {

/// Whether a hand with a thumb holds the object without it.
bool thumb_is_idle(const GraspQuestion& question, const Grasp& grasp) {
  const Hand& hand = *question.hand.named.hand;
  const std::vector<std::string>& tips = hand.layout().tips;
  if (grasp.outcome != GraspOutcome::kGrasped ||
      std::find(tips.begin(), tips.end(), "thumb") == tips.end())
    return false;
  return std::none_of(
      grasp.contacts.begin(), grasp.contacts.end(), [&](const HandContact& contact) {
        return hand.surfaces()[static_cast<std::size_t>(contact.surface)].digit == "thumb";
      });
}

}  // namespace

std::vector<std::string> warnings_of(const GraspQuestion& question, const GraspAnswer& answer) {
  std::vector<std::string> warnings = question.hand.named.warnings;
  const std::string own = own_overlap_words(answer.grasp.closed);
  if (!own.empty()) warnings.insert(warnings.begin(), own);
  if (thumb_is_idle(question, answer.grasp))
    warnings.emplace_back("the thumb touches nothing: fingers hold the object against the palm");
  return warnings;
}

std::string explanation(const GraspQuestion& question, const GraspAnswer& answer) {
  const std::string words = outcome_words(answer.grasp);
  if (answer.grasp.outcome != GraspOutcome::kEmpty || answer.start.way > 0) return words;
  return words + (question.hand.parts.size() > 1
                      ? "; it stays where what carries it stands: other angles of the arm may help"
                      : "; it closed where it stands: `thenar grasp` goes at the object first");
}

}  // namespace thenar
