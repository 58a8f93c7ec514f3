#include "grasp/compare/compare_hands.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include <fmt/format.h>

#include "base/error.h"
#include "data/io/world/world.h"
#include "grasp/compare/grasp_loads.h"
#include "grasp/compare/grasp_type.h"
#include "grasp/compare/opposition.h"
#include "grasp/compare/pregrasp.h"
#include "grasp/compare/tip_forces.h"
#include "grasp/compare/workspace.h"

namespace thenar {
namespace {

/// An object as hands approach it, with what is computed once for all hands.
struct Standing {
  Scene scene;
  double scale;
  double mass;  // [kg]
};

/// What is computed once for a hand and an object. The references must outlive it.
struct Setting {
  const ComparedHand& hand;
  const CollisionHand& collision_hand;
  const Scene& scene;
  double scale;
  double mass;  // [kg]
};

/// An approach and the epsilon that the hand's own efforts give it.
struct Tried {
  Grasp grasp;
  ExplainedLoad epsilon{std::numeric_limits<double>::quiet_NaN(), ""};  // of closures

  [[nodiscard]] bool closes() const {
    return grasp.outcome == GraspOutcome::kGrasped && grasp.quality.force_closure;
  }
};

Standing stand(const BodySpec& object, double scale, const Materials& materials) {
  // The object with its mass, alone in the world.
  PlacedBody placed;
  placed.body = scaled(object, scale);
  const BodyMass mass = body_mass(placed.body, materials);
  placed.body.mass = mass;
  return {{build_body(placed), {}, materials}, scale, mass.mass};
}

Grasp make_grasp(const Setting& setting, int number, const CompareOptions& options) {
  // Contact model and closing rates belong to the hand.
  GraspOptions grasping = options.grasp;
  grasping.pads.contact = setting.hand.contact;
  grasping.close.rates = setting.hand.rates;
  const Pregrasp pregrasp =
      sample_pregrasp(setting.collision_hand, setting.scene.object, options.seed, number);
  return attempt_grasp(setting.collision_hand, pregrasp, setting.scene, grasping);
}

HeldObject held_by(const Setting& setting, const Grasp& grasp) {
  return {*setting.hand.hand, grasp.closed.q, grasp.contacts,
          grasp.approached.X_WH.inverse() * setting.scene.object.X_WB};
}

Tried attempt_grasp(const Setting& setting, int number, const CompareOptions& options,
                    const Progress& progress) {
  Tried tried;
  tried.grasp = make_grasp(setting, number, options);
  if (tried.closes() && !progress.stop())
    tried.epsilon = hand_epsilon(held_by(setting, tried.grasp), setting.scene.object);
  return tried;
}

/// Every approach of a hand to an object, on all threads, in any order. Empty if stopped.
std::vector<Tried> all_grasps(const Setting& setting, const CompareOptions& options,
                              const Progress& progress) {
  std::vector<Tried> grasps(static_cast<std::size_t>(options.approaches));
  std::atomic<int> next{0}, finished{0};
  std::exception_ptr failure;
  std::mutex mutex;
  // Threads take the next number; the first error stops all of them.
  const auto work = [&](bool reports) {
    try {
      for (int n = next++; n < options.approaches && !progress.stop(); n = next++) {
        grasps[static_cast<std::size_t>(n)] = attempt_grasp(setting, n, options, progress);
        ++finished;
        if (reports) progress(static_cast<double>(finished) / options.approaches, "");
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
      next = options.approaches;
    }
  };
  // This thread works, too, and is the only one that reports.
  std::vector<std::thread> others;
  for (int t = 1; t < options.threads; ++t) others.emplace_back(work, false);
  work(true);
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
  if (finished < options.approaches) grasps.clear();
  return grasps;
}

BestGrasp describe(const Setting& setting, const Tried& tried, int number,
                   const CompareOptions& options) {
  const Grasp& grasp = tried.grasp;
  BestGrasp best;
  best.approach = number;
  best.X_WH = grasp.approached.X_WH;
  best.q = grasp.closed.q;
  best.contacts = grasp.contacts;
  best.epsilon = grasp.quality.lower;
  best.type = grasp_type(*setting.hand.hand, grasp.contacts);
  // Loads that the grasp resists, and reasons for zero or unknown ones.
  const GraspLoads loads =
      grasp_loads(held_by(setting, grasp), setting.scene.object, setting.mass, options.tasks);
  best.min_grasp_force = loads.min_grasp_force;
  best.standing_grasp_force = loads.standing_grasp_force;
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
           const CompareOptions& options, const Progress& progress) {
  // Count outcomes, and collect the epsilon of closures.
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
  // Closures sorted by epsilon.
  std::sort(closed.begin(), closed.end());
  cell.approaches = options.approaches;
  cell.closures = static_cast<int>(closed.size());
  cell.success = static_cast<double>(cell.closures) / options.approaches;
  cell.interval = wilson_interval(cell.closures, options.approaches);
  cell.epsilon = ascending(std::move(epsilon));
  cell.hand_epsilon = ascending(std::move(hand_epsilon));
  // Loads of the best ones, from the largest epsilon down.
  for (int i = 1; i <= std::min(options.best, cell.closures) && !progress.stop(); ++i) {
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

void require_numbers(const CompareOptions& options) {
  require(options.approaches > 0 && options.threads > 0 && options.best >= 0,
          "a comparison wants approaches and threads, got {} and {}", options.approaches,
          options.threads);
}

/// Lines like "human:skewed, human:soft: assumption": each warning once, with its hands.
std::vector<std::string> folded_warnings(const std::vector<ComparedHand>& hands) {
  std::vector<std::pair<std::string, std::string>> whose;  // warning, hands
  for (const ComparedHand& hand : hands)
    for (const std::string& warning : hand.warnings) {
      const auto found = std::find_if(whose.begin(), whose.end(),
                                      [&](const auto& each) { return each.first == warning; });
      if (found == whose.end())
        whose.emplace_back(warning, hand.name);
      else if (found->second != hand.name)
        found->second += ", " + hand.name;
    }
  std::vector<std::string> folded;
  folded.reserve(whose.size());
  for (const auto& [warning, names] : whose)
    folded.push_back(fmt::format("{}: {}", names, warning));
  return folded;
}

/// Refuses at once what would fail hours later, with the hand's name.
void require_hands(const std::vector<ComparedHand>& hands, const std::vector<BodySpec>& objects,
                   const Materials& materials) {
  for (const ComparedHand& hand : hands) {
    require(hand.hand != nullptr, "hand '{}' is not there", hand.name);
    require(!hand.hand->surfaces().empty(), "hand '{}' has no surface that could touch", hand.name);
    require(!hand.hand->layout().tip_points.empty(), "hand '{}' has no digits", hand.name);
    // Friction must be known for every pair of materials.
    try {
      for (const LinkSurface& surface : hand.hand->surfaces())
        for (const BodySpec& object : objects)
          (void)materials.between(surface.material, object.material);
    } catch (const InputError& error) {
      throw InputError(fmt::format("hand '{}': {}", hand.name, error.what()));
    }
  }
}

Comparison heading(const std::vector<ComparedHand>& hands, const std::vector<BodySpec>& objects,
                   const CompareOptions& options) {
  Comparison out;
  out.seed = options.seed;
  out.approaches = options.approaches;
  out.normalise_size = options.normalise_size;
  for (const ComparedHand& hand : hands) out.hands.push_back(hand.name);
  out.warnings = folded_warnings(hands);
  for (const BodySpec& object : objects) out.objects.push_back(object.name);
  for (const GraspTask task : options.tasks) out.tasks.push_back(name_of(task));
  require_names(out.hands, "hand");
  require_names(out.objects, "object");
  return out;
}

HandOnObject compare_cell(const Setting& setting, const CompareOptions& options,
                          const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  HandOnObject cell;
  cell.hand = setting.hand.name;
  cell.object = setting.scene.object.name;
  cell.scale = setting.scale;
  // A stopped cell is marked by zero approaches.
  const std::vector<Tried> grasps = all_grasps(setting, options, progress);
  if (grasps.empty()) return cell;
  count(cell, setting, grasps, options, progress);
  if (progress.stop()) cell.approaches = 0;
  cell.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return cell;
}

/// Objects, built when first asked for, once for each scale.
class Standings {
 public:
  explicit Standings(const Materials& materials) : materials_(materials) {}

  const Standing& of(const BodySpec& object, double scale) {
    const auto key = std::make_pair(object.name, scale);
    const auto known = built_.find(key);
    return known != built_.end()
               ? known->second
               : built_.emplace(key, stand(object, scale, materials_)).first->second;
  }

 private:
  const Materials& materials_;
  std::map<std::pair<std::string, double>, Standing> built_;
};

/// Progress of the cell after `finished` of `all` cells.
Progress of_cell(const Progress& whole, std::size_t finished, std::size_t all,
                 const std::string& what) {
  Progress cell = whole;
  cell.report = [&whole, finished, all, what](double share, const std::string&) {
    whole((static_cast<double>(finished) + share) / static_cast<double>(all), what);
  };
  return cell;
}

const HandOnObject* find_cell(const std::vector<HandOnObject>& cells, const std::string& hand,
                              const std::string& object) {
  for (const HandOnObject& cell : cells)
    if (cell.hand == hand && cell.object == object) return &cell;
  return nullptr;
}

Eigen::VectorXd middle_posture(const HandLayout& layout) {
  return (layout.lower + layout.upper) / 2;
}

/// Types of grasp that a hand has taken on any object, by name.
std::vector<std::string> grasp_types(const std::vector<HandOnObject>& cells,
                                     const std::string& hand) {
  std::set<std::string> types;
  for (const HandOnObject& cell : cells)
    if (cell.hand == hand)
      for (const auto& [type, times] : cell.types) types.insert(type);
  return {types.begin(), types.end()};
}

}  // namespace

HandAbilities hand_abilities(const ComparedHand& hand, const CompareOptions& options,
                             const Progress& progress) {
  std::mt19937 random(options.seed);
  HandAbilities abilities;
  abilities.hand = hand.name;
  abilities.reach = reach_of_digits(*hand.hand);
  // Workspaces first: all draws come from one generator, in a fixed order.
  Workspaces spaces =
      workspaces(*hand.hand, options.workspace_draws, options.workspace_voxel, random, progress);
  abilities.overlap = spaces.overlap;
  abilities.digits = std::move(spaces.digits);
  // Tip forces with all joints in the middle of their ranges.
  const Eigen::VectorXd q = middle_posture(hand.hand->layout());
  for (std::size_t tip = 0; tip < abilities.digits.size() && !progress.stop(); ++tip) {
    const TipForces forces = tip_forces(*hand.hand, q, static_cast<int>(tip));
    abilities.digits[tip].closing_force = forces.closing;
    abilities.digits[tip].max_tip_force = forces.largest;
  }
  const Opposition opposed = opposition(hand, random, progress);
  abilities.opposition = opposed.score;
  abilities.opposition_scale = opposed.scale;
  abilities.reached = opposed.reached;
  return abilities;
}

HandOnObject compare_on(const ComparedHand& hand, const BodySpec& object, double scale,
                        const CompareOptions& options, const Progress& progress) {
  require_numbers(options);
  require_hands({hand}, {object}, options.materials);
  const Standing standing = stand(object, scale, options.materials);
  const CollisionHand touching = collision_hand(*hand.hand, options.materials);
  return compare_cell({hand, touching, standing.scene, scale, standing.mass}, options, progress);
}

Comparison compare(const std::vector<ComparedHand>& hands, const std::vector<BodySpec>& objects,
                   const CompareOptions& options, const Progress& progress,
                   const std::vector<HandOnObject>& done) {
  require_numbers(options);
  Comparison out = heading(hands, objects, options);
  require_hands(hands, objects, options.materials);
  // Sizes are relative to the first hand.
  const double first_reach = reach_of_digits(*hands.front().hand);
  const std::size_t all = hands.size() * objects.size();
  Standings standings(options.materials);
  for (const ComparedHand& hand : hands) {
    if (progress.stop()) return out;
    const double scale = options.normalise_size ? reach_of_digits(*hand.hand) / first_reach : 1.0;
    const CollisionHand touching = collision_hand(*hand.hand, options.materials);
    for (const BodySpec& object : objects) {
      const Progress here =
          of_cell(progress, out.cells.size(), all, hand.name + " on " + object.name);
      // A cell of an earlier run is taken over.
      here(0, "");
      HandOnObject cell;
      if (const HandOnObject* known = find_cell(done, hand.name, object.name)) {
        cell = *known;
      } else {
        const Standing& standing = standings.of(object, scale);
        cell = compare_cell({hand, touching, standing.scene, scale, standing.mass}, options, here);
      }
      // Stopped: the unfinished cell is dropped.
      if (cell.approaches == 0) return out;
      out.cells.push_back(std::move(cell));
      if (options.keep) options.keep(out);
    }
    // Abilities of the hand without an object.
    HandAbilities abilities = hand_abilities(hand, options, progress);
    if (progress.stop()) return out;
    out.abilities.push_back(std::move(abilities));
    out.abilities.back().types = grasp_types(out.cells, hand.name);
  }
  progress(1, "compared");
  out.complete = true;
  return out;
}

}  // namespace thenar
