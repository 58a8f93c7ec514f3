#pragma once

/// Hands as commands name them.

#include <memory>
#include <string>
#include <vector>

#include "grasp/closing/close_hand.h"
#include "hand/hand.h"
#include "tendons/human/human_hand.h"

namespace thenar {

/// A hand and what is known of it beyond Hand. Of robots there are no patches and no targets.
struct NamedHand {
  std::string name;  // as asked for
  std::string file;  // that it was built from; empty: the built-in human
  std::shared_ptr<const Hand> hand;
  ContactModel contact = ContactModel::kHardPoint;
  std::vector<SkinPatch> patches;         // pads and nails of a human hand
  std::vector<OppositionTarget> targets;  // of Kapandji's score, of a human hand
  ClosingRates rates;                     // of a hand that tendons close; empty: its drives do
  std::vector<std::string> warnings;      // what was assumed or left out
};

/// What builds a hand of a name.
struct HandSource {
  bool human = false;  // of a subject; else a robot
  std::string file;    // empty: the built-in human
  std::string tier;    // of a human hand: "tier1" .. "tier4"
  std::string path;    // of its tendons: "via", "fitted" or "wrapped"; empty: via
};

/// The hand called
///   "human:tier1" .. "human:tier4"  a version of default_human(); "human" is tier 4
///   "FILE.toml:tier1" ..            the same of a subject file; without a tier it is tier 2, which
///                                   needs no tendons
///   "human:tier4:wrapped" ..        the same on another model of tendon paths: via (if left out),
///                                   fitted or wrapped
///   "barrett"                       robots/barrett.toml of the first place that has it
///   a path                          a robot of any kind that import_robot() reads
/// @param places  folders with robots/, as data_folders()
/// @throws InputError naming the hands there are, if there is none of that name, or what a file is
///         that is no hand; DataError where a file is wrong.
[[nodiscard]] HandSource find_hand(const std::string& name, const std::vector<std::string>& places);

/// find_hand(), built. @throws InputError, DataError as it
[[nodiscard]] NamedHand hand_by_name(const std::string& name,
                                     const std::vector<std::string>& places,
                                     const HumanHandOptions& human = {});

/// The file of the robot of that name, PLACE/robots/NAME.toml; "" if there is none.
[[nodiscard]] std::string robot_file(const std::string& name,
                                     const std::vector<std::string>& places);

}  // namespace thenar
