#pragma once

/// Hands as commands name them.

#include <memory>
#include <string>
#include <vector>

#include "base/provenance.h"
#include "grasp/closing/closing_drives.h"
#include "hand/hand.h"
#include "hand_versions/human_hand.h"

namespace thenar {

/// A hand and what is known of it beyond Hand. Robots have no patches and no targets.
struct NamedHand {
  std::string name;  // as asked for, with old names of versions replaced: current_hand_name()
  std::string file;  // that it was built from; empty: the built-in human
  std::shared_ptr<const Hand> hand;
  ContactModel contact = ContactModel::kHardPoint;
  std::vector<SkinPatch> patches;            // pads and nails of a human hand
  std::vector<OppositionTarget> targets;     // of Kapandji's score, of a human hand
  ClosingRates rates;                        // of a hand that tendons close; empty: its drives do
  std::shared_ptr<const Skeleton> skeleton;  // of a human hand; null: a robot
  Path path = Path::kNone;                   // of a human hand: HumanHand::path
  std::vector<std::string> warnings;         // what was assumed or left out
  FileDigests files;                         // that were read for it
};

/// Data from which a hand of a given name is built.
struct HandSource {
  bool human = false;   // of a subject; else a robot
  std::string file;     // empty: the built-in human
  std::string version;  // of a human hand: one of kHumanVersionNames
  std::string path;     // of its tendons: "via", "fitted" or "wrapped"; empty: default_path()
  PassiveMoments passive = PassiveMoments::kOn;  // of its joints
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
/// @throws InputError naming the hands there are, if there is none of that name, or what a file is
///         that is no hand; DataError where a file is wrong.
[[nodiscard]] HandSource find_hand(const std::string& name, const std::vector<std::string>& places);

/// Builds the hand that find_hand() finds. Paths that its name states prevail over those of the
/// options. @throws InputError, DataError as find_hand()
[[nodiscard]] NamedHand hand_by_name(const std::string& name,
                                     const std::vector<std::string>& places,
                                     const HumanHandOptions& options = {});

/// Returns the name of a hand, with an old name of its version replaced: "human:tier4:via" becomes
/// "human:tendons:via". Other names stay as they are.
[[nodiscard]] std::string current_hand_name(const std::string& name);

/// Returns the end of a name that says which version of a human hand is meant, and which tendon
/// paths:
/// ":tendons:via"; "" if it says none.
[[nodiscard]] std::string version_of_hand(const std::string& name);

/// Returns the file of the robot of that name, PLACE/robots/NAME.toml; "" if there is none.
[[nodiscard]] std::string robot_file(const std::string& name,
                                     const std::vector<std::string>& places);

}  // namespace thenar
