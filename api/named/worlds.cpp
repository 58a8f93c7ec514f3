#include "api/named/worlds.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/named/data_folders.h"
#include "api/named/files.h"
#include "api/named/material_names.h"
#include "api/named/portable_world.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/name_hint.h"
#include "base/nearest_name.h"
#include "base/words.h"
#include "data/io/robot/import_robot.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/robot/infer_hand.h"
#include "grasp/robot/robot_hand.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

using Places = std::vector<std::string>;  // folders searched for data

constexpr int kSmoothTriangles = 2500;  // Triangles of a link that look smooth
// Largest excess over joint limits, as closing has it [rad] or [m]
constexpr double kLimitExcess = 1e-9;

HumanHandOptions human_of(const WorldRequest& request, const Progress& progress) {
  HumanHandOptions human;
  human.passive = request.passive;
  human.path = request.path;
  human.skin.drawn = request.pictures ? kSmoothTriangles : 0;
  human.skin.progress = progress;
  return human;
}

std::string beside(const WorldSpec& world, const std::string& file) {
  return (fs::path(world.folder) / file).string();
}

/// Returns the name by which hand_by_name() knows a placed hand: a subject's file with its version.
std::string name_to_build(const WorldSpec& world, const PlacedHand& placed) {
  if (placed.file.empty()) return placed.name;
  return beside(world, placed.file) + version_of_hand(placed.name);
}

/// The robot's file, for mounting. @throws InputError if it is no robot.
std::string file_of(const WorldSpec& world, const PlacedHand& placed, const Places& data) {
  if (!placed.file.empty()) return beside(world, placed.file);
  const std::optional<std::string> library = robot_file(placed.name, data);
  require(library.has_value(), "hand '{}' is mounted, or carries another: it must be a robot; {}",
          placed.name, places_words(data));
  return *library;
}

std::size_t index_of(const WorldSpec& world, const std::string& name) {
  const std::string wanted = current_hand_name(name);
  for (std::size_t i = 0; i < world.hands.size(); ++i)
    if (current_hand_name(world.hands[i].name) == wanted) return i;
  return world.hands.size();
}

std::vector<std::string> names_of(const WorldSpec& world) {
  return transformed(world.hands,
                     [&](const PlacedHand& hand) { return current_hand_name(hand.name); });
}

bool carries(const WorldSpec& world, const std::string& name) {
  return any_of(world.hands, [&](const PlacedHand& hand) { return hand.carrier == name; });
}

std::size_t chosen(const WorldSpec& world, const std::string& name, const std::string& path) {
  const std::string listed = fmt::format("{}", fmt::join(names_of(world), ", "));
  // A name has to be one of the world's.
  if (!name.empty()) {
    const std::size_t index = index_of(world, name);
    require_field("hand", index < world.hands.size(), "{}: the world has no hand '{}'{} it has {}",
                  path, name, hint_before_list(name, names_of(world)),
                  world.hands.empty() ? "none" : listed);
    return index;
  }
  // Without a name there must be exactly one hand that carries no other.
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < world.hands.size(); ++i)
    if (!carries(world, world.hands[i].name)) free.push_back(i);
  require_field("hand", !free.empty(), "{}: the world has no hand; wanted one", path);
  require_field("hand", free.size() == 1, "{}: the world has the hands {}; wanted one of them",
                path, listed);
  return free.front();
}

/// The hand, then everything that carries it.
std::vector<std::size_t> parts_of(const WorldSpec& world, std::size_t index) {
  std::vector<std::size_t> parts{index};
  while (!world.hands[parts.back()].carrier.empty()) {
    parts.push_back(index_of(world, world.hands[parts.back()].carrier));
    require(parts.size() <= world.hands.size(), "hand '{}' is carried by itself",
            world.hands[index].name);
  }
  return parts;
}

