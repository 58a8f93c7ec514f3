#pragma once

/// Worlds by name, and their hands, built with the arms that carry them.

#include <optional>
#include <string>
#include <vector>

#include "api/named/hands.h"
#include "base/progress.h"
#include "data/io/world/world.h"
#include "grasp/closing/grasp.h"

namespace thenar {

/// Hand of a world, with its pose and posture.
struct WorldHand {
  NamedHand named;    // hand with its name and files
  Pose<double> X_WH;  // pose of its frame; of a mounted hand, of the frame of the last carrier
  Eigen::VectorXd q;  // of the world, else of the start of closing (coordinates)
  std::vector<std::size_t> parts;  // indices in WorldSpec::hands: the hand, what carries it, what
                                   // carries that..; empty: not of the world
  int carrier_surfaces = 0;        // number of leading Hand::surfaces() that belong to its carriers
  std::vector<std::vector<std::string>> names;  // names of each part's coordinates in worlds
  std::vector<std::vector<int>> places;         // indices of these coordinates in q
};

/// Options that select a world, a hand and an object in it.
struct WorldRequest {
  std::string world;         // a file, or the name of one of worlds/; required
  std::string hand, object;  // names; empty: the only ones
  std::string data;          // folder with worlds/, robots/ ..; empty: the usual ones
  bool pictures = false;     // build human hands for pictures, finer than for collisions
  PassiveMoments passive = PassiveMoments::kOn;  // for human hands whose names do not exclude them
  std::optional<Path> path;  // tendon paths of a human hand whose name states none; absent:
                             // default_path()
};

/// World with one of its hands and the setup of a grasp.
struct WorldCase {
  std::string path;               // path of the world
  std::vector<std::string> data;  // folders where hands are found by name
  WorldSpec world;                // world as its file states it
  WorldHand hand;                 // hand that grasps, in its pose and posture
  GraspSetup setup;               // object, obstacles and materials
  FileDigests files;              // digests of the files of the world, its bodies and the hand
};

/// Reads a world and builds the requested hand and setup.
/// @param hand_from_elsewhere  the hand is not part of the world: it is built by its name, its
/// joints are at the start of closing, and its pose is not set
/// @throws InputError or DataError where something is not to be found.
[[nodiscard]] WorldCase open_world(const WorldRequest& request, bool hand_from_elsewhere,
                                   const Progress& progress = {});

/// Returns the file of a named world. @throws InputError if there is none, or it is no thenar world
[[nodiscard]] std::string world_file(const WorldRequest& request);

/// Returns true if the world contains the named hand. @throws as open_world()
[[nodiscard]] bool has_hand(const WorldRequest& request);

/// Builds the hand called `name`; "": the only hand that carries no other.
///
/// A mounted hand is merged with its carriers into one robot; carriers without closing drives do
/// not move while it closes. Motors of carriers with unknown efforts are locked, with a warning.
/// Coordinates that the world does not state are at the start of closing. A posture may also name
/// degrees of freedom, each of which sets the joints it drives.
/// @param path   path of the world, for messages
/// @param data   folders with robots/, see data_for()
/// @param human  options of a human hand
/// @throws InputError if there is no such hand or no unique one, if a posture names an unknown
/// coordinate or exceeds limits, or if a human hand is mounted.
[[nodiscard]] WorldHand hand_of_world(const WorldSpec& world, const std::string& name,
                                      const std::string& path, const std::vector<std::string>& data,
                                      const HumanHandOptions& human = {});

/// Returns a hand built earlier by hand_of_world() with the pose and posture of another world that
/// has equal hands: nothing is rebuilt.
/// @throws InputError as hand_of_world()
[[nodiscard]] WorldHand reposed_hand(const WorldSpec& world, const std::string& name,
                                     const std::string& path, const std::vector<std::string>& data,
                                     WorldHand built);

/// Returns a sentence for each body without material: "no material is stated of body 'mug': plastic
/// is taken".
[[nodiscard]] std::vector<std::string> missing_material_warnings(const WorldSpec& world);

/// Returns data_folders() for a world read from `folder`, beside which there may be robots/.
[[nodiscard]] std::vector<std::string> data_for(const std::string& folder,
                                                const std::string& given);

/// Returns the world with the hand at this pose and posture.
[[nodiscard]] WorldSpec with_hand_at(WorldSpec world, const WorldHand& hand,
                                     const Pose<double>& X_WH, const Eigen::VectorXd& q);

/// Returns the world with the paths of its files relative to another folder.
[[nodiscard]] WorldSpec seen_from_folder(WorldSpec world, const std::string& folder);

/// Writes a world with the paths of its files relative to the folder of `path`.
/// @throws InputError if it cannot be written.
void save_world(WorldSpec world, const std::string& path);

}  // namespace thenar
