#include "dynamics/scene/scene_pairs.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/meeting_pairs.h"
#include "dynamics/stepping/scene_state.h"

namespace thenar {
namespace {

using Pair = std::pair<int, int>;

constexpr double kReportedOverlap = 1e-6;  // initial depth above which a pair is reported [m]

/// Returns the bodies of a name: one body, or all links of a hand.
std::vector<int> bodies_of(const BuiltScene& built, const std::string& name,
                           const std::string& path, int line) {
  std::vector<int> found;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < built.owner.size(); ++i) {
    names.push_back(built.scene.mechanism.bodies[i].name);
    if (names.back() == name || built.owner[i] == name) found.push_back(static_cast<int>(i));
  }
  if (found.empty())
    throw DataError(path, line,
                    fmt::format("there is no body '{}'{}", name, did_you_mean(name, names)));
  return found;
}

/// Returns all pairs of a body of one name and a body of another name.
std::vector<Pair> pairs_between(const BuiltScene& built, const std::vector<std::string>& between,
                                const std::string& path, int line) {
  std::vector<Pair> pairs;
  for (const int a : bodies_of(built, between[0], path, line))
    for (const int b : bodies_of(built, between[1], path, line))
      if (a != b) pairs.emplace_back(std::minmax(a, b));
  return pairs;
}

/// Returns the friction of a pair, with the constants that a [[friction]] states replaced.
PairFriction with_overrides(PairFriction pair, const SceneFrictionSpec& stated) {
  pair.coefficient = stated.coefficient.value_or(pair.coefficient);
  pair.torsion_radius = stated.torsion_radius.value_or(pair.torsion_radius);
  pair.restitution = stated.restitution.value_or(pair.restitution);
  return pair;
}

std::string material_of(const MechanismBody& body) {
  return body.material.empty() ? kDefaultMaterial : body.material;
}

/// Returns the friction of all named pairs; constants that a [[friction]] does not state are those
/// of all pairs.
std::map<Pair, PairFriction> named_pairs(const SceneSpec& spec, const BuiltScene& built) {
  std::map<Pair, PairFriction> named;
  for (const SceneFrictionSpec& friction : spec.frictions) {
    if (friction.between.empty()) continue;
    for (const Pair& pair : pairs_between(built, friction.between, spec.path, friction.line)) {
      if (!named.emplace(pair, with_overrides(built.scene.friction, friction)).second)
        throw DataError(spec.path, friction.line,
                        fmt::format("the friction of '{}' and '{}' is given twice",
                                    friction.between[0], friction.between[1]));
    }
  }
  return named;
}

/// Returns the static friction of the materials of a pair.
/// @throws DataError that names both bodies if it is not known
double material_friction(const SceneSpec& spec, const MovingScene& scene, const Pair& pair) {
  const MechanismBody& a = scene.mechanism.bodies[pair.first];
  const MechanismBody& b = scene.mechanism.bodies[pair.second];
  try {
    return spec.materials.between(material_of(a), material_of(b)).static_coefficient;
  } catch (const InputError& error) {
    throw DataError(spec.path, 1,
                    fmt::format("'{}' and '{}' may touch: {}; or name the pair in a [[friction]]",
                                a.name, b.name, error.what()));
  }
}

/// Sets the friction of all pairs of the scene.
void set_friction(const SceneSpec& spec, BuiltScene& built) {
  MovingScene& scene = built.scene;
  // Friction of all pairs, if the file states one.
  bool by_material = true;
  for (const SceneFrictionSpec& friction : spec.frictions) {
    if (!friction.between.empty()) continue;
    scene.friction = with_overrides(scene.friction, friction);
    by_material = !friction.coefficient;
  }
  // Named pairs, and if friction depends on materials, all other pairs that may meet.
  std::map<Pair, PairFriction> named = named_pairs(spec, built);
  if (by_material) {
    std::set<Pair> stated;
    for (const SceneFrictionSpec& friction : spec.frictions)
      if (!friction.between.empty() && friction.coefficient)
        for (const Pair& pair : pairs_between(built, friction.between, spec.path, friction.line))
          stated.insert(pair);
    for (const Pair& pair : pairs_that_may_meet(scene, tree_model(scene.mechanism))) {
      if (stated.count(pair) > 0) continue;
      PairFriction& friction = named.emplace(pair, scene.friction).first->second;
      friction.coefficient = material_friction(spec, scene, pair);
    }
  }
  scene.friction_pairs.assign(named.begin(), named.end());
}

/// Returns the penetration depths of all pairs that overlap at positions q [m].
std::map<Pair, double> penetration_depths(ContactStep& step, const Eigen::VectorXd& q) {
  std::vector<ActiveContact> found;
  step.find_contacts({0, q, Eigen::VectorXd::Zero(step.model().layout.v)}, 0, found);
  std::map<Pair, double> depths;
  for (const ActiveContact& contact : found) {
    if (contact.kind != ActiveContact::Kind::kContact) continue;
    double& depth = depths[{contact.a, contact.b}];
    depth = std::max(depth, -contact.gap);
  }
  return depths;
}

/// Excludes contacts of links of one hand that overlap at the start or with all coordinates at 0.
void exclude_overlapping_links(const SceneSpec& spec, BuiltScene& built) {
  if (spec.hands.empty()) return;
  MovingScene& scene = built.scene;
  // Set all coordinates of hands to 0.
  std::set<std::string> hands;
  for (const SceneHandSpec& hand : spec.hands) hands.insert(hand.placed.name);
  Eigen::VectorXd zero = scene.q;
  const MechanismLayout layout = layout_of(scene.mechanism);
  for (std::size_t c = 0; c < layout.coordinate_q.size(); ++c)
    if (scene.mechanism.coordinates[c].name.find('/') != std::string::npos)
      zero[layout.coordinate_q[c]] = 0;
  // Exclude pairs of links of one hand that overlap in either posture.
  std::set<Pair> inside;
  ContactStep step(scene);
  for (const Eigen::VectorXd& q : {scene.q, zero})
    for (const auto& [pair, depth] : penetration_depths(step, q)) {
      const std::string& owner = built.owner[pair.first];
      if (owner == built.owner[pair.second] && hands.count(owner) > 0) inside.insert(pair);
    }
  scene.excluded_pairs.insert(scene.excluded_pairs.end(), inside.begin(), inside.end());
}

}  // namespace