/// Locks the idle motors of a carrier whose efforts are unknown; notes that there
/// were some.
RobotSpec locked_where_unknown(RobotSpec carrier, std::vector<std::string>& locked) {
  bool found = false;
  for (RobotDof& dof : carrier.dofs) {
    if (dof.speed != 0 || (dof.max_effort > 0 && !dof.nominal_effort)) continue;
    dof.backdrivable = false;
    found = true;
  }
  if (found) locked.push_back(carrier.name);
  return carrier;
}

/// One robot of a hand and its carriers, from the last of them to the hand.
void mount(const WorldSpec& world, const Places& data, WorldHand& mounted) {
  // Start with the lowest carrier, which is fixed in the world.
  const std::vector<std::size_t>& parts = mounted.parts;
  const PlacedHand& last = world.hands[parts.back()];
  std::vector<std::string> locked;
  RobotSpec robot = locked_where_unknown(import_robot(file_of(world, last, data)), locked);
  require_closed_loops(robot);
  NamedHand& hand = mounted.named;
  // The robot is called after the hand and its carrier.
  hand.name = world.hands[parts.front()].name + " on " + last.name;
  hand.file = file_of(world, world.hands[parts.front()], data);
  // Attach part after part, each to the link that carries it; the hand comes last.
  for (std::size_t i = parts.size() - 1; i-- > 0;) {
    const PlacedHand& placed = world.hands[parts[i]];
    RobotSpec tool = import_robot(file_of(world, placed, data));
    tool = i == 0 ? graspable(std::move(tool)) : locked_where_unknown(std::move(tool), locked);
    // Surfaces of carriers come first, so that the hand's own begin at this index.
    if (i == 0)
      mounted.carrier_surfaces = static_cast<int>(
          std::count_if(robot.links.begin(), robot.links.end(),
                        [](const RobotLink& link) { return !link.shapes.empty(); }));
    robot = attach(robot, placed.carrier_link, tool, placed.X_WH);
  }
  robot = with_materials(std::move(robot));
  hand.hand = std::make_shared<RobotHand>(robot);
  hand.warnings = robot.warnings;
  hand.files = robot.files;
  // Warn of locked motors, which resist any torque and so make loads look too large.
  if (!locked.empty())
    hand.warnings.push_back(
        fmt::format("motors of {} with unknown effort limits are treated as locked; their strength "
                    "does not limit any load",
                    fmt::join(locked, " and ")));
}

/// Finds the indices of a part's coordinates in a mounted hand: by their own name, or with the
/// robot's name before it where a carrier has the same coordinate.
std::vector<int> places_of(const std::vector<std::string>& part, const std::string& robot,
                           const std::vector<std::string>& whole, std::vector<bool>& taken) {
  std::vector<int> places;
  for (const std::string& name : part) {
    // A robot's own coordinates may need its name before them to be unique.
    auto found = std::find(whole.begin(), whole.end(), fmt::format("{}/{}", robot, name));
    // A robot may carry another of its own kind, whose coordinates these are then.
    const auto index = static_cast<std::size_t>(found - whole.begin());
    if (index == whole.size() || taken[index]) found = std::find(whole.begin(), whole.end(), name);
    const auto at = static_cast<std::size_t>(found - whole.begin());
    require(at < whole.size() && !taken[at], "coordinate '{}' of '{}' is not to be found", name,
            robot);
    taken[at] = true;
    places.push_back(static_cast<int>(at));
  }
  return places;
}

void add_names(const WorldSpec& world, WorldHand& hand, const Places& data) {
  // Each coordinate of the mounted hand belongs to exactly one part.
  const std::vector<std::string>& whole = hand.named.hand->layout().coordinates;
  std::vector<bool> taken(whole.size(), false);
  for (const std::size_t part : hand.parts) {
    std::vector<std::string> names = whole;
    std::string robot;
    // A single hand keeps its own names; parts of a mounted one are read again for theirs.
    if (hand.parts.size() > 1) {
      const RobotSpec spec = import_robot(file_of(world, world.hands[part], data));
      names = RobotHand(spec).layout().coordinates;
      robot = spec.name;
    }
    hand.places.push_back(places_of(names, robot, whole, taken));
    hand.names.push_back(std::move(names));
  }
}

