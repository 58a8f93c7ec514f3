#include "report/pages/scene_run.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "base/units.h"
#include "report/answers/motion_account.h"
#include "report/answers/simulate_scene.h"
#include "report/provenance.h"

namespace thenar {
namespace {

using Eigen::Index;

constexpr Index kMaxPlayed = 240;       // Most instants of the player
constexpr int kStillCount = 8;          // Pictures in a row
constexpr std::size_t kMaxCurves = 24;  // Most curves of a chart
// Arrow of the largest force, over the size of the scene [1]
constexpr double kLongestArrow = 0.25;
constexpr double kBodyOpacity = 0.5;  // Opacity of bodies that are no links [1]
const char* const kForceColor = "#b3261e";
const char* const kPatchColor = "#1b6ca8";  // colour of contact patches of pads
const char* const kStickColor = "#0b3d2e";  // colour of their sticking parts
const char* const kFixedColor = "#b9c0c9";

const char* color_of_owner(std::size_t index) {
  static constexpr const char* kColors[] = {"#e6a83c", "#6fa8cf", "#8dbb95",
                                            "#c7a6d1", "#d3a15f", "#7cc0c4"};
  return kColors[index % std::size(kColors)];
}

/// Instants of still pictures: even steps of what is half time and half way, the longest that any
/// body's centre has gone, so that pictures are close where much happens.
/// @param played  instants that the view has
std::vector<double> still_times(const SceneResult& scene, const std::vector<Index>& played) {
  const std::vector<SceneSample>& samples = scene.run.samples;
  const std::vector<MechanismBody>& bodies = scene.built->scene.mechanism.bodies;
  // Way up to each instant that is played.
  std::vector<double> way(played.size(), 0);
  for (std::size_t k = 1; k < played.size(); ++k) {
    double most = 0;
    for (const std::size_t b : scene.measures.moving) {
      const auto centre = [&](Index i) {
        return Eigen::Vector3d(nth(scene.measures.X_WB, i)[b] * bodies[b].mass.com);
      };
      most = std::max(most, (centre(played[k]) - centre(played[k - 1])).norm());
    }
    way[k] = way[k - 1] + most;
  }
  const auto time = [&](std::size_t k) { return nth(samples, played[k]).t; };
  const double span = time(played.size() - 1) - time(0);
  const auto share = [&](std::size_t k) {
    const double gone = way.back() > 0 ? way[k] / way.back() : 0;
    return span > 0 ? 0.5 * (time(k) - time(0)) / span + 0.5 * gone : 0;
  };
  // The first instant that reaches each of the shares; after a jump one instant reaches several.
  const double whole = share(played.size() - 1);
  std::vector<double> times;
  std::size_t k = 0;
  for (int still = 0; still < kStillCount; ++still) {
    while (k + 1 < played.size() && share(k) < whole * still / (kStillCount - 1) - 1e-12) ++k;
    if (times.empty() || time(k) > times.back()) times.push_back(time(k));
  }
  return times;
}

/// Data of a run for the scene view.
class SceneFilm {
 public:
  SceneFilm(const SceneResult& scene, MeshTable& meshes)
      : scene_(scene), mechanism_(scene.built->scene.mechanism) {
    for (const MechanismBody& body : mechanism_.bodies)
      meshes_.push_back(body.solid && !body.solid->visual.empty()
                            ? meshes.add(body.solid->visual, {kBodyCrease, {}})
                            : "");
    for (const std::string& owner : scene.built->owner)
      if (colors_.count(owner) == 0) colors_.emplace(owner, color_of_owner(colors_.size()));
    measure();
  }

  /// @param most  instants
  [[nodiscard]] Json block(Index most) const {
    Json layers = Json::array();
    add_fixed(layers);
    const std::vector<Index> played = spread(static_cast<Index>(scene_.run.samples.size()), most);
    for (const Index i : played) add_instant(static_cast<std::size_t>(i), layers);
    Json block{
        {"type", "scene"},
        {"caption", fmt::format("{} in motion; arrows are contact forces, {:.3g} mm for {:.3g} N",
                                scene_.name, arrow_ / kMm, largest_force_)},
        {"layers", std::move(layers)},
        {"strip", still_times(scene_, played)}};
    if (scene_.camera) block["view"] = numbers3(scene_.camera->eye - scene_.camera->target);
    return block;
  }

