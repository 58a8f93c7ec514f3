#include "live/world/world_edits.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "api/named/data_folders.h"
#include "api/named/files.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/name_hint.h"
#include "base/nearest_name.h"
#include "live/world/free_position.h"
#include "live/world/imported_files.h"
#include "live/world/world_import.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

void require_material(const WorldSpec& world, const std::string& material) {
  if (!material.empty()) (void)world.materials.at(material);
}

/// Returns the entry of WorldState::placed of a name, or its size if there is none.
std::size_t placed_index(const WorldState& state, const std::string& name) {
  for (std::size_t i = 0; i < state.placed.size(); ++i)
    if (current_hand_name(state.placed[i].name) == current_hand_name(name)) return i;
  return state.placed.size();
}

/// Returns the entry of WorldState::bodies of a name, or its size if there is none.
std::size_t body_index(const WorldState& state, const std::string& name) {
  const std::vector<std::string> names = body_names(state);
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

[[noreturn]] void refuse_name(const WorldState& state, const std::string& name) {
  std::vector<std::string> names = body_names(state);
  append_all(names, names_of(state.placed));
  throw InputError(fmt::format("the world has no '{}'{} it has {}", name,
                               hint_before_list(name, names), listed(names)));
}

/// Creates the world-file entry of a new hand from its name or file.
PlacedHand placed_by_name(const LiveWorld& live, const std::string& name) {
  // Find the hand by name or file.
  const WorldState& state = live.state();
  const HandSource source = find_hand(name, live.data_folders());
  PlacedHand placed;
  placed.name = current_hand_name(name);
  // The built-in human hand keeps its name, and can be added once in each version.
  if (source.human && source.file.empty()) {
    if (placed.name == "human")
      placed.name = "human:" + name_in(kHumanVersionNames, *source.version);
    require(
        placed_index(state, placed.name) == state.placed.size(),
        "the world has the hand '{}' already; another version of it, or another subject's hand, "
        "can be added",
        placed.name);
    return placed;
  }
  // A robot or a subject is entered by its file, under a free name.
  const std::string version = source.human ? version_of_hand(placed.name) : "";
  const std::string base = fs::path(source.file).stem().string();
  placed.file = file_seen_from(state.header->folder, source.file);
  placed.name = free_name(state, base + version);
  // The version must be the end of the name.
  for (int number = 2; !version.empty() && version_of_hand(placed.name) != version; ++number)
    placed.name = free_name(state, fmt::format("{} {}{}", base, number, version));
  return placed;
}

/// Returns the state without an entry of `placed` and without the hand that begins with it.
WorldState without_placed(WorldState state, std::size_t removed) {
  // Remove the hand.
  erase_where(state.hands, [&](const StateHand& hand) { return hand.parts.front() == removed; });
  // Renumber the parts of the other hands.
  for (StateHand& hand : state.hands)
    for (std::size_t& part : hand.parts)
      if (part > removed) --part;
  state.placed.erase(state.placed.begin() + static_cast<std::ptrdiff_t>(removed));
  return state;
}

/// Returns the key of LiveWorld::apply() for a gesture; empty without one.
/// @param what  kind of edit and name of the thing
std::string gesture_key(const std::string& what, const std::string& gesture) {
  return gesture.empty() ? "" : what + "\n" + gesture;
}

Pose<double> moved_to(const Pose<double>& X, const std::optional<Eigen::Vector3d>& position,
                      const std::optional<Eigen::Matrix3d>& R) {
  return {R.value_or(X.R), position.value_or(X.p)};
}

Pose<double> pose_for(const WorldState& state, const BoundingBalls& balls,
                      const RequestedPose& place) {
  return {place.R, place.position ? *place.position : free_position(state, balls, place.R)};
}

/// Returns the leading joint of the drive of a joint, or the joint itself.
int leader_of(const LiveHand& hand, int coordinate) {
  const int leader = hand.couplings[coordinate].leader;
  return leader < 0 ? coordinate : leader;
}

/// Sets named joints and the joints coupled to them, see set_joints().
void set_named_joints(const LiveHand& hand, const std::vector<std::pair<int, double>>& named,
                      Eigen::VectorXd& q) {
  // Count the named joints of each drive.
  std::map<int, int> named_of_drive;  // leader -> number of named joints
  for (const auto& [c, value] : named) ++named_of_drive[leader_of(hand, c)];
  // Set the leader and the followers of each drive, except for followers named with other joints.
  for (const auto& [c, value] : named) {
    const int leader = leader_of(hand, c);
    if (c != leader && named_of_drive[leader] > 1) continue;
    const double ratio = c == leader ? 1 : hand.couplings[c].ratio;
    if (ratio == 0) continue;
    q[leader] = value / ratio;
    for (std::size_t f = 0; f < hand.couplings.size(); ++f)
      if (hand.couplings[f].leader == leader) q[f] = hand.couplings[f].ratio * q[leader];
  }
  // Set all named joints to their own values.
  for (const auto& [c, value] : named) q[c] = value;
}

/// Returns the joints that deviate from their coupling.
std::vector<std::string> decoupled_joints(const LiveHand& hand, const Eigen::VectorXd& q) {
  constexpr double kCouplingTolerance = 1e-9;  // largest deviation of a coupled joint [rad] or [m]
  std::vector<std::string> parted;
  for (std::size_t f = 0; f < hand.couplings.size(); ++f) {
    const JointCoupling& coupling = hand.couplings[f];
    if (coupling.leader >= 0 &&
        std::abs(q[f] - coupling.ratio * q[coupling.leader]) > kCouplingTolerance)
      parted.push_back(hand.model().layout().coordinates[f]);
  }
  return parted;
}

}  // namespace

