#include "grasp/compare/compare.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <set>
#include <thread>

#include <fmt/format.h>

#include "base/error.h"
#include "data/io/world/body_mass.h"
#include "grasp/compare/abilities.h"
#include "grasp/compare/centre.h"
#include "grasp/compare/grasp_loads.h"
#include "grasp/compare/grasp_type.h"
#include "grasp/draw_start.h"

namespace thenar {
namespace {

/// What is worked out once for a hand and an object.
struct Setting {
  const ComparedHand& hand;
  TouchingHand touching;
  Scene scene;
  double mass;  // [kg]
};

/// An approach and what the hand's own efforts make of it.
struct Tried {
  Grasp grasp;
  Limited epsilon{std::numeric_limits<double>::quiet_NaN(), ""};  // of closures

  [[nodiscard]] BestGrasp describe(const Setting& setting, const Tried& tried, int number,
                   const CompareOptions& options) {
  const Grasp& grasp = tried.grasp;
  BestGrasp best;
  best.approach = number;
  best.X_WH = grasp.approached.X_WH;
  best.q = grasp.closed.q;
  best.contacts = grasp.contacts;
  best.epsilon = grasp.quality.lower;
  best.type = grasp_type(*setting.hand.hand, grasp.contacts);
  const GraspLoads loads =
      grasp_loads(held_by(setting, grasp), setting.scene.object, setting.mass, options.tasks);
  best.hold = loads.hold;
  best.margin = loads.margin;
  best.reasons = loads.reasons;
  best.hand_epsilon = tried.epsilon.value;
  if (!tried.epsilon.reason.empty()) best.reasons["epsilon"] = tried.epsilon.reason;
  return best;
}

Eigen::VectorXd ascending(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void count(HandOnObject& cell, const Setting& setting, const std::vector<Tried>& grasps,
           const CompareOptions& options) {
  std::vector<std::pair<double, int>> closed;
  std::vector<double> epsilon, hand_epsilon;
  for (std::size_t n = 0; n < grasps.size(); ++n) {
    const Tried& tried = grasps[n];
    ++cell.outcomes[static_cast<std::size_t>(tried.grasp.outcome)];
    if (!tried.closes()) continue;
    closed.emplace_back(tried.grasp.quality.lower, static_cast<int>(n));
    epsilon.push_back(tried.grasp.quality.lower);
    if (!std::isnan(tried.epsilon.value)) hand_epsilon.push_back(tried.epsilon.value);
    ++cell.types[grasp_type(*setting.hand.hand, tried.grasp.contacts)];
  }
  std::sort(closed.begin(), closed.end());
  cell.approaches = options.approaches;
  cell.closures = static_cast<int>(closed.size());
  cell.success = static_cast<double>(cell.closures) / options.approaches;
  cell.interval = wilson_interval(cell.closures, options.approaches);
  cell.epsilon = ascending(std::move(epsilon));
  cell.hand_epsilon = ascending(std::move(hand_epsilon));
  for (int i = 1; i <= std::min(options.best, cell.closures); ++i) {
    const int number = closed[static_cast<std::size_t>(cell.closures - i)].second;
    cell.best.push_back(
        describe(setting, grasps[static_cast<std::size_t>(number)], number, options));
  }
}

void require_names(const std::vector<std::string>& names, const std::string& what) {
  require(!names.empty(), "there is no {} to compare", what);
  std::set<std::string> seen;
  for (const std::string& name : names)
    require(seen.insert(name).second, "{} '{}' is named twice", what, name);
}

Comparison heading(const std::vector<ComparedHand>& hands, const std::vector<BodySpec>& objects,
                   const CompareOptions& options) {
  Comparison out;
  out.seed = options.seed;
  out.approaches = options.approaches;
  out.normalise_size = options.normalise_size;
  for (const ComparedHand& hand : hands) {
    out.hands.push_back(hand.name);
    for (const std::string& warning : hand.warnings)
      out.warnings.push_back(hand.name + ": " + warning);
  }
  for (const BodySpec& object : objects) out.objects.push_back(object.name);
  for (const GraspTask task : options.tasks) out.tasks.push_back(name_of(task));
  require_names(out.hands, "hand");
  require_names(out.objects, "object");
  return out;
}

}  // namespace

HandOnObject compare_on(const ComparedHand& hand, const BodySpec& object, double scale,
                        const CompareOptions& options, const Progress& progress) {
  require(options.approaches > 0 && options.threads > 0 && options.best >= 0,
          "a comparison wants approaches and threads, got {} and {}", options.approaches,
          options.threads);
  const auto start = std::chrono::steady_clock::now();
  const Setting setting = set_up(hand, object, scale);
  HandOnObject cell;
  cell.hand = hand.name;
  cell.object = object.name;
  cell.scale = scale;
  const std::vector<Tried> grasps = all_grasps(setting, options, progress);
  if (grasps.empty()) return cell;
  count(cell, setting, grasps, options);
  cell.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return cell;
}

Comparison compare(const std::vector<ComparedHand>& hands, const std::vector<BodySpec>& objects,
                   const CompareOptions& options, const Progress& progress,
                   const std::vector<HandOnObject>& done) {
  Comparison out = heading(hands, objects, options);
  const double first_reach = reach_of_digits(*hands.front().hand);
  const double all = static_cast<double>(hands.size() * objects.size());
  for (const ComparedHand& hand : hands) {
    const double scale = options.normalise_size ? reach_of_digits(*hand.hand) / first_reach : 1.0;
    std::set<std::string> types;
    for (const BodySpec& object : objects) {
      progress(static_cast<double>(out.cells.size()) / all, hand.name + " on " + object.name);
      const auto known = std::find_if(done.begin(), done.end(), [&](const HandOnObject& cell) {
        return cell.hand == hand.name && cell.object == object.name;
      });
      HandOnObject cell =
          known != done.end() ? *known : compare_on(hand, object, scale, options, progress);
      if (cell.approaches == 0) return out;
      for (const auto& [type, times] : cell.types) types.insert(type);
      out.cells.push_back(std::move(cell));
      if (options.keep) options.keep(out);
    }
    out.abilities.push_back(hand_abilities(hand, options));
    out.abilities.back().types.assign(types.begin(), types.end());
  }
  progress(1, "compared");
  out.complete = true;
  return out;
}

}  // namespace thenar