 private:
  void measure() {
    for (const SceneSample& sample : scene_.run.samples)
      for (const ContactSample& contact : sample.contacts)
        largest_force_ = std::max(largest_force_, contact.force.norm());
    // The size of what moves, at the start.
    Eigen::AlignedBox3d box;
    for (const std::size_t b : scene_.measures.moving) {
      if (meshes_[b].empty()) continue;
      const Eigen::Matrix3Xd& vertices = mechanism_.bodies[b].solid->visual.vertices;
      for (Index k = 0; k < vertices.cols(); ++k)
        box.extend(scene_.measures.X_WB.front()[b] * Eigen::Vector3d(vertices.col(k)));
    }
    if (!box.isEmpty()) arrow_ = kLongestArrow * box.diagonal().norm();
  }

  [[nodiscard]] Json item(std::size_t body, std::size_t instant) const {
    return mesh_item(meshes_[body], scene_.measures.X_WB[instant][body]);
  }

  [[nodiscard]] bool moves(std::size_t body) const {
    return std::binary_search(scene_.measures.moving.begin(), scene_.measures.moving.end(), body);
  }

  [[nodiscard]] bool has_moving_part(const std::string& owner) const {
    return any_of(scene_.measures.moving,
                  [&](std::size_t body) { return scene_.built->owner[body] == owner; });
  }

  void add_fixed(Json& layers) const {
    Json items = Json::array();
    for (std::size_t b = 0; b < meshes_.size(); ++b) {
      if (meshes_[b].empty() || moves(b)) continue;
      items.push_back(item(b, 0));
      // Draw the palm of a fixed hand in the colour of its fingers.
      if (has_moving_part(scene_.built->owner[b]))
        items.back()["color"] = colors_.at(scene_.built->owner[b]);
    }
    if (items.empty()) return;
    layers.push_back(with(layer("stands still", kFixedColor, std::move(items)), {{"fit", false}}));
  }

  /// A circle of an area around a contact, across its normal.
  static Json ring(const ContactSample& contact, double area) {
    constexpr int kRingCorners = 32;  // Corners of the circle
    const double radius = std::sqrt(area / kPi);
    const Tangents across = tangents(contact.normal);
    const auto corner = [&](int i) {
      const double angle = 2 * kPi * i / kRingCorners;
      return in_mm(contact.point +
                   radius * (std::cos(angle) * across.e1 + std::sin(angle) * across.e2));
    };
    Json positions = Json::array();
    for (int i = 0; i < kRingCorners; ++i)
      for (const int end : {i, i + 1}) positions.push_back(corner(end));
    return {{"kind", "lines"}, {"positions", std::move(positions)}};
  }

  void add_instant(std::size_t instant, Json& layers) const {
    const SceneSample& sample = scene_.run.samples[instant];
    Json items = Json::array(), arrows = Json::array();
    for (const std::size_t b : scene_.measures.moving) {
      if (meshes_[b].empty()) continue;
      items.push_back(item(b, instant));
      items.back()["color"] = colors_.at(scene_.built->owner[b]);
      // Links are called after their hand; what they hold is seen through, so that forces are.
      if (mechanism_.bodies[b].name == scene_.built->owner[b])
        items.back()["opacity"] = kBodyOpacity;
    }
    // Forces act on both bodies, with opposite signs.
    for (const ContactSample& contact : sample.contacts) {
      // A contact presses on both bodies, in opposite directions.
      const Eigen::Vector3d vector = arrow_ / largest_force_ * contact.force;
      if (vector.norm() < 1e-3 * arrow_) continue;
      for (const double sign : {1.0, -1.0})
        arrows.push_back({{"kind", "arrow"},
                          {"from", in_mm(contact.point)},
                          {"vector", in_mm(sign * vector)},
                          {"radius", 25 * arrow_}});
    }
    // A patch is a ring of its area; the share that sticks is a smaller one.
    Json patches = Json::array(), stuck = Json::array();
    for (const ContactSample& contact : sample.contacts) {
      if (contact.area <= 0) continue;
      patches.push_back(ring(contact, contact.area));
      if (contact.stick > 0) stuck.push_back(ring(contact, contact.area * contact.stick));
    }
    for (auto& [what, color, list] :
         {std::tuple<const char*, const char*, Json&>{"bodies", "#e6a83c", items},
          std::tuple<const char*, const char*, Json&>{"contact forces", kForceColor, arrows},
          std::tuple<const char*, const char*, Json&>{"patches of pads", kPatchColor, patches},
          std::tuple<const char*, const char*, Json&>{"share that sticks", kStickColor, stuck}}) {
      if (list.empty()) continue;
      layers.push_back(
          with(layer(fmt::format("{} at {:.3g} s", what, sample.t), color, std::move(list)),
               {{"time", sample.t}}));
    }
  }