double friction_between(const SceneSpec& spec, const BuiltScene& built, int a, int b) {
  // Look for the pair itself, then for all pairs, then for the materials.
  const Pair pair = std::minmax(a, b);
  std::optional<double> common;
  for (const SceneFrictionSpec& friction : spec.frictions) {
    if (!friction.coefficient) continue;
    if (friction.between.empty()) {
      common = friction.coefficient;
      continue;
    }
    for (const Pair& named : pairs_between(built, friction.between, spec.path, friction.line))
      if (named == pair) return *friction.coefficient;
  }
  return common ? *common : material_friction(spec, built.scene, pair);
}

void set_pairs(const SceneSpec& spec, BuiltScene& built) {
  // Exclude the pairs of the file, and links that overlap by design.
  for (const SceneApartSpec& apart : spec.apart)
    append_all(built.scene.excluded_pairs,
               pairs_between(built, apart.between, spec.path, apart.line));
  exclude_overlapping_links(spec, built);
  set_friction(spec, built);
  // Warn of initial overlaps.
  ContactStep step(built.scene);
  for (const auto& [pair, depth] : penetration_depths(step, built.scene.q))
    if (depth > kReportedOverlap)
      built.warnings.push_back(
          fmt::format("'{}' and '{}' begin in each other by {:.3g} mm and are pushed apart",
                      built.scene.mechanism.bodies[pair.first].name,
                      built.scene.mechanism.bodies[pair.second].name, 1e3 * depth));
}

}  // namespace thenar