/// Returns the change of a robot's coordinates per unit of a degree of freedom (coordinates); empty
/// if no degree of freedom has that name.
Eigen::VectorXd motion_of_dof(const WorldSpec& world, const PlacedHand& placed,
                              const std::string& name, const Places& data) {
  // The built-in human has joints alone.
  if (placed.name.rfind("human", 0) == 0 && placed.file.empty()) return {};
  const RobotSpec robot = import_robot(file_of(world, placed, data));
  // One unit of this motor, nothing of the others: the posture is the direction in which it moves
  // the joints.
  const int dof = place_named(robot.dofs, name);
  if (dof < 0) return {};
  const auto dofs = static_cast<Eigen::Index>(robot.dofs.size());
  return RobotHand(robot).posture(Eigen::VectorXd::Unit(dofs, dof));
}

void require_within(const WorldHand& hand, const std::string& path) {
  const HandLayout& layout = hand.named.hand->layout();
  for (int c = 0; c < hand.q.size(); ++c)
    require(
        hand.q[c] >= layout.lower[c] - kLimitExcess && hand.q[c] <= layout.upper[c] + kLimitExcess,
        "{}: hand '{}': {} is {:.6g}, outside its limits {:.6g} .. {:.6g} (rad or m)", path,
        hand.named.name, layout.coordinates[static_cast<std::size_t>(c)], hand.q[c],
        layout.lower[c], layout.upper[c]);
}

void set_posture(const WorldSpec& world, const std::string& path, const Places& data,
                 WorldHand& hand) {
  // Joints that the posture does not name stay open.
  hand.q = open_posture(hand.named.hand->layout());
  for (std::size_t i = 0; i < hand.parts.size(); ++i) {
    // A name is a coordinate, or else a motor that moves several of them in fixed ratios.
    const PlacedHand& placed = world.hands[hand.parts[i]];
    for (const auto& [name, value] : placed.posture) {
      const auto found = std::find(hand.names[i].begin(), hand.names[i].end(), name);
      const auto at = static_cast<std::size_t>(found - hand.names[i].begin());
      if (found != hand.names[i].end()) {
        hand.q[hand.places[i][at]] = value;
        continue;
      }
      const Eigen::VectorXd motion = motion_of_dof(world, placed, name, data);
      require(motion.size() > 0, "{}: hand '{}' has no coordinate '{}'{} it has {}", path,
              placed.name, name, hint_before_list(name, hand.names[i]),
              fmt::join(hand.names[i], ", "));
      // Set only joints that the motor moves, so that motors do not undo each other.
      for (Eigen::Index c = 0; c < motion.size(); ++c)
        if (motion[c] != 0) hand.q[hand.places[i][static_cast<std::size_t>(c)]] = motion[c] * value;
    }
  }
  require_within(hand, path);
}

std::string rebased(const std::string& file, const fs::path& from, const fs::path& to) {
  if (file.empty() || fs::path(file).is_absolute()) return file;
  return fs::proximate(fs::absolute(from / file).lexically_normal(), fs::absolute(to))
      .generic_string();
}

}  // namespace

std::string world_file(const WorldRequest& request) {
  // Accept a path or a name of the data, and refuse other kinds of files.
  std::string file =
      requested_file("world", "world", request.world, "worlds", request.data,
                     "a world puts a hand and an object together: docs/tutorials/own_gripper.md");
  // Size of the start of its text: a byte order mark and blank lines may lead [bytes]
  constexpr std::size_t kTextStartBytes = 4096;
  // Worlds of GraspIt! are XML, and have to be imported first.
  require_field("world", first_sign(read_start(file, kTextStartBytes)) != '<',
                "'{}' is a world of GraspIt!: `thenar import` makes one of it that is read here",
                file);
  return file;
}

