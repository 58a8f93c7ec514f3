#pragma once

/// Worlds by name, and their hands, built, with the arms that carry them.

#include <optional>
#include <string>
#include <vector>

#include "api/named/hands.h"
#include "base/progress.h"
#include "data/io/world/world.h"
#include "grasp/closing/grasp.h"

namespace thenar {

/// A hand of a world, in its place.
struct WorldHand {
  NamedHand named;
  Pose<double> X_WH;               // of its frame; of a mounted hand that of the last carrier
  Eigen::VectorXd q;               // as the world says, else where closing begins (coordinates)
  std::vector<std::size_t> parts;  // of WorldSpec::hands: the hand, what carries it, what carries
                                   // that..; empty: not of the world
  int carrier_surfaces = 0;        // the first of Hand::surfaces() are of what carries it
  std::vector<std::vector<std::string>> names;  // coordinates of each part, as worlds call them
  std::vector<std::vector<int>> places;         // and as entries of q
};

/// Options that select a world, a hand and an object in it.
struct WorldRequest {
  std::string world;         // a file, or the name of one of worlds/
  std::string hand, object;  // names; empty: the only ones
  std::string data;          // folder with worlds/, robots/ ..; empty: the usual ones
  bool pictures = false;     // whether it will be drawn: human hands finer than they touch
  PassiveMoments passive = PassiveMoments::kOn;  // of human hands whose names do not leave them out
  std::optional<Path> path;  // of tendons of a human hand whose name states none; absent:
                             // default_path()
};

/// A world with one of its hands, ready to be asked.
struct WorldCase {
  std::string path;               // of the world
  std::vector<std::string> data;  // folders where hands are found by name
  WorldSpec world;
  WorldHand hand;
  GraspSetup setup;
  FileDigests files;  // of the world, its bodies and the hand
};

/// Reads a world and builds the hand and the setup that are asked for.
/// @param hand_from_elsewhere  the hand is not one of the world's: it is built by its name, its
///                             joints are where closing begins, and it has no place yet
/// @throws InputError or DataError where something is not to be found.
[[nodiscard]] WorldCase open_world(const WorldRequest& request, bool hand_from_elsewhere,
                                   const Progress& progress = {});

/// Returns the file of a world that is named. @throws InputError if there is none, or it is no
/// world of ours
[[nodiscard]] std::string world_file(const WorldRequest& request);

/// Returns true if the world has the hand that is named. @throws as open_world()
[[nodiscard]] bool has_hand(const WorldRequest& request);

/// Builds the hand called `name`; "": the only one that carries no other.
///
/// A hand that is mounted becomes one robot with its carriers, which stand still while it closes if
/// nothing closes them; those of their motors whose efforts are unknown are locked, with a warning.
/// Coordinates that the world does not name are where closing begins. Besides coordinates a posture
/// may name degrees of freedom, each of which sets the joints it drives.
/// @param path   of the world, for messages
/// @param data   folders with robots/, as data_for()
/// @param human  how to build a human hand
/// @throws InputError if there is no such hand or more than one to choose from, if a posture names
///         what the hand has not or leaves its limits, or if a human hand is mounted.
[[nodiscard]] WorldHand hand_of_world(const WorldSpec& world, const std::string& name,
                                      const std::string& path, const std::vector<std::string>& data,
                                      const HumanHandOptions& human = {});

/// Returns a hand that hand_of_world() built before, as another world has it whose hands of these
/// names are the same: nothing is built again.
/// @throws InputError as hand_of_world()
[[nodiscard]] WorldHand hand_as_in(const WorldSpec& world, const std::string& name,
                                   const std::string& path, const std::vector<std::string>& data,
                                   WorldHand built);

/// Returns "no material is stated of body 'mug': plastic is taken", a sentence for each such body.
[[nodiscard]] std::vector<std::string> bare_body_warnings(const WorldSpec& world);

/// Returns data_folders() for a world read from `folder`: beside worlds/ there may be robots/.
[[nodiscard]] std::vector<std::string> data_for(const std::string& folder,
                                                const std::string& given);

/// Returns the world with the hand where it is found, in its posture.
[[nodiscard]] WorldSpec with_hand_at(WorldSpec world, const WorldHand& hand,
                                     const Pose<double>& X_WH, const Eigen::VectorXd& q);

/// Returns the world with the files that it names as seen from another folder.
[[nodiscard]] WorldSpec seen_from_folder(WorldSpec world, const std::string& folder);

/// Writes a world so that what its files are relative to is the folder of `path`.
/// @throws InputError if it cannot be written.
void save_world(WorldSpec world, const std::string& path);

}  // namespace thenar
