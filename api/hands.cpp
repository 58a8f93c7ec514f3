#include "api/hands.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/data_folders.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/interrupt.h"
#include "base/nearest_name.h"
#include "base/rung_names.h"
#include "data/io/file_kind.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/import_robot.h"
#include "grasp/closing/tendon_closing.h"
#include "grasp/robot/infer_hand.h"
#include "grasp/robot/robot_hand.h"
#include "tendons/human/closing_synergy.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHuman = "human";
constexpr const char* kTendons = "tier4";  // whose hands close by their tendons

NamedHand human(const std::string& name, const Subject& subject, const std::string& tier,
                const HumanHandOptions& options) {
  HumanHand built = build_human_hand(subject, human_tier(tier), options);
  NamedHand hand;
  hand.name = name;
  hand.hand = std::move(built.hand);
  hand.contact = built.contact;
  hand.patches = std::move(built.patches);
  hand.targets = std::move(built.targets);
  hand.warnings = std::move(built.warnings);
  if (tier == kTendons)
    hand.rates = tendon_closing_rates(*hand.hand, max_flexor_tensions(*hand.hand));
  return hand;
}

/// Reading a robot keeps nothing, and may take seconds: a signal ends it at once.
RobotSpec read_robot(const std::string& file) {
  const SignalsEndAtOnce at_once;
  return graspable(import_robot(file));
}

NamedHand robot(const std::string& name, const std::string& file) {
  const RobotSpec spec = read_robot(file);
  NamedHand hand;
  hand.name = name;
  hand.file = file;
  hand.hand = std::make_shared<RobotHand>(spec);
  hand.warnings = spec.warnings;
  return hand;
}

/// Of a file with or without a tier. @throws InputError if it is neither a subject nor a robot
HandSource file_source(const std::string& file, const std::string& tier, const std::string& path) {
  require(
      !is_mesh_file(file),
      "'{}' is a mesh and no hand: wanted a robot (TOML, URDF, MJCF, GraspIt! XML) or a subject",
      file);
  if (fs::path(file).extension() == ".toml") {
    const FileKind kind = find_file_kind(file);
    if (kind == FileKind::kSubject) return {true, file, tier.empty() ? "tier2" : tier, path};
    require(kind == FileKind::kRobot, "'{}' is a file of kind '{}': wanted a robot or a subject",
            file, name_of(kind));
  }
  require(tier.empty(), "'{}' is a robot and has no {}", file, tier);
  return {false, file, "", ""};
}

/// A name, its tier and its tendon paths; the last two may be empty.
struct HandName {
  std::string base, tier, path;
};
HandName split_name(const std::string& name) {
  const std::size_t tier = name.rfind(":tier");
  if (tier == std::string::npos) return {name, "", ""};
  const std::size_t path = name.find(':', tier + 1);
  if (path == std::string::npos) return {name.substr(0, tier), name.substr(tier + 1), ""};
  return {name.substr(0, tier), name.substr(tier + 1, path - tier - 1), name.substr(path + 1)};
}

}  // namespace

std::string robot_file(const std::string& name, const std::vector<std::string>& places) {
  if (name.empty() || name.find('/') != std::string::npos) return "";
  return find_in(places, (fs::path("robots") / (name + ".toml")).string());
}

HandSource find_hand(const std::string& name, const std::vector<std::string>& places) {
  const auto [base, tier, path] = split_name(name);
  if (!path.empty()) (void)path_named(path);  // refuses others
  if (base == kHuman) return {true, "", tier.empty() ? kTendons : tier, path};
  if (is_file(base)) return file_source(base, tier, path);
  const std::string library = robot_file(base, places);
  if (!library.empty()) return file_source(library, tier, path);
  std::vector<std::string> known = names_in(places, "robots");
  for (const char* each : {"human:tier1", "human:tier2", "human:tier3", "human:tier4"})
    known.push_back(each);
  throw InputError(fmt::format("there is no hand '{}'{}; there are {}, and files; {}", name,
                               did_you_mean(name, known), fmt::join(known, ", "),
                               places_words(places)));
}

NamedHand hand_by_name(const std::string& name, const std::vector<std::string>& places,
                       const HumanHandOptions& options) {
  const HandSource source = find_hand(name, places);
  if (!source.human) return robot(name, source.file);
  const Subject subject = source.file.empty() ? default_human() : read_subject(source.file);
  HumanHandOptions human_options = options;
  if (!source.path.empty()) human_options.path = path_named(source.path);
  NamedHand hand = human(name, subject, source.tier, human_options);
  hand.file = source.file;
  return hand;
}

}  // namespace thenar
