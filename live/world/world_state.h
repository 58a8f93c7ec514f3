#pragma once

/// State of a world under edit, as a value: copies are cheap, so that the states before all edits
/// can be kept.

#include <memory>
#include <string>
#include <vector>

#include "grasp/closing/setup.h"
#include "live/world/live_hand.h"

namespace thenar {

/// Geometry of a body of a live world; constant. StateBody holds its pose.
struct BuiltBody {
  PlacedBody placed;
  GraspBody body;
  std::shared_ptr<const TriangleMesh> picture;
  Ball ball;  // ball that encloses the picture, body frame [m]
};

/// Body of a world state.
struct StateBody {
  std::shared_ptr<const BuiltBody> built;  // shared by all states
  Pose<double> X_WB;
};

/// Hand of a world state, or an arm without a hand, with its carriers.
struct StateHand {
  std::shared_ptr<const LiveHand> built;  // shared by all states
  std::vector<std::size_t> parts;         // entries of WorldState::placed: hand, its carrier, ..
  HandPlacement placement;                // pose of the last carrier, posture of all parts
};

/// Content of a world file, and the models built from it.
struct WorldState {
  std::shared_ptr<const WorldSpec> header;  // name, sources, materials, camera, folder; no things
  std::string file;                         // file it was read from or saved to; empty: none
  std::vector<PlacedHand> placed;           // hands and carriers as in world files
  std::vector<StateHand> hands;
  std::vector<StateBody> bodies;
};

/// Creates a world without hands and bodies. @param folder  folder that its paths are relative to
[[nodiscard]] WorldState empty_world(const std::string& name, const std::string& folder);

/// Returns the world as its file states it, with paths relative to its folder.
[[nodiscard]] WorldSpec world_spec(const WorldState& state);

/// Returns the name of a hand; for a mounted hand, that of the hand and not of its carriers.
[[nodiscard]] const std::string& hand_name(const WorldState& state, const StateHand& hand);
/// Returns the name of the carrier at the root of a mounted hand; for a free hand, its own name.
[[nodiscard]] const std::string& root_name(const WorldState& state, const StateHand& hand);

[[nodiscard]] std::vector<std::string> hand_names(const WorldState& state);
[[nodiscard]] std::vector<std::string> object_names(const WorldState& state);  // obstacles left out
[[nodiscard]] std::vector<std::string> body_names(const WorldState& state);

/// Returns the index of the named hand in WorldState::hands. @param name  empty: the only hand
/// @throws InputError with the names of all hands if no hand has this name, or if the name is empty
///         and there is not exactly one hand
[[nodiscard]] std::size_t hand_index(const WorldState& state, const std::string& name);
/// Returns the index of the named object in WorldState::bodies. @param name  empty: the only object
/// @throws InputError with the names of all objects if no object has this name, if it is an
///         obstacle, or if the name is empty and there is not exactly one object
[[nodiscard]] std::size_t object_index(const WorldState& state, const std::string& name);

/// Returns the names of the hands of a list that are mounted on a hand.
[[nodiscard]] std::vector<std::string> carried_by(const std::vector<PlacedHand>& placed,
                                                  const std::string& name);

/// Returns a name that is not in use: "mug", or if that is taken "mug 2", "mug 3" ..
[[nodiscard]] std::string free_name(const WorldState& state, const std::string& wanted);

/// Returns the state with a hand in another posture, and all joints of that hand stated in
/// `placed`. Other hands on the same arm move with it.
/// @param hand  entry of WorldState::hands
/// @param q     posture within the limits [rad] or [m] (coordinates)
[[nodiscard]] WorldState with_posture(WorldState state, std::size_t hand, const Eigen::VectorXd& q);

/// Returns the state with a free hand, or the root carrier of a mounted hand, in another pose.
/// @param hand  entry of WorldState::hands
[[nodiscard]] WorldState with_hand_placed(WorldState state, std::size_t hand,
                                          const Pose<double>& X_WH);

/// Builds the geometry of a body. @throws InputError as build_body()
[[nodiscard]] StateBody build_state_body(const PlacedBody& placed);

/// Returns the setup for grasping an object; all other bodies are obstacles.
/// @param object  entry of WorldState::bodies
[[nodiscard]] GraspSetup grasp_setup(const WorldState& state, std::size_t object);

}  // namespace thenar
