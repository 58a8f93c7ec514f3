#include "data/io/scene/scene.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/nearest_name.h"
#include "data/io/mesh/shape_toml.h"
#include "data/io/scene/scene_keys.h"
#include "data/io/world/world_keys.h"

namespace thenar {
namespace {

SceneBodySpec read_scene_body(TomlTable& table, const SceneSpec& scene,
                              const std::vector<std::string>& places) {
  SceneBodySpec body;
  body.line = table.line();
  body.placed = internal::read_placed_body(table, scene.path, scene.materials, places);
  body.joint = internal::read_scene_joint(table, JointKind::kFree);
  body.velocity = internal::read_scene_velocity(table, body.joint.kind);
  return body;
}

SceneHandSpec read_scene_hand(TomlTable& table, const SceneSpec& scene,
                              const std::vector<std::string>& places) {
  SceneHandSpec hand;
  hand.line = table.line();
  hand.placed.name = table.text("name");
  if (table.has("file")) {
    hand.placed.file =
        internal::file_or_name(table, "file", scene.folder, {"robots", "subjects"}, places);
    hand.version = table.text_or("version", "");
  }
  // The number of skin triangles trades the accuracy of contacts for time.
  if (table.has(Dimension::kNumber, "skin_triangles")) {
    const double triangles = table.number(Dimension::kNumber, "skin_triangles");
    if (!(triangles >= 100 && triangles <= 10000))
      table.fail(fmt::format("wanted 'skin_triangles' from 100 to 10000, got {:g}", triangles),
                 "skin_triangles");
    hand.skin_triangles = static_cast<int>(triangles);
  }
  if (table.has("skin")) {
    const std::string skin = table.text("skin");
    if (skin != "triangles" && skin != "capsules")
      table.fail(fmt::format("wanted 'skin' triangles or capsules, got '{}'", skin), "skin");
    hand.skin_capsules = skin == "capsules";
  }
  if (table.has("passive")) hand.passive = table.choice("passive", {"on", "off"}) == "on";
  hand.placed.X_WH = read_pose_keys(table);
  hand.placed.posture = internal::read_posture(table);
  hand.joint = internal::read_scene_joint(table, JointKind::kWeld);
  hand.velocity = internal::read_scene_velocity(table, hand.joint.kind);
  return hand;
}

/// Names of a scene's bodies, hands and their parts, with the lines of the file.
class SceneNames {
 public:
  explicit SceneNames(const SceneSpec& scene) : path_(scene.path) {
    for (const SceneBodySpec& body : scene.bodies) add(body.placed.body.name, body.line);
    for (const SceneHandSpec& hand : scene.hands) {
      add(hand.placed.name, hand.line);
      hands_.push_back(hand.placed.name);
    }
  }

  /// Refuses what is neither a body, nor a hand, nor something of a hand.
  void need(const std::string& name, int line) const {
    if (names_.count(name) > 0 || !hand_of(name).empty()) return;
    throw DataError(path_, line,
                    fmt::format("there is no body or hand '{}'{}", name,
                                did_you_mean(name, {names_.begin(), names_.end()})));
  }

  /// Refuses a hand as a whole where one body is wanted.
  void need_body(const std::string& name, int line) const {
    need(name, line);
    if (std::count(hands_.begin(), hands_.end(), name) > 0)
      throw DataError(path_, line,
                      fmt::format("'{0}' is a hand: name one of its links, '{0}/LINK'", name));
  }

  /// Refuses what is no hand.
  void need_hand(const std::string& name, int line) const {
    if (std::count(hands_.begin(), hands_.end(), name) > 0) return;
    throw DataError(path_, line,
                    fmt::format("there is no hand '{}'{}", name, did_you_mean(name, hands_)));
  }

  /// The body or hand that a name belongs to.
  [[nodiscard]] std::string owner_of(const std::string& name) const {
    const std::string hand = hand_of(name);
    return hand.empty() ? name : hand;
  }

 private:
  void add(const std::string& name, int line) {
    if (!names_.insert(name).second)
      throw DataError(path_, line, fmt::format("two things are called '{}'", name));
  }

  /// The hand of "HAND/LINK"; empty if there is none of that name.
  [[nodiscard]] std::string hand_of(const std::string& name) const {
    for (const std::string& hand : hands_)
      if (name.size() > hand.size() + 1 && name.compare(0, hand.size() + 1, hand + "/") == 0)
        return hand;
    return "";
  }