  const SceneResult& scene_;
  const Mechanism& mechanism_;
  std::vector<std::string> meshes_;  // mesh of each body; empty: none
  std::map<std::string, std::string> colors_;
  double largest_force_ = 0;  // [N]
  double arrow_ = 0.02;       // length of the largest force [m]
};

/// A chart of quantities over time.
class TimeChart {
 public:
  explicit TimeChart(const SceneResult& scene)
      : scene_(scene), instants_(spread(static_cast<Index>(scene.run.samples.size()), 2000)) {
    for (const Index i : instants_) time_.push_back(nth(scene.run.samples, i).t);
  }

  /// Adds a curve. @param at  value at an instant; null where it has none
  template <typename At>
  void add(const std::string& name, const At& at) {
    if (series_.size() >= kMaxCurves) return;
    const auto value = [&](Index i) { return at(static_cast<std::size_t>(i)); };
    series_.push_back(curve_json(name, time_, list_of_each(instants_, value)));
  }

  [[nodiscard]] Json block(const std::string& caption, const std::string& label) const {
    return lines_block(caption, "time [s]", label, series_);
  }

  [[nodiscard]] bool empty() const { return series_.empty(); }

 private:
  const SceneResult& scene_;
  std::vector<Index> instants_;
  Json time_ = Json::array();
  Json series_ = Json::array();
};

Json energy_chart(const SceneResult& scene) {
  TimeChart chart(scene);
  const auto energy = [&](std::size_t i) { return scene.run.samples[i].energy; };
  const double weight = energy(0).weight;
  chart.add("kinetic", [&](std::size_t i) { return 1e3 * energy(i).kinetic; });
  chart.add("potential, from its start",
            [&](std::size_t i) { return 1e3 * (energy(i).weight - weight); });
  chart.add("springs", [&](std::size_t i) { return 1e3 * energy(i).springs; });
  chart.add("sum", [&](std::size_t i) { return 1e3 * (energy(i).total() - weight); });
  return chart.block("Energy", "energy [mJ]");
}

/// Places of the bodies that move, a chart for each direction.
Json place_charts(const SceneResult& scene) {
  const Mechanism& mechanism = scene.built->scene.mechanism;
  // Follow centres of mass, which do not depend on where a body has its origin.
  Json blocks = Json::array();
  for (Index axis = 0; axis < 3; ++axis) {
    TimeChart chart(scene);
    for (const std::size_t b : scene.measures.moving)
      chart.add(mechanism.bodies[b].name, [&](std::size_t i) {
        return (scene.measures.X_WB[i][b] * mechanism.bodies[b].mass.com)[axis] / kMm;
      });
    if (chart.empty()) continue;
    const char name = "xyz"[axis];
    blocks.push_back(chart.block(fmt::format("Places of the centres of mass along {}", name),
                                 fmt::format("{} [mm]", name)));
  }
  return blocks;
}

Json force_chart(const SceneResult& scene) {
  TimeChart chart(scene);
  const std::vector<MechanismBody>& bodies = scene.built->scene.mechanism.bodies;
  for (const PairMeasure& pair : scene.measures.pairs)
    chart.add(nth(bodies, pair.a).name + " - " + nth(bodies, pair.b).name, [&](std::size_t i) {
      double force = 0;
      for (const ContactSample& contact : scene.run.samples[i].contacts)
        if (contact.a == pair.a && contact.b == pair.b) force += contact.force.dot(contact.normal);
      return force;
    });
  return chart.block("Normal force of each pair of bodies, sum of its points", "force [N]");
}

/// Tensions of muscles that pull, and activations of those that contract.
Json muscle_charts(const SceneResult& scene) {
  // Muscles that stay at rest are left out.
  TimeChart tensions(scene), activations(scene);
  for (const PullMeasure& muscle : scene.measures.pulls.muscles) {
    if (muscle.tension.maxCoeff() > 0)
      tensions.add(muscle.name,
                   [&](std::size_t i) { return muscle.tension[static_cast<Index>(i)]; });
    if (muscle.activation.maxCoeff() > 0)
      activations.add(muscle.name,
                      [&](std::size_t i) { return muscle.activation[static_cast<Index>(i)]; });
  }
  Json blocks = Json::array();
  if (!tensions.empty())
    blocks.push_back(
        tensions.block("Tensions (under a net with the 20 mN that keep it taut)", "tension [N]"));
  if (!activations.empty()) blocks.push_back(activations.block("Activations", "activation [1]"));
  return blocks;
}

}  // namespace

Json film_of(const SceneResult& scene, Index instants, MeshTable& meshes) {
  return SceneFilm(scene, meshes).block(instants);
}

Json used_banner(const std::string& solved, const std::vector<std::string>& warnings) {
  const bool caution = !warnings.empty();
  return with(banner_block((caution ? "Read the cautions below. " : "") + solved, warnings, true),
              {{"caution", caution}});
}

Json run_banner(const SceneResult& scene) {
  // State the refusal of a motion; otherwise the solver's residual.
  const std::string refusal = refusal_of(scene);
  if (!refusal.empty()) return banner_block("Do not use this motion", Json::array({refusal}));
  return used_banner(has_contact_problems(scene)
                         ? fmt::format("All contact problems were solved; worst residual {:.2g}",
                                       scene.run.cost.worst_residual)
                         : "Contacts are springs: the error of each step is below the tolerance",
                     scene.outcome.warnings);
}

Json opening_of(const SceneResult& scene) {
  // Who touches at the end, with the force of each pair.
  const std::vector<MechanismBody>& bodies = scene.built->scene.mechanism.bodies;
  std::vector<std::string> touching;
  for (const PairMeasure& pair : scene.measures.pairs)
    if (pair.points > 0)
      touching.push_back(fmt::format("{} and {} ({:.3g} N)", nth(bodies, pair.a).name,
                                     nth(bodies, pair.b).name, pair.force.norm()));
  return opening_json(
      "What happens in this scene: " + scene.description + "?",
      fmt::format("{:.6g} s was simulated with {}, {} steps.", scene.run.samples.back().t,
                  method_of(scene), scene.run.cost.steps),
      refusal_of(scene).empty() ? (touching.empty() ? "At the end nothing touches."
                                                    : fmt::format("In contact at the end: {}.",
                                                                  fmt::join(touching, ", ")))
                                : "The motion is not to be used: " + refusal_of(scene) + ".");
}

Json page_of(const SceneResult& scene) {
  // Motion first, then forces, muscles and places, and the account of energy at last.
  MeshTable meshes;
  Json blocks = Json::array({run_banner(scene)});
  blocks.push_back(film_of(scene, kMaxPlayed, meshes));
  Json sections = Json::array({section("motion", "Motion", scene.description, std::move(blocks))});
  if (!scene.measures.pairs.empty())
    sections.push_back(section("contacts", "Contacts", "", Json::array({force_chart(scene)})));
  if (!scene.measures.pulls.muscles.empty())
    sections.push_back(section("muscles", "Muscles", "", muscle_charts(scene)));
  sections.push_back(section("places", "Places", "", place_charts(scene)));
  sections.push_back(
      section("energy", "Energy",
              fmt::format("Work of forces and drives {:.4g} mJ; dissipated {:.4g} mJ.",
                          1e3 * scene.measures.work, 1e3 * scene.measures.dissipated),
              Json::array({energy_chart(scene),
                           table_block("Reliability of this motion", account_table(scene))})));
  return {{"title", fmt::format("Scene {}", scene.name)},
          {"subtitle",
           fmt::format("{} after {:.6g} s", name_of(scene.run.status), scene.run.samples.back().t)},
          {"opening", opening_of(scene)},
          {"provenance", provenance_json(scene.sources)},
          {"meshes", meshes.json()},
          {"sections", std::move(sections)}};
}

Json page_of(const SceneSweepResult& sweep) {
  return {{"title", fmt::format("Scene {}, {} runs", sweep.name, sweep.runs.size())},
          {"sections",
           Json::array({section("runs", "Runs", "",
                                Json::array({table_block("All runs", table_of(sweep))}))})}};
}

}  // namespace thenar