WorldCase open_world(const WorldRequest& request, bool hand_from_elsewhere,
                     const Progress& progress) {
  WorldCase found;
  // Read the world and place its object.
  found.path = world_file(request);
  found.world = read_world_at(found.path, request.data);
  found.files = found.world.files;
  found.data = data_for(found.world.folder, request.data);
  found.setup = in_field("object", [&] { return build_setup(found.world, request.object); });
  // Use the hand of the world, mounted on its carriers.
  const HumanHandOptions human = human_of(request, progress);
  if (!hand_from_elsewhere) {
    found.hand = hand_of_world(found.world, request.hand, found.path, found.data, human);
  } else {
    // A hand from elsewhere starts open; a planner gives it its place.
    found.hand.named =
        in_field("hand", [&] { return hand_by_name(request.hand, found.data, human); });
    found.hand.q = open_posture(found.hand.named.hand->layout());
  }
  found.files.insert(found.hand.named.files.begin(), found.hand.named.files.end());
  require_materials(found.hand.named, found.setup.materials);
  return found;
}

bool has_hand(const WorldRequest& request) {
  const std::vector<std::string> names = names_of(read_world_at(world_file(request), request.data));
  return contains(names, current_hand_name(request.hand));
}

std::vector<std::string> data_for(const std::string& folder, const std::string& given) {
  return data_folders(given, fs::path(folder).lexically_normal().parent_path().string());
}

WorldHand hand_of_world(const WorldSpec& world, const std::string& name, const std::string& path,
                        const std::vector<std::string>& data, const HumanHandOptions& human) {
  WorldHand hand;
  // A hand on an arm is built as one robot, because the arm's joints move it.
  hand.parts = parts_of(world, chosen(world, name, path));
  const PlacedHand& placed = world.hands[hand.parts.front()];
  if (hand.parts.size() > 1) {
    mount(world, data, hand);
  } else {
    hand.named = hand_by_name(name_to_build(world, placed), data, human);
    hand.named.name = current_hand_name(placed.name);
  }
  // Use the pose of the lowest carrier, which is fixed.
  hand.X_WH = world.hands[hand.parts.back()].X_WH;
  add_names(world, hand, data);
  set_posture(world, path, data, hand);
  append_all(hand.named.warnings, missing_material_warnings(world));
  return hand;
}

WorldHand reposed_hand(const WorldSpec& world, const std::string& name, const std::string& path,
                       const std::vector<std::string>& data, WorldHand built) {
  built.parts = parts_of(world, chosen(world, name, path));
  built.X_WH = world.hands[built.parts.back()].X_WH;
  set_posture(world, path, data, built);
  return built;
}

std::vector<std::string> missing_material_warnings(const WorldSpec& world) {
  std::vector<std::string> warnings;
  for (const PlacedBody& placed : world.bodies)
    if (placed.body.material.empty())
      warnings.push_back(fmt::format("no material is stated of body '{}': {} is taken",
                                     placed.body.name, kDefaultMaterial));
  return warnings;
}

WorldSpec with_hand_at(WorldSpec world, const WorldHand& hand, const Pose<double>& X_WH,
                       const Eigen::VectorXd& q) {
  for (std::size_t i = 0; i < hand.parts.size(); ++i) {
    PlacedHand& placed = world.hands[hand.parts[i]];
    placed.posture.clear();
    for (std::size_t c = 0; c < hand.names[i].size(); ++c)
      placed.posture[hand.names[i][c]] = q[hand.places[i][c]];
  }
  if (!hand.parts.empty()) world.hands[hand.parts.back()].X_WH = X_WH;
  return world;
}

WorldSpec seen_from_folder(WorldSpec world, const std::string& folder) {
  const fs::path from = world.folder, to = folder.empty() ? "." : folder;
  for (PlacedHand& hand : world.hands) hand.file = rebased(hand.file, from, to);
  for (PlacedBody& body : world.bodies) {
    body.file = rebased(body.file, from, to);
    for (ShapeSpec& shape : body.body.shapes) shape.mesh_file = rebased(shape.mesh_file, from, to);
  }
  world.materials_file = rebased(world.materials_file, from, to);
  world.folder = folder;
  return world;
}

}  // namespace thenar