AddedThing add_body(LiveWorld& live, PlacedBody placed, const RequestedPose& place) {
  // Check the material, and give the body a free name.
  WorldState next = live.state();
  require_material(*next.header, placed.body.material);
  placed.body.name = free_name(next, placed.body.name);
  AddedThing added{placed.body.name, {}};
  if (placed.body.material.empty())
    added.warnings.push_back(fmt::format("no material is stated of body '{}': {} is taken",
                                         added.name, kDefaultMaterial));
  StateBody body = build_state_body(placed);
  // Build the body, and place it.
  body.X_WB = pose_for(next, {body.built->ball}, place);
  next.bodies.push_back(std::move(body));
  live.apply(std::move(next), "add " + added.name);
  return added;
}

AddedThing add_object(LiveWorld& live, const std::string& object, bool dynamic,
                      const RequestedPose& place) {
  const std::string file = named_file("object", object, "objects", ".toml", live.data_folders());
  PlacedBody placed;
  std::vector<std::string> warnings;
  // Refer to the file of a TOML object; embed all other objects in the world.
  if (fs::path(file).extension() == ".toml") {
    require_kind(file, {"object"});
    placed.body = read_object(file);
    placed.file = file_seen_from(live.state().header->folder, file);
  } else {
    ImportedBody imported = read_imported_body(file);
    placed.body = std::move(imported.body);
    warnings = std::move(imported.warnings);
  }
  placed.dynamic = dynamic;
  AddedThing added = add_body(live, std::move(placed), place);
  added.warnings.insert(added.warnings.begin(), warnings.begin(), warnings.end());
  return added;
}

AddedThing add_hand(LiveWorld& live, const std::string& hand, const RequestedPose& place,
                    const Progress& progress) {
  PlacedHand placed = placed_by_name(live, hand);
  WorldState next = live.state();
  next.placed.push_back(placed);
  // Build the hand with its carriers, and place it.
  WorldSpec world = *next.header;
  world.hands = next.placed;
  const std::size_t last = next.placed.size() - 1;
  std::shared_ptr<const LiveHand> built = live.find_or_build_hand(world, last, "world", progress);
  next.placed[last].X_WH = pose_for(next, built->balls, place);
  world.hands = next.placed;
  const WorldHand in_world =
      reposed_hand(world, placed.name, "world", live.data_folders(), built->hand);
  AddedThing added{placed.name, built->hand.named.warnings};
  next.hands.push_back({std::move(built), in_world.parts, {in_world.X_WH, in_world.q}});
  live.apply(std::move(next), "add " + added.name);
  return added;
}

