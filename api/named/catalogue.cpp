#include "api/named/catalogue.h"

#include <array>

#include <fmt/format.h>

#include "api/named/data_folders.h"
#include "api/named/material_names.h"
#include "api/named/things.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/units.h"
#include "data/io/json_node.h"
#include "data/io/toml_node.h"
#include "hand_versions/human_hand.h"

namespace thenar {
namespace {

/// A text, or the texts of a list: "Synek2019, An1979".
std::string words_of(const TomlNode* node) {
  if (node == nullptr) return "";
  if (node->kind != TomlKind::kArray) return node->text;
  const std::vector<std::string> texts =
      transformed(node->items, [&](const TomlNode& item) { return item.text; });
  return texts.empty() ? "" : listed(texts);
}

/// Title and sources as the file states them.
void add_title(const std::string& path, CatalogueEntry& entry) {
  const SourceText file = read_source(path);
  // Contacts are JSON, where a name takes the place of a description.
  if (entry.kind == "contacts") {
    const auto members = text_members(parse_json(path, file.text), {});
    const auto name = members.find("name");
    if (name != members.end() && !name->second.empty()) entry.about = name->second.front();
    return;
  }
  const TomlNode top = parse_toml(file.text, path);
  entry.about = words_of(top.find("description"));
  entry.source = words_of(top.find("source"));
}

void add_files(const ThingKind& kind, const std::vector<std::string>& places, Catalogue& out) {
  for (const std::string& name : names_in(places, kind.folder, kind.ending)) {
    // Robots are listed as hands, since their files hold a palm with digits.
    CatalogueEntry entry{kind.kind == "robot" ? "hand" : kind.kind, name, "", "",
                         find_in(places, kind.folder + "/" + name + kind.ending)};
    // A broken file is listed all the same, with its error as a warning.
    try {
      add_title(entry.file, entry);
    } catch (const DataError& error) {
      out.warnings.emplace_back(error.what());
    }
    out.entries.push_back(std::move(entry));
  }
}

/// The built-in human hand in its versions, as hand_by_name() knows them.
void add_human_hands(Catalogue& out) {
  constexpr std::array kTitles{
      EnumName{HumanVersion::kOrthogonalThumb, "Human hand, thumb axes at right angles"},
      EnumName{HumanVersion::kSkewedThumb, "Human hand, thumb axes as measured"},
      EnumName{HumanVersion::kSoftPads, "Human hand, axes as measured, soft pads"},
      EnumName{HumanVersion::kTendonNet, "Human hand, moved by tendons with extensor nets"}};
  for (const auto& [version, title] : kTitles)
    out.entries.push_back({"hand", "human:" + name_in(kHumanVersionNames, version), title});
}

std::string limits_of(double lower, double upper, bool slides) {
  const double unit = slides ? kMm : kDegree;
  return fmt::format("{:.4g} .. {:.4g} {}", lower / unit, upper / unit, slides ? "mm" : "deg");
}

void add_joints(const Subject& subject, Catalogue& out) {
  for (const JointAxis& joint : subject.joints)
    out.entries.push_back(
        {"joint", joint.name,
         fmt::format("{} on {}, {}", joint.child, joint.parent,
                     joint.coupling ? "follows another joint"
                                    : limits_of(joint.lower, joint.upper, false))});
}

void add_joints(const RobotSpec& robot, Catalogue& out) {
  for (const RobotJoint& joint : robot.joints) {
    if (joint.kind == RobotJointKind::kFixed) continue;
    out.entries.push_back(
        {"joint", joint.name,
         fmt::format("{} on {}, {}{}", joint.child, joint.parent,
                     limits_of(joint.lower, joint.upper, joint.kind == RobotJointKind::kPrismatic),
                     joint.dof.empty() ? "" : ", driven by " + joint.dof)});
  }
}

void add_muscles(const Subject& subject, Catalogue& out) {
  for (const MuscleUnit& muscle : subject.muscles)
    out.entries.push_back(
        {"muscle", muscle.name,
         fmt::format("{}F0 {}", muscle.strand.empty() ? "" : "strand " + muscle.strand + ", ",
                     muscle.max_force ? fmt::format("{:.4g} N", *muscle.max_force) : "unknown")});
}

void add_digits(const Subject& subject, Catalogue& out) {
  for (const Digit& digit : subject.digits) out.entries.push_back({"digit", digit.name});
  for (const TipMap& map : subject.tip_maps)
    out.entries.push_back({"digit", map.digit, fmt::format("published tip map {}", map.name)});
}

/// Parts of a subject or a robot.
void add_parts(const CatalogueRequest& request, Catalogue& out) {
  // Parts belong to one subject or robot, which has to be named.
  require(!request.of.empty(), "wanted a subject: thenar list {} SUBJECT", request.what);
  const Thing thing = read_thing(named_thing(request.of, request.data));
  const auto* subject = std::get_if<Subject>(&thing);
  const auto* robot = std::get_if<RobotSpec>(&thing);
  require(subject != nullptr || (robot != nullptr && request.what == "joints"),
          "wanted a subject{}, got '{}'", request.what == "joints" ? " or a robot" : "",
          request.of);
  // A robot has joints, but neither muscles nor digits with tendons.
  if (robot != nullptr) return add_joints(*robot, out);
  if (request.what == "joints") add_joints(*subject, out);
  if (request.what == "muscles") add_muscles(*subject, out);
  if (request.what == "digits") add_digits(*subject, out);
}

void add_materials(const std::string& file, Catalogue& out) {
  for (const Material& material : materials_of_file(file).materials)
    out.entries.push_back(
        {"material", material.name,
         material.density > 0 ? fmt::format("{:.4g} kg/m3", material.density) : ""});
}

}  // namespace

std::vector<std::string> catalogue_words() {
  std::vector<std::string> words =
      transformed(thing_kinds(), [&](const ThingKind& kind) { return kind.plural; });
  words.insert(words.end(), {"materials", "joints", "muscles", "digits"});
  return words;
}

Catalogue list_names(const CatalogueRequest& request) {
  Catalogue out;
  // Words are checked against those of the catalogue, with the nearest one as a hint.
  if (!request.what.empty()) (void)index_of_name(request.what, catalogue_words(), "list");
  if (request.what == "joints" || request.what == "muscles" || request.what == "digits") {
    add_parts(request, out);
    return out;
  }
  require(request.of.empty(), "'{}' are listed as they are; leave out '{}'", request.what,
          request.of);
  // List the data folders kind by kind; built-in hands come before those of files.
  const std::vector<std::string> places = data_folders(request.data);
  for (const ThingKind& kind : thing_kinds()) {
    if (!request.what.empty() && request.what != kind.plural) continue;
    if (kind.kind == "robot") add_human_hands(out);
    add_files(kind, places, out);
  }
  if (request.what.empty() || request.what == "materials") add_materials(request.materials, out);
  return out;
}

}  // namespace thenar
