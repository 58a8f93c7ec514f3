#pragma once

/// A world that is being edited, as a value: copies are cheap, so that every step of an edit can be
/// kept.

#include <memory>
#include <string>
#include <vector>

#include "grasp/closing/setup.h"
#include "live/world/live_hand.h"

namespace thenar {

/// A body of a live world, built; constant. Where it stands is said in StateBody.
struct BuiltBody {
  PlacedBody placed;
  GraspBody body;
  std::shared_ptr<const TriangleMesh> picture;
  Ball ball;  // around the picture, body frame [m]
};

struct StateBody {
  std::shared_ptr<const BuiltBody> built;  // shared by the steps of an edit
  Pose<double> X_WB;
};

/// A hand, or an arm without one, with all that carries it.
struct StateHand {
  std::shared_ptr<const LiveHand> built;  // shared by the steps of an edit
  std::vector<std::size_t> parts;         // of WorldState::placed: the hand, what carries it, ..
  HandStand stand;                        // of the last of these parts
};

/// Content of a world file, and the things built from it.
struct WorldState {
  std::shared_ptr<const WorldSpec> header;  // name, sources, materials, camera, folder; no things
  std::string file;                         // that it was read from or saved to; empty: none
  std::vector<PlacedHand> placed;           // as world files have them
  std::vector<StateHand> hands;
  std::vector<StateBody> bodies;
};

/// A world without anything in it. @param folder  to which its files are relative
[[nodiscard]] WorldState empty_world(const std::string& name, const std::string& folder);

/// The world as its file says it, files relative to its folder.
[[nodiscard]] WorldSpec spec_of(const WorldState& state);

/// Name of a hand of the state; of a mounted one, of the hand itself.
[[nodiscard]] const std::string& name_of(const WorldState& state, const StateHand& hand);
/// Name of what the whole chain of a mounted hand stands on; of a free hand its own.
[[nodiscard]] const std::string& root_of(const WorldState& state, const StateHand& hand);

[[nodiscard]] std::vector<std::string> hand_names(const WorldState& state);
[[nodiscard]] std::vector<std::string> object_names(const WorldState& state);  // obstacles left out
[[nodiscard]] std::vector<std::string> body_names(const WorldState& state);

/// Entry of WorldState::hands. @param name  empty: the only one
/// @throws InputError naming those that there are
[[nodiscard]] std::size_t hand_index(const WorldState& state, const std::string& name);
/// Entry of WorldState::bodies of an object. @param name  empty: the only one
/// @throws InputError naming those that there are, or if it is an obstacle
[[nodiscard]] std::size_t object_index(const WorldState& state, const std::string& name);

/// The name of a new thing: "mug", or where that is taken "mug 2", "mug 3" ..
[[nodiscard]] std::string free_name(const WorldState& state, const std::string& wanted);

/// The state with a hand in another posture, which is written out in full from then on. Hands that
/// share an arm move together.
/// @param hand  of WorldState::hands;  @param q  within limits (coordinates)
[[nodiscard]] WorldState with_posture(WorldState state, std::size_t hand, const Eigen::VectorXd& q);

/// The state with a hand, or what carries it, elsewhere.
[[nodiscard]] WorldState with_hand_placed(WorldState state, std::size_t hand,
                                          const Pose<double>& X_WH);

/// A body, its solid built. @throws InputError as build_body()
[[nodiscard]] StateBody built_body(const PlacedBody& placed);

/// The hand and its obstacles as closing asks for them: obstacles are all other bodies.
/// @param object  of WorldState::bodies
[[nodiscard]] GraspSetup setup_of(const WorldState& state, std::size_t object);

}  // namespace thenar