void remove_thing(LiveWorld& live, const std::string& name) {
  // Remove a body.
  WorldState next = live.state();
  if (const std::size_t body = body_index(next, name); body < next.bodies.size()) {
    next.bodies.erase(next.bodies.begin() + static_cast<std::ptrdiff_t>(body));
    live.apply(std::move(next), "remove " + name);
    return;
  }
  // Remove a hand that carries no other.
  const std::size_t hand = placed_index(next, name);
  if (hand == next.placed.size()) refuse_name(next, name);
  const std::vector<std::string> carried = carried_by(next.placed, next.placed[hand].name);
  require(carried.empty(), "'{}' carries {}: remove that first", name, listed(carried));
  const std::string carrier = next.placed[hand].carrier;
  next = without_placed(std::move(next), hand);
  // A carrier without any hand left becomes a hand of its own.
  const std::size_t bare = carrier.empty() ? next.placed.size() : placed_index(next, carrier);
  if (bare < next.placed.size() && carried_by(next.placed, next.placed[bare].name).empty()) {
    WorldSpec world = *next.header;
    world.hands = next.placed;
    std::shared_ptr<const LiveHand> built = live.find_or_build_hand(world, bare, "world", {});
    const WorldHand in_world =
        reposed_hand(world, next.placed[bare].name, "world", live.data_folders(), built->hand);
    next.hands.push_back({std::move(built), in_world.parts, {in_world.X_WH, in_world.q}});
  }
  live.apply(std::move(next), "remove " + name);
}

void place_thing(LiveWorld& live, const std::string& name,
                 const std::optional<Eigen::Vector3d>& position,
                 const std::optional<Eigen::Matrix3d>& R, const std::string& gesture) {
  require(!position || position->allFinite(), "wanted a finite position of '{}'", name);
  // Move a body.
  WorldState next = live.state();
  const std::string key = gesture_key("place " + name, gesture);
  if (const std::size_t body = body_index(next, name); body < next.bodies.size()) {
    next.bodies[body].X_WB = moved_to(next.bodies[body].X_WB, position, R);
    live.apply(std::move(next), "move " + name, key);
    return;
  }
  // A mounted hand cannot be placed: name its root carrier in the message.
  const std::size_t placed = placed_index(next, name);
  if (placed == next.placed.size()) refuse_name(next, name);
  const PlacedHand& found = next.placed[placed];
  require(found.carrier.empty(),
          "'{}' is mounted on '{}' ({}): move the joints of that, or place '{}'", name,
          found.carrier, found.carrier_link, [&] {
            for (const StateHand& hand : next.hands)
              if (contains(hand.parts, placed)) return root_name(next, hand);
            return found.carrier;
          }());
  // Move the root, with all hands on it.
  for (std::size_t h = 0; h < next.hands.size(); ++h) {
    if (next.hands[h].parts.back() != placed) continue;
    const Pose<double> X = moved_to(next.hands[h].placement.X_WH, position, R);
    live.apply(with_hand_placed(std::move(next), h, X), "move " + name, key);
    return;
  }
}

std::map<std::string, double> joints_of(const WorldState& state, std::size_t hand) {
  const StateHand& found = state.hands[hand];
  const std::vector<std::string>& names = found.built->model().layout().coordinates;
  std::map<std::string, double> joints;
  for (std::size_t c = 0; c < names.size(); ++c) joints[names[c]] = found.placement.q[c];
  return joints;
}

JointChange set_joints(LiveWorld& live, const std::string& hand,
                       const std::map<std::string, double>& joints, const std::string& gesture) {
  const std::size_t index = hand_index(live.state(), hand);
  const StateHand& found = live.state().hands[index];
  // Check all names and values before any joint moves.
  const HandLayout& layout = found.built->model().layout();
  std::vector<std::pair<int, double>> named;
  for (const auto& [name, value] : joints) {
    require(std::isfinite(value), "wanted a finite value of joint '{}'", name);
    named.emplace_back(static_cast<int>(index_of_name(name, layout.coordinates, "joint")), value);
  }
  // Set the joints, and clamp all to their limits.
  Eigen::VectorXd q = found.placement.q;
  set_named_joints(*found.built, named, q);
  JointChange set;
  for (Eigen::Index c = 0; c < q.size(); ++c) {
    const double inside = std::clamp(q[c], layout.lower[c], layout.upper[c]);
    if (inside != q[c]) set.limited.push_back(layout.coordinates[c]);
    q[c] = inside;
  }
  // Apply the posture; an empty request is no edit.
  if (!joints.empty())
    live.apply(with_posture(live.state(), index, q),
               "move joints of " + hand_name(live.state(), found),
               gesture_key("joints of " + hand_name(live.state(), found), gesture));
  set.joints = joints_of(live.state(), index);
  set.parted = decoupled_joints(*live.state().hands[index].built, q);
  return set;
}

}  // namespace thenar
