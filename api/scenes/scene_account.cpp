#include "api/scenes/scene_account.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/lists.h"
#include "base/units.h"

namespace thenar {
namespace {

constexpr double kWarnedPenetration = 1e-3;  // Penetration beyond which a warning is given [m]

}  // namespace

std::string energy_error_words(const FlowBalance& balance) {
  return fmt::format("{:.3g} mJ {} by {:.6g} s, {:.2g} % of {:.4g} mJ total energy exchanged",
                     1e3 * std::abs(balance.error),
                     balance.error < 0 ? "created" : "unaccounted for", balance.t,
                     100 * balance.relative_error(), 1e3 * balance.turned_over);
}

std::string beyond_words(const PassedLimit& limit) {
  return limit.slides ? fmt::format("{:.3g} mm", limit.excess / kMm)
                      : fmt::format("{:.3g} deg", limit.excess / kDegree);
}

std::vector<PassedLimit> limits_passed(const SceneResult& scene) {
  return passed_limits(scene.built->scene.mechanism, scene.run.cost.limit_excess);
}

double restitution_ignored(const SceneResult& scene) {
  const bool bounces = scene.built->options.method != SteppingMethod::kTimeStepping;
  return bounces ? 0 : max_restitution(scene.built->scene);
}

std::vector<std::string> scene_warnings(const SceneResult& scene) {
  // Warnings of building the scene and of its muscles come first.
  std::vector<std::string> warnings = scene.built->warnings;
  const std::vector<std::string>& pulls = scene.measures.pulls.warnings;
  append_all(warnings, pulls);
  // Then events without end, surfaces that moved too fast, penetration and limits.
  if (scene.run.cost.chatter_bursts > 0)
    warnings.push_back(
        fmt::format("events followed each other without end {} times: fixed steps continued by 1 "
                    "ms each time, without an estimate of their error",
                    scene.run.cost.chatter_bursts));
  if (scene.run.cost.tunnelling_steps > 0)
    warnings.push_back(
        fmt::format("in {} steps surfaces moved so fast that they may have gone through each other",
                    scene.run.cost.tunnelling_steps));
  if (scene.run.cost.max_penetration > kWarnedPenetration && has_contact_problems(scene))
    warnings.push_back(fmt::format(
        "surfaces were up to {:.3g} mm inside each other: forces there are not to be trusted, "
        "shorter steps may help",
        1e3 * scene.run.cost.max_penetration));
  for (const PassedLimit& limit : limits_passed(scene))
    warnings.push_back(
        fmt::format("joint '{}' went {} beyond its limit", limit.joint, beyond_words(limit)));
  // Fixed steps leave restitution out, which the material states.
  if (const double restitution = restitution_ignored(scene); restitution > 0)
    warnings.push_back(
        fmt::format("restitution of up to {:.3g} is left out: nothing bounces in steps of a fixed "
                    "length, events let it",
                    restitution));
  if (scene.run.cost.inaccurate_steps > 0)
    warnings.push_back(
        fmt::format("{} steps missed the tolerance, though they were as short as can be (1 ns)",
                    scene.run.cost.inaccurate_steps));
  return warnings;
}

std::string refusal_of(const SceneResult& scene) {
  const SceneCost& cost = scene.run.cost;
  // A motion that has failed is refused for that reason alone.
  if (scene.run.status == SceneStatus::kNotFinite)
    return fmt::format("the motion is not finite after {:.6g} s: do not use it",
                       scene.run.samples.back().t);
  if (scene.run.status == SceneStatus::kFailed)
    return fmt::format("{}: do not use this motion", scene.run.message);
  // Otherwise collect what makes it unreliable: energy that does not balance, or contacts that were
  // not solved.
  std::vector<std::string> reasons;
  if (scene.measures.worst && !scene.measures.worst->holds())
    reasons.push_back("energy does not balance, " + energy_error_words(*scene.measures.worst));
  if (cost.unsolved > 0)
    reasons.push_back(fmt::format(
        "{} of {} contact problems or force elements were not solved (worst residual {:.2g})",
        cost.unsolved, cost.substeps + cost.impacts, cost.worst_residual));
  if (reasons.empty()) return "";
  return fmt::format("{}: do not use this motion", fmt::join(reasons, "; "));
}

}  // namespace thenar