  std::string path_;
  std::set<std::string> names_;
  std::vector<std::string> hands_;
};

/// Refuses parents that are not there, and chains of parents that come back.
void check_parents(const SceneSpec& scene, const SceneNames& names) {
  // Follow parents until the world or a joint that is known to lead there.
  std::map<std::string, const SceneJointSpec*> joints;
  for (const SceneBodySpec& body : scene.bodies) joints[body.placed.body.name] = &body.joint;
  for (const SceneHandSpec& hand : scene.hands) joints[hand.placed.name] = &hand.joint;
  for (const auto& [name, joint] : joints)
    if (!joint->parent.empty()) names.need_body(joint->parent, joint->line);
  std::set<const SceneJointSpec*> grounded;  // their parents lead to the world
  for (const auto& [name, joint] : joints) {
    std::vector<const SceneJointSpec*> chain{joint};
    while (!chain.back()->parent.empty() && grounded.count(chain.back()) == 0) {
      if (chain.size() > joints.size())
        throw DataError(scene.path, joint->line,
                        fmt::format("the parents of '{}' lead back to themselves", name));
      chain.push_back(joints.at(names.owner_of(chain.back()->parent)));
    }
    grounded.insert(chain.begin(), chain.end());
  }
}

/// Refuses pads on or against what is not there, and two between the same bodies.
void check_pads(const SceneSpec& scene, const SceneNames& names) {
  std::set<std::pair<std::string, std::string>> pairs;
  for (const ScenePadSpec& pad : scene.pads) {
    names.need_body(pad.on, pad.line);
    for (const std::string& other : pad.against) {
      names.need_body(other, pad.line);
      if (!pairs.insert(std::minmax(pad.on, other)).second)
        throw DataError(scene.path, pad.line,
                        fmt::format("'{}' and '{}' meet in two pads", pad.on, other));
    }
  }
}

/// Refuses names that nothing has.
void check_references(const SceneSpec& scene, const SceneNames& names) {
  for (const SceneForceSpec& force : scene.forces) names.need_body(force.body, force.line);
  for (const SceneDriveSpec& drive : scene.drives) names.need_body(drive.coordinate, drive.line);
  std::set<std::string> compliant;
  for (const SceneComplianceSpec& compliance : scene.compliances) {
    names.need_body(compliance.joint, compliance.line);
    if (!compliant.insert(compliance.joint).second)
      throw DataError(scene.path, compliance.line,
                      fmt::format("the compliance of '{}' is given twice", compliance.joint));
  }
  const auto need_both = [&](const auto& tie) {
    names.need_body(tie.to, tie.line);
    if (!tie.from.empty()) names.need_body(tie.from, tie.line);
  };
  for (const SceneLigamentSpec& ligament : scene.ligaments) need_both(ligament);
  for (const SceneBushingSpec& bushing : scene.bushings) need_both(bushing);
  check_pads(scene, names);
  for (const SceneMuscleSpec& muscle : scene.muscles) names.need_hand(muscle.hand, muscle.line);
  for (const SceneApartSpec& apart : scene.apart)
    for (const std::string& name : apart.between) names.need(name, apart.line);
  int others = 0;
  for (const SceneFrictionSpec& friction : scene.frictions) {
    for (const std::string& name : friction.between) names.need(name, friction.line);
    if (friction.between.empty() && ++others > 1)
      throw DataError(scene.path, friction.line,
                      "two [[friction]] are for all pairs: name two bodies, 'between'");
  }
}

}  // namespace

void check_scene_spec(const SceneSpec& scene) {
  if (scene.bodies.empty() && scene.hands.empty())
    throw DataError(scene.path, 1, "a scene needs something that moves: [[body]] or [[hand]]");
  const SceneNames names(scene);
  check_parents(scene, names);
  check_references(scene, names);
}

SceneSpec parse_scene(const std::string& text, const std::string& path,
                      const std::vector<std::string>& places) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  // Header, gravity and materials.
  SceneSpec scene;
  scene.path = path;
  scene.folder = std::filesystem::path(path).parent_path().string();
  scene.name = top.text("name");
  scene.description = top.text_or("description", "");
  scene.source = top.source();
  scene.gravity = top.vector_or(Dimension::kAcceleration, "gravity", scene.gravity);
  scene.materials_file = top.text_or("materials", "");
  scene.materials = internal::read_materials_key(top, scene.folder);
  if (top.has("camera")) scene.camera = internal::read_camera(top);
  // Bodies and hands, and what acts on them.
  read_each(top, "hand", scene.hands, read_scene_hand, scene, places);
  read_each(top, "body", scene.bodies, read_scene_body, scene, places);
  read_each(top, "force", scene.forces, internal::read_scene_force);
  read_each(top, "drive", scene.drives, internal::read_scene_drive, scene.folder);
  for (const bool tensions : {true, false})
    read_each(top, tensions ? "tendon" : "muscle", scene.muscles, internal::read_scene_muscle,
              tensions, scene.folder);
  read_each(top, "friction", scene.frictions, internal::read_scene_friction);
  read_each(top, "apart", scene.apart, internal::read_scene_apart);
  read_each(top, "compliance", scene.compliances, internal::read_scene_compliance);
  read_each(top, "ligament", scene.ligaments, internal::read_scene_ligament);
  read_each(top, "bushing", scene.bushings, internal::read_scene_bushing);
  read_each(top, "pad", scene.pads, internal::read_scene_pad, scene.folder);
  // Time.
  TomlTable stepping =
      needed_table(top, "stepping", "a scene needs [stepping] with its 'duration'");
  scene.stepping = internal::read_stepping(stepping);
  top.done();
  check_scene_spec(scene);
  return scene;
}

SceneSpec read_scene(const std::string& path, const std::vector<std::string>& places) {
  SceneSpec scene = parse_scene(read_text_file(path), path, places);
  scene.files = digests_of({path});
  const auto add_linked = [&](const std::string& file) {
    if (!file.empty())
      scene.files.merge(digests_of({(std::filesystem::path(scene.folder) / file).string()}));
  };
  add_linked(scene.materials_file);
  scene.files.insert(scene.materials.files.begin(), scene.materials.files.end());
  for (const SceneBodySpec& body : scene.bodies)
    scene.files.insert(body.placed.body.files.begin(), body.placed.body.files.end());
  for (const ScenePadSpec& pad : scene.pads) scene.files.insert(pad.files.begin(), pad.files.end());
  for (const SceneMuscleSpec& muscle : scene.muscles) add_linked(muscle.file);
  for (const SceneDriveSpec& drive : scene.drives) add_linked(drive.target_file);
  return scene;
}

}  // namespace thenar
