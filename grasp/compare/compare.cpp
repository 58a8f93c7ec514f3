#include "grasp/compare/compare.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
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

enum class Stream { kStart, kPosture };

/// A generator of one approach: std::seed_seq gives every machine the same.
std::mt19937 generator(unsigned seed, const std::string& object, int number, Stream stream) {
  std::vector<unsigned> words{seed, static_cast<unsigned>(number), static_cast<unsigned>(stream)};
  for (const char letter : object) words.push_back(static_cast<unsigned char>(letter));
  std::seed_seq sequence(words.begin(), words.end());
  return std::mt19937(sequence);
}

Setting set_up(const ComparedHand& hand, const BodySpec& object, double scale) {
  PlacedBody placed;
  placed.body = scaled(object, scale);
  const BodyMass mass = body_mass(placed.body);
  placed.body.mass = mass;
  Setting setting{hand, touching_hand(*hand.hand), {}, mass.mass};
  setting.scene.object = build_body(placed);
  setting.scene.materials = built_in_materials();
  return setting;
}

Grasp make_grasp(const Setting& setting, int number, const CompareOptions& options) {
  const SceneBody& object = setting.scene.object;
  std::mt19937 posture = generator(options.seed, object.name, number, Stream::kPosture);
  std::mt19937 start = generator(options.seed, object.name, number, Stream::kStart);
  const Eigen::VectorXd q = draw_preshape(setting.touching, number, posture);
  GraspOptions grasping = options.grasp;
  grasping.way = way_past(setting.touching, q, object);
  const Pose<double> X_WH = draw_start(setting.touching, q, object, start);
  grasping.stand_off = draw_stand_off(start);
  grasping.pads.contact = setting.hand.contact;
  return centred_grasp(setting.touching, X_WH, q, setting.scene, grasping);
}

/// Every approach of a cell, in whatever order threads come to them. Fewer if stopped.
std::vector<Grasp> all_grasps(const Setting& setting, const CompareOptions& options,
                              const Progress& progress) {
  std::vector<Grasp> grasps(static_cast<std::size_t>(options.approaches));
  std::atomic<int> next{0}, finished{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (int n = next++; n < options.approaches && !progress.stop(); n = next++) {
        grasps[static_cast<std::size_t>(n)] = make_grasp(setting, n, options);
        ++finished;
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
      next = options.approaches;
    }
  };
  std::vector<std::thread> others;
  for (int t = 1; t < options.threads; ++t) others.emplace_back(work);
  work();
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
  if (finished < options.approaches) grasps.clear();
  return grasps;
}

bool closes(const Grasp& grasp) {
  return grasp.outcome == GraspOutcome::kGrasped && grasp.quality.force_closure;
}

BestGrasp describe(const Setting& setting, const Grasp& grasp, int number,
                   const CompareOptions& options) {
  BestGrasp best;
  best.approach = number;
  best.X_WH = grasp.approached.X_WH;
  best.q = grasp.closed.q;
  best.contacts = grasp.contacts;
  best.epsilon = grasp.quality.lower;
  best.type = grasp_type(*setting.hand.hand, grasp.contacts);
  const GraspLoads loads =
      grasp_loads(*setting.hand.hand, best, setting.scene.object, setting.mass, options.tasks);
  best.hold = loads.hold;
  best.margin = loads.margin;
  return best;
}

void count(HandOnObject& cell, const Setting& setting, const std::vector<Grasp>& grasps,
           const CompareOptions& options) {
  std::vector<std::pair<double, int>> closed;
  for (std::size_t n = 0; n < grasps.size(); ++n) {
    ++cell.outcomes[static_cast<std::size_t>(grasps[n].outcome)];
    if (!closes(grasps[n])) continue;
    closed.emplace_back(grasps[n].quality.lower, static_cast<int>(n));
    ++cell.types[grasp_type(*setting.hand.hand, grasps[n].contacts)];
  }
  std::sort(closed.begin(), closed.end());
  cell.approaches = options.approaches;
  cell.closures = static_cast<int>(closed.size());
  cell.success = static_cast<double>(cell.closures) / options.approaches;
  cell.interval = wilson_interval(cell.closures, options.approaches);
  cell.epsilon.resize(cell.closures);
  for (int i = 0; i < cell.closures; ++i)
    cell.epsilon[i] = closed[static_cast<std::size_t>(i)].first;
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
  const std::vector<Grasp> grasps = all_grasps(setting, options, progress);
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
