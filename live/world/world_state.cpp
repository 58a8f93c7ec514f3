#include "live/world/world_state.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/name_hint.h"
#include "base/nearest_name.h"

namespace thenar {
namespace {

/// Returns the entry of a name, or the only entry. @param kind  kind of thing for messages: "hand"
/// @throws InputError if there is no such entry, or no only one
std::size_t entry_named(const std::vector<std::string>& names, const std::string& name,
                        const std::string& kind) {
  // Find the name.
  if (!name.empty()) {
    const int found = place_in(names, name);
    require(found >= 0, "the world has no {} '{}'{} it has {}", kind, name,
            hint_before_list(name, names), listed(names));
    return static_cast<std::size_t>(found);
  }
  // Without a name there must be exactly one entry.
  require(!names.empty(), "the world has no {}", kind);
  require(names.size() == 1, "the world has the {}s {}; choose one with '{}'", kind, listed(names),
          kind);
  return 0;
}

/// Writes the posture of a hand to its parts in `placed`.
void write_posture(WorldState& state, const StateHand& hand) {
  const WorldHand& built = hand.built->hand;
  for (std::size_t i = 0; i < hand.parts.size(); ++i) {
    PlacedHand& placed = state.placed[hand.parts[i]];
    placed.posture.clear();
    for (std::size_t c = 0; c < built.names[i].size(); ++c)
      placed.posture[built.names[i][c]] = hand.placement.q[built.places[i][c]];
  }
}

/// Copies the coordinates of parts (carriers) that two hands share.
void share_posture(const StateHand& from, StateHand& to) {
  for (std::size_t i = 0; i < to.parts.size(); ++i)
    for (std::size_t k = 0; k < from.parts.size(); ++k) {
      if (to.parts[i] != from.parts[k]) continue;
      const std::vector<int>&target = to.built->hand.places[i],
            &source = from.built->hand.places[k];
      for (std::size_t c = 0; c < target.size(); ++c)
        to.placement.q[target[c]] = from.placement.q[source[c]];
    }
}

}  // namespace

WorldState empty_world(const std::string& name, const std::string& folder) {
  WorldSpec header;
  header.name = name;
  header.folder = folder;
  WorldState state;
  state.header = std::make_shared<const WorldSpec>(std::move(header));
  return state;
}

WorldSpec world_spec(const WorldState& state) {
  WorldSpec world = *state.header;
  world.hands = state.placed;
  for (const StateBody& body : state.bodies) {
    world.bodies.push_back(body.built->placed);
    world.bodies.back().X_WB = body.X_WB;
  }
  return world;
}

const std::string& hand_name(const WorldState& state, const StateHand& hand) {
  return state.placed[hand.parts.front()].name;
}

const std::string& root_name(const WorldState& state, const StateHand& hand) {
  return state.placed[hand.parts.back()].name;
}

std::vector<std::string> hand_names(const WorldState& state) {
  return transformed(state.hands, [&](const StateHand& hand) { return hand_name(state, hand); });
}

std::vector<std::string> object_names(const WorldState& state) {
  std::vector<std::string> names;
  for (const StateBody& body : state.bodies)
    if (body.built->placed.dynamic) names.push_back(body.built->placed.body.name);
  return names;
}

std::vector<std::string> body_names(const WorldState& state) {
  return transformed(state.bodies,
                     [&](const StateBody& body) { return body.built->placed.body.name; });
}

std::size_t hand_index(const WorldState& state, const std::string& name) {
  // Accept old names of versions of the human hand.
  const std::vector<std::string> names = hand_names(state);
  return entry_named(names, contains(names, name) ? name : current_hand_name(name), "hand");
}

std::size_t object_index(const WorldState& state, const std::string& name) {
  const std::vector<std::string> all = body_names(state), objects = object_names(state);
  require(!contains(all, name) || contains(objects, name),
          "body '{}' is an obstacle, wanted an object; there are {}", name, listed(objects));
  const std::string& found = objects[entry_named(objects, name, "object")];
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), found) - all.begin());
}

std::vector<std::string> carried_by(const std::vector<PlacedHand>& placed,
                                    const std::string& name) {
  std::vector<std::string> carried;
  for (const PlacedHand& each : placed)
    if (!each.carrier.empty() && current_hand_name(each.carrier) == current_hand_name(name))
      carried.push_back(each.name);
  return carried;
}

std::string free_name(const WorldState& state, const std::string& wanted) {
  std::vector<std::string> taken = body_names(state);
  append_all(taken, names_of(state.placed));
  if (!contains(taken, wanted)) return wanted;
  for (int number = 2;; ++number)
    if (std::string name = fmt::format("{} {}", wanted, number); !contains(taken, name))
      return name;
}

WorldState with_posture(WorldState state, std::size_t hand, const Eigen::VectorXd& q) {
  state.hands[hand].placement.q = q;
  for (std::size_t other = 0; other < state.hands.size(); ++other)
    if (other != hand) share_posture(state.hands[hand], state.hands[other]);
  write_posture(state, state.hands[hand]);
  return state;
}

WorldState with_hand_placed(WorldState state, std::size_t hand, const Pose<double>& X_WH) {
  // Move all hands on the same root.
  const std::size_t root = state.hands[hand].parts.back();
  for (StateHand& each : state.hands)
    if (each.parts.back() == root) each.placement.X_WH = X_WH;
  state.placed[root].X_WH = X_WH;
  return state;
}

StateBody build_state_body(const PlacedBody& placed) {
  auto built = std::make_shared<BuiltBody>();
  built->placed = placed;
  built->body = build_body(placed);
  built->picture = std::make_shared<const TriangleMesh>(built->body.solid.visual);
  built->ball = ball_around(*built->picture);
  return {std::move(built), placed.X_WB};
}

GraspSetup grasp_setup(const WorldState& state, std::size_t object) {
  // Copy the bodies with their current poses: one is the object, the others are obstacles.
  GraspSetup setup;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    GraspBody body = state.bodies[b].built->body;
    body.X_WB = state.bodies[b].X_WB;
    if (b == object)
      setup.object = std::move(body);
    else
      setup.obstacles.push_back(std::move(body));
  }
  setup.materials = state.header->materials;
  return setup;
}

}  // namespace thenar
