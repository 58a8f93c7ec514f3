#pragma once

/// Hands by the names that commands accept.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/provenance.h"
#include "grasp/closing/closing_drives.h"
#include "hand/hand.h"
#include "hand_versions/human_hand.h"

namespace thenar {

/// Hand with its name, origin and further data. Robots have no patches and no targets.
struct NamedHand {
  std::string name;  // requested name, with old version names replaced: current_hand_name()
  std::string file;  // file that the hand was built from; empty: the built-in human
  std::shared_ptr<const Hand> hand;                 // never null
  ContactModel contact = ContactModel::kHardPoint;  // contact model of its surfaces
  std::vector<SkinPatch> patches;                   // pads and nails of a human hand
  std::vector<OppositionTarget> targets;            // targets of Kapandji's score, for a human hand
  ClosingRates rates;  // closing rates of a hand that tendons close; empty: its drives close it
  std::shared_ptr<const Skeleton> skeleton;  // skeleton of a human hand; null: a robot
  Path path = Path::kNone;                   // HumanHand::path of a human hand
  std::vector<std::string> warnings;         // assumptions and omissions
  FileDigests files;                         // digests of the files that were read for it
};

/// Data from which a hand of a given name is built.
struct HandSource {
  bool human = false;                   // true: a subject; false: a robot
  std::string file;                     // empty: the built-in human
  std::optional<HumanVersion> version;  // version of a human hand; absent: a robot
  std::optional<Path> path;             // tendon paths of a human hand; absent: default_path()
  PassiveMoments passive = PassiveMoments::kOn;  // passive moments of its joints
};

/// Returns the hand called
///   "human:orthogonal", "human:skewed", "human:soft", "human:tendons"
///                            a version of default_human(); "human" is "human:tendons"
///   "FILE.toml:skewed" ..    the same of a subject file; without a version it is "skewed", which
///                            needs no tendons
///   "human:tendons:via"      the same on another model of tendon paths: via, fitted or wrapped; if
///                            left out, wrapped where its tendons name surfaces
///   "human:skewed:passive-off", "human:tendons:via:passive-off"
///                            the same without passive moments of joints
///   "human:tier1" ..         the old names of the four versions, in this order
///   "barrett"                robots/barrett.toml of the first place that has it
///   a path                   a robot of any kind that import_robot() reads
/// @param places  folders with robots/, as data_folders()
/// @throws InputError listing all hands if there is none of that name, or stating the kind of a
/// file that is no hand; DataError if a file is wrong.
[[nodiscard]] HandSource find_hand(const std::string& name, const std::vector<std::string>& places);

/// Builds the hand that find_hand() finds. Tendon paths in its name take precedence over the
/// options. @throws InputError, DataError as find_hand()
[[nodiscard]] NamedHand hand_by_name(const std::string& name,
                                     const std::vector<std::string>& places,
                                     const HumanHandOptions& options = {});

/// Returns the name of a hand with an old version name replaced: "human:tier4:via" becomes
/// "human:tendons:via". Other names stay as they are.
[[nodiscard]] std::string current_hand_name(const std::string& name);

/// Returns the suffix of a name that states the version of a human hand and its tendon paths:
/// ":tendons:via"; "" if there is none.
[[nodiscard]] std::string version_of_hand(const std::string& name);

/// Returns the file of the robot of that name, PLACE/robots/NAME.toml; absent: there is none.
[[nodiscard]] std::optional<std::string> robot_file(const std::string& name,
                                                    const std::vector<std::string>& places);

}  // namespace thenar
