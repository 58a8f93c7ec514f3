#include "api/named/hands.h"

#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/named/data_folders.h"
#include "api/named/files.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/interrupt.h"
#include "base/name_hint.h"
#include "base/rung_names.h"
#include "data/io/file_kind.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/import_robot.h"
#include "grasp/closing/tendon_closing.h"
#include "grasp/robot/infer_hand.h"
#include "grasp/robot/robot_hand.h"
#include "hand_versions/closing_synergy.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHuman = "human";

NamedHand human(const std::string& name, const Subject& subject, HumanVersion version,
                const HumanHandOptions& options) {
  // Build the hand, then move its parts into the common form.
  HumanHand built = build_human_hand(subject, version, options);
  NamedHand hand;
  hand.name = name;
  hand.hand = std::move(built.hand);
  hand.contact = built.contact;
  hand.path = built.path;
  hand.patches = std::move(built.patches);
  hand.skeleton = std::make_shared<const Skeleton>(std::move(built.skeleton));
  hand.targets = std::move(built.targets);
  hand.warnings = std::move(built.warnings);
  // Tendons close the hand at rates that the flexors' largest tensions give; other versions close
  // joint by joint.
  if (version == HumanVersion::kTendonNet)
    hand.rates = tendon_closing_rates(*hand.hand, max_flexor_tensions(*hand.hand));
  return hand;
}

/// Reading a robot keeps nothing, and may take seconds: a signal ends it at once.
RobotSpec read_graspable(const std::string& file) {
  const SignalsEndAtOnce at_once;
  return graspable(import_robot(file));
}

NamedHand robot(const std::string& name, const std::string& file) {
  const RobotSpec spec = read_graspable(file);
  NamedHand hand;
  hand.name = name;
  hand.file = file;
  hand.hand = std::make_shared<RobotHand>(spec);
  hand.warnings = spec.warnings;
  hand.files = spec.files;
  return hand;
}

/// Returns the source of a hand's file, with or without a version. @throws InputError if the file
/// is neither a subject nor a robot
HandSource file_source(const std::string& file, std::optional<HumanVersion> version,
                       std::optional<Path> path) {
  require(
      !is_mesh_file(file),
      "'{}' is a mesh and no hand: wanted a robot (TOML, URDF, MJCF, GraspIt! XML) or a subject",
      file);
  // Only TOML files can be subjects; all other formats are robots.
  if (fs::path(file).extension() == ".toml") {
    require_kind(file, {"robot", "subject"});
    const FileKind kind = find_file_kind(file);
    // A file without a version has the richest one that needs no tendons.
    if (kind == FileKind::kSubject)
      return {true, file, version.value_or(HumanVersion::kSkewedThumb), path};
  }
  require(!version, "'{}' is a robot and has no version '{}'", file,
          version ? name_in(kHumanVersionNames, *version) : "");
  return {false, file, {}, {}};
}

constexpr const char* kPassiveOff = "passive-off";

/// A name, its version and its tendon paths; the last two may be empty.
struct HandName {
  std::string base, version, path;
  PassiveMoments passive = PassiveMoments::kOn;
};

/// Splits the suffix of a version: tendon paths, passive moments off, or both.
void read_tail(const std::string& tail, HandName& name) {
  const std::size_t end = tail.rfind(':');
  const std::string last = end == std::string::npos ? tail : tail.substr(end + 1);
  name.path = tail;
  if (last != kPassiveOff) return;
  name.passive = PassiveMoments::kOff;
  name.path = end == std::string::npos ? "" : tail.substr(0, end);
}

HandName split_name(const std::string& name) {
  // The last word between colons that is a version: files may have colons in their names.
  for (std::size_t at = name.rfind(':'); at != std::string::npos && at > 0;
       at = name.rfind(':', at - 1)) {
    const std::size_t path = name.find(':', at + 1);
    const std::string word = name.substr(at + 1, path == std::string::npos ? path : path - at - 1);
    // Skip words that are no version, such as parts of a path.
    if (!is_human_version(word)) continue;
    HandName found{name.substr(0, at), word, ""};
    if (path != std::string::npos) read_tail(name.substr(path + 1), found);
    return found;
  }
  return {name, "", ""};
}

}  // namespace

std::optional<std::string> robot_file(const std::string& name,
                                      const std::vector<std::string>& places) {
  if (name.empty() || name.find('/') != std::string::npos) return {};
  const std::string file = find_in(places, (fs::path("robots") / (name + ".toml")).string());
  return file.empty() ? std::nullopt : std::optional(file);
}

namespace {

/// The source without a word on passive moments.
HandSource find_source(const std::string& name, const HandName& parts,
                       const std::vector<std::string>& places) {
  // Understand old names of versions, and refuse unknown paths before anything is read.
  const std::string& base = parts.base;
  std::optional<HumanVersion> version;
  std::optional<Path> path;
  if (!parts.version.empty()) version = human_version(parts.version);
  if (!parts.path.empty()) path = path_named(parts.path);
  // The built-in human, then a file, then a name in the data folders.
  if (base == kHuman) return {true, "", version.value_or(HumanVersion::kTendonNet), path};
  if (is_file(base)) return file_source(base, version, path);
  if (const auto library = robot_file(base, places)) return file_source(*library, version, path);
  // A hand that there is, with a version that there is not.
  if (const std::size_t colon = name.rfind(':'); colon != std::string::npos)
    if (const std::string whose = name.substr(0, colon); whose == kHuman || is_file(whose))
      (void)human_version(name.substr(colon + 1));
  std::vector<std::string> known = names_in(places, "robots");
  for (const auto& [each, word] : kHumanVersionNames)
    known.push_back(std::string(kHuman) + ":" + word);
  throw InputError(fmt::format("there is no hand '{}'{} there are {}, and files; {}", name,
                               hint_before_list(name, known), fmt::join(known, ", "),
                               places_words(places)));
}

}  // namespace

HandSource find_hand(const std::string& name, const std::vector<std::string>& places) {
  const HandName parts = split_name(name);
  HandSource found = find_source(name, parts, places);
  found.passive = parts.passive;
  return found;
}

std::string current_hand_name(const std::string& name) {
  const auto [base, version, path, passive] = split_name(name);
  if (version.empty()) return name;
  return base + ":" + name_in(kHumanVersionNames, human_version(version)) +
         (path.empty() ? "" : ":" + path) +
         (passive == PassiveMoments::kOn ? "" : std::string(":") + kPassiveOff);
}

std::string version_of_hand(const std::string& name) {
  return name.substr(split_name(name).base.size());
}

NamedHand hand_by_name(const std::string& name, const std::vector<std::string>& places,
                       const HumanHandOptions& options) {
  // A robot is complete in its file; a human hand needs a version and its options.
  const HandSource source = find_hand(name, places);
  if (!source.human) return robot(name, source.file);
  const Subject subject = source.file.empty() ? default_human() : read_subject(source.file);
  // Words behind the name take precedence over options of the request.
  HumanHandOptions human_options = options;
  if (source.path) human_options.path = source.path;
  if (source.passive == PassiveMoments::kOff) human_options.passive = source.passive;
  NamedHand hand = human(current_hand_name(name), subject, *source.version, human_options);
  hand.file = source.file;
  if (!source.file.empty()) hand.files = digests_of({source.file});
  return hand;
}

}  // namespace thenar
