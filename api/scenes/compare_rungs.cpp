#include "api/scenes/compare_rungs.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "api/scenes/scene_account.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/parallel_tasks.h"

namespace thenar {
namespace {

/// Relative cost of a rung, for the progress of the whole comparison.
double weight_of(const std::string& rung) { return rung == "elements" ? 10 : 1; }

bool was_solved(const SceneResult& scene) {
  return scene.run.status == SceneStatus::kDone && scene.run.cost.unsolved == 0;
}

/// The finest run that was solved, or else the finest.
std::size_t finest_of(const std::vector<RungRun>& runs) {
  const auto order = [](const RungRun& run) {
    return std::pair(!was_solved(run.scene),
                     index_of_name(run.rung, pad_rung_names(), "rung of pads"));
  };
  const auto first =
      std::min_element(runs.begin(), runs.end(),
                       [&](const RungRun& a, const RungRun& b) { return order(a) < order(b); });
  return static_cast<std::size_t>(first - runs.begin());
}

/// Pairs that have a patch at some instant of some run.
std::vector<std::pair<int, int>> pads_of(const std::vector<RungRun>& runs) {
  std::set<std::pair<int, int>> pads;
  for (const RungRun& run : runs)
    for (const SceneSample& sample : run.scene.run.samples)
      for (const ContactSample& contact : sample.contacts)
        if (contact.area > 0) pads.emplace(contact.a, contact.b);
  return {pads.begin(), pads.end()};
}

/// Errors of a run against the finest, up to the last instant that both have.
RungError error_of(const RungComparison& comparison, const SceneResult& scene) {
  // Compare at the same instants: both runs have the same sampling.
  const SceneResult& finest = comparison.runs[comparison.finest].scene;
  const std::vector<SceneSample>&ours = scene.run.samples, &theirs = finest.run.samples;
  RungError out;
  double off = 0, all = 0;
  const std::size_t instants = std::min(ours.size(), theirs.size());
  for (std::size_t i = 0; i < instants; ++i) {
    // Forces of pads.
    const std::vector<PadLoad> a = pad_loads(comparison, ours[i]),
                               b = pad_loads(comparison, theirs[i]);
    double off_now = 0, all_now = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      off_now += std::pow(a[k].force - b[k].force, 2);
      all_now += std::pow(b[k].force, 2);
    }
    off += off_now;
    all += all_now;
    out.force_end = all_now > 0 ? std::sqrt(off_now / all_now) : 0;
    // Places and turns of bodies; links are called after their hand.
    double place = 0, turn = 0;
    const std::vector<MechanismBody>& bodies = scene.built->scene.mechanism.bodies;
    for (const std::size_t body : scene.measures.moving) {
      if (bodies[body].name != scene.built->owner[body]) continue;
      const Pose<double>&X = scene.measures.X_WB[i][body], &Y = finest.measures.X_WB[i][body];
      const Eigen::Vector3d com = bodies[body].mass.com;
      place = std::max(place, (X * com - Y * com).norm());
      turn = std::max(turn, Eigen::AngleAxisd(X.R * Y.R.transpose()).angle());
    }
    out.place_end = place;
    out.turn_end = turn;
    out.place_largest = std::max(out.place_largest, place);
  }
  // Root mean square over all instants, relative to the forces of the finest run.
  out.force_all = all > 0 ? std::sqrt(off / all) : 0;
  return out;
}

/// Returns warnings of every run, and runs that are not to be used, one sentence each.
std::vector<std::string> warnings_of(const RungComparison& comparison) {
  std::vector<std::string> all = comparison.runs.front().scene.built->warnings;
  for (const RungRun& run : comparison.runs) {
    // Of building it what the first had not, and all of the run.
    for (const std::string& warning : run.scene.outcome.warnings)
      if (!contains(all, warning)) all.push_back(fmt::format("on {}: {}", run.rung, warning));
    if (const std::string refusal = refusal_of(run.scene); !refusal.empty())
      all.push_back(fmt::format("on {}: {}", run.rung, refusal));
  }
  return all;
}

}  // namespace

std::vector<PadLoad> pad_loads(const RungComparison& comparison, const SceneSample& sample) {
  // Sum the points of contact of each pad.
  std::vector<PadLoad> out(comparison.pads.size());
  for (const ContactSample& contact : sample.contacts) {
    const auto pad =
        std::find(comparison.pads.begin(), comparison.pads.end(), std::pair(contact.a, contact.b));
    if (pad == comparison.pads.end()) continue;
    PadLoad& load = out[static_cast<std::size_t>(pad - comparison.pads.begin())];
    load.force += contact.force.dot(contact.normal);
    load.area += contact.area;
    load.stick = contact.stick;
    load.torsion += contact.torsion;
  }
  return out;
}

RungComparison compare_rungs(const SceneRequest& request, const std::vector<std::string>& rungs,
                             const Progress& progress) {
  require(request.pads.empty() && rungs.size() >= 2,
          "wanted two rungs of pads or more to compare, got {}", rungs.size());
  require(request.vary.empty(), "wanted either several rungs of pads or numbers that vary");
  // Each rung once, and only rungs that exist.
  std::set<std::string> names;
  for (const std::string& rung : rungs) {
    (void)index_of_name(rung, pad_rung_names(), "rung of pads");
    require(names.insert(rung).second, "the rung '{}' is asked for twice", rung);
  }
  RungComparison out;
  out.request = request;
  // Rungs side by side; those that were stopped are left out.
  std::vector<std::optional<SceneResult>> scenes(rungs.size());
  std::vector<ParallelTask> tasks;
  for (std::size_t i = 0; i < rungs.size(); ++i)
    tasks.push_back({weight_of(rungs[i]), [&, i](const Progress& own) {
                       SceneRequest one = request;
                       one.pads = rungs[i];
                       SceneResult scene = simulate_scene(one, own);
                       if (scene.run.status != SceneStatus::kStopped) scenes[i] = std::move(scene);
                     }});
  run_tasks(std::move(tasks), progress);
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    if (!scenes[i]) continue;
    out.name = scenes[i]->name;
    out.files.insert(scenes[i]->files.begin(), scenes[i]->files.end());
    out.runs.push_back({rungs[i], std::move(*scenes[i]), {}});
  }
  out.outcome.count_parts(out.runs.size(), rungs.size(), "rung");
  if (out.runs.empty()) return out;
  // Judge each run by the finest, and take the outcome from that one.
  out.finest = finest_of(out.runs);
  out.pads = pads_of(out.runs);
  for (RungRun& run : out.runs) run.error = error_of(out, run.scene);
  out.outcome.warnings = warnings_of(out);
  if (!out.outcome.stopped()) out.outcome.status = out.runs[out.finest].scene.outcome.status;
  return out;
}

}  // namespace thenar
