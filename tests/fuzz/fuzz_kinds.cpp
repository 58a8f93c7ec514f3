#include "tests/fuzz/fuzz_kinds.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "base/file_io.h"
#include "data/io/anthropometry.h"
#include "data/io/checked_file.h"
#include "data/io/contact_file.h"
#include "data/io/experiment.h"
#include "data/io/file_kind.h"
#include "data/io/fit_settings.h"
#include "data/io/inference_file.h"
#include "data/io/json_node.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/net_description.h"
#include "data/io/pad/law_file.h"
#include "data/io/pad/pad.h"
#include "data/io/pad/pad_data.h"
#include "data/io/result_file.h"
#include "data/io/robot/import_robot.h"
#include "data/io/robot/urdf.h"
#include "data/io/scene/scene.h"
#include "data/io/subject.h"
#include "data/io/world/graspit_body.h"
#include "data/io/world/graspit_world.h"
#include "data/io/world/materials.h"
#include "data/io/world/world.h"
#include "geometry/repair_to_solid.h"
#include "grasp/compare/comparison_file.h"
#include "tests/data/mesh/cube_files.h"
#include "tests/data/robot/sample_files.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

std::string bytes_in(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Files of the data folder, by their paths in it.
std::vector<FuzzSeed> data_files(const std::vector<std::string>& names) {
  std::vector<FuzzSeed> seeds;
  for (const std::string& name : names)
    seeds.push_back({fs::path(name).filename(), bytes_in(THENAR_DATA_DIR "/" + name)});
  // Worlds name robots and objects, and materials laws, by where they stand in that folder.
  for (FuzzSeed& seed : seeds) {
    for (std::size_t at = 0; (at = seed.text.find("\"../", at)) != std::string::npos;)
      seed.text.replace(at, 4, "\"" THENAR_DATA_DIR "/");
    for (std::size_t at = 0; (at = seed.text.find("\"pads/", at)) != std::string::npos;)
      seed.text.replace(at, 1, "\"" THENAR_DATA_DIR "/");
  }
  return seeds;
}

const char* const kGraspitWorld = R"(<?xml version="1.0" ?>
<world><graspableBody><filename>seg.xml</filename>
<transform><fullTransform>(+0.6 +0 +0.8 +0)[+1 +2 -100]</fullTransform></transform></graspableBody>
<obstacle><filename>seg.off</filename>
<transform><translation>1 2 3</translation><rotation>30 y</rotation></transform></obstacle>
<robot><filename>hand.xml</filename><dofValues>+0.1 +0.2 +0 +10</dofValues></robot>
<robot><filename>hand.xml</filename><dofValues>+0.1 +0.2 +1 -0.3 +0.2 +10</dofValues></robot>
<connection><parentRobot>0</parentRobot><parentChain>1</parentChain><childRobot>1</childRobot>
<transform><translation>0 0 50</translation></transform></connection>
<camera><position>0 0 400</position><orientation>0 0 0 1</orientation>
<focalDistance>300</focalDistance></camera></world>)";

const char* const kContacts = R"({"centre_of_mass": [0, 0, 0.01], "torque_scale": 0.03,
"contacts": [{"position": [0.03, 0, 0], "normal": [-1, 0, 0], "friction": 0.6},
{"position": [-0.03, 0, 0], "normal": [1, 0, 0], "friction": 0.6, "torsion": 0.004},
{"wrenches": [[0, 0, 1, 0, 0, 0.01], [0, 1, 0, 0.01, 0, 0]]}]})";

/// One hand on one object.
std::string comparison_text() {
  HandOnObject cell;
  cell.hand = "a";
  cell.object = "b";
  cell.approaches = 2;
  cell.closures = 1;
  cell.outcomes[0] = 2;
  cell.success = 0.5;
  cell.epsilon = Eigen::VectorXd::Constant(1, 0.1);
  cell.hand_epsilon = Eigen::VectorXd::Constant(1, 0.2);
  cell.types = {{"pinch", 1}};
  BestGrasp best;
  best.type = "pinch";
  best.q = Eigen::Vector2d(0.1, 0.2);
  best.margin = {{name_of(GraspTask::kHoldWeight), 2.0}};
  best.contacts.resize(1);
  cell.best = {best};
  Comparison comparison;
  comparison.cells = {cell};
  JsonNode file = comparison_node(comparison);
  file.set("inputs", JsonNode(JsonKind::kObject));
  return written(file, 1);
}

/// With a checksum that holds, whatever was changed: else nothing behind it is reached.
void read_comparison_file(const std::string& path) {
  JsonNode file = parse_json(path, bytes_in(path));
  if (file.kind == JsonKind::kObject) {
    file.set("sha256", comparison_checksum(file));
    write_file(path, written(file));
  }
  (void)read_comparison(path, JsonNode(JsonKind::kObject),
                        [](const std::string& name) { return name; });
}

std::string result_bytes(const std::string& folder) {
  ResultFile file;
  file.add("group/matrix", Eigen::MatrixXd::Constant(3, 2, 0.5), "N", {"trial", "component"});
  file.add("number", 1.0 / 3, "1");
  file.add("text", std::string("two\nlines"));
  file.add("list", std::vector<std::string>{"a", "b"});
  write_result(file, folder + "/seed.h5");
  return bytes_in(folder + "/seed.h5");
}

std::string posterior_bytes(const std::string& folder) {
  InferenceFile file;
  file.attributes = {{"seed", "7"}};
  InferenceGroup& group = file.groups["posterior"];
  group.lengths = {{"chain", 2}, {"draw", 3}, {"parameter", 2}};
  group.coordinates["parameter"] = {"a", "b"};
  group.arrays["x"] = {
      std::vector<double>(12, 0.5), {"chain", "draw", "parameter"}, "mm", "", false, false};
  group.arrays["d"] = {{0, 1, 0, 0, 0, 1}, {"chain", "draw"}, "1", "", false, true};
  write_inference(file, folder + "/seed.nc");
  return bytes_in(folder + "/seed.nc");
}

/// The bytes without their checksum, wherever it stands now.
std::string unsealed(const std::string& path) {
  std::string bytes = bytes_in(path);
  return bytes.erase(std::min(bytes.rfind("\nthenar sha256 "), bytes.size()));
}

// Whoever changes a file may seal it anew.
void read_result_file(const std::string& path) {
  write_file(path, with_checksum(unsealed(path)));
  (void)read_result(path);
}
void read_posterior_file(const std::string& path) {
  write_file(path, with_checksum(unsealed(path)));
  (void)read_inference(path);
}

/// What is imported can also be written.
void read_robot_file(const std::string& path) {
  const RobotSpec robot = import_robot(path);
  (void)robot_toml(robot);
  (void)robot_urdf(robot, "");
}

void read_mesh_file(const std::string& path) { (void)repair_to_solid(read_mesh(path)); }

void read_graspit(const std::string& path) {
  const std::string text = bytes_in(path);
  if (text.find("<world") != std::string::npos) {
    (void)world_toml(read_graspit_world(path).world);
  } else if (text.find("<robot") != std::string::npos) {
    read_robot_file(path);
  } else {
    (void)object_toml(read_graspit_body(path).body);
  }
}

std::vector<FuzzSeed> mesh_seeds() {
  return {{"a.obj", cube_obj()},
          {"a.stl", cube_stl()},
          {"b.stl", cube_binary_stl()},
          {"a.ply", cube_ply()},
          {"b.ply", cube_binary_ply()},
          {"a.off", cube_off()},
          {"a.gltf", cube_gltf()},
          {"a.dae", cube_collada()},
          {"a.wrl", cube_vrml1()},
          {"b.wrl", cube_vrml2()},
          {"a.iv", cube_vrml1("#Inventor V2.1 ascii")}};
}

}  // namespace

std::vector<FuzzKind> fuzz_kinds(const std::string& folder) {
  write_file(folder + "/seg.off", sample::wedge_off());
  write_file(folder + "/seg.xml", sample::graspit_body_file());
  write_file(folder + "/hand.xml", sample::graspit_file());
  using File = const std::string&;
  return {
      {"subject",
       data_files({"subjects/valero_cuevas_index.toml", "subjects/arms_thumb.toml",
                   "subjects/an_chao_index.toml", "subjects/graspit_skewed_thumb.toml"}),
       [](File path) { (void)read_subject(path); }},
      {"experiment", data_files({"experiments/synek2019_B01.toml"}),
       [](File path) { (void)read_experiment(path); }},
      {"fit settings", data_files({"fits/five_axis_skewed.toml", "fits/finger.toml"}),
       [](File path) { (void)read_fit_settings(path); }},
      {"proportions", data_files({"anthropometry/buchholz1992.toml"}),
       [](File path) { (void)read_proportions(path); }},
      {"net", data_files({"nets/chao_an.toml"}), [](File path) { (void)read_net(path); }},
      {"robot",
       data_files({"robots/parallel_jaw.toml", "robots/xr4000.toml", "robots/barrett.toml"}),
       read_robot_file},
      {"object", data_files({"objects/key.toml", "objects/egg.toml", "objects/bobbin.toml"}),
       [](File path) { (void)object_toml(read_object(path)); }},
      {"world", data_files({"worlds/jaw_box.toml", "worlds/barrett_bobbin.toml"}),
       [](File path) { (void)world_toml(read_world(path)); }},
      {"scene",
       data_files({"scenes/swinging_pinch.toml", "scenes/wine_glass.toml",
                   "scenes/spinning_top.toml", "scenes/loose_joint.toml"}),
       [](File path) { (void)read_scene(path); }},
      {"pad", data_files({"pads/index_pad.toml"}), [](File path) { (void)read_pad(path); }},
      {"pad_laws", data_files({"pads/laws/index_pad.toml"}),
       [](File path) { (void)read_laws(path); }},
      {"pad_presses", data_files({"presses/index_published.toml"}),
       [](File path) { (void)read_pad_data(path); }},
      {"materials", data_files({"materials.toml"}), [](File path) { (void)read_materials(path); }},
      {"contacts", {{"a.json", kContacts}}, [](File path) { (void)read_contact_file(path); }},
      {"comparison", {{"a.json", comparison_text()}}, read_comparison_file},
      {"urdf", {{"a.urdf", sample::urdf_file()}}, read_robot_file},
      {"mjcf", {{"a.xml", sample::mjcf_file()}}, read_robot_file},
      {"graspit",
       {{"a.xml", sample::graspit_file()},
        {"b.xml", sample::graspit_body_file()},
        {"c.xml", kGraspitWorld}},
       read_graspit},
      {"mesh", mesh_seeds(), read_mesh_file},
      {"result", {{"a.h5", result_bytes(folder)}}, read_result_file},
      {"posterior", {{"a.nc", posterior_bytes(folder)}}, read_posterior_file},
  };
}

void read_harmlessly(const FuzzKind& kind, const std::string& path) {
  try {
    kind.read(path);
  } catch (const Error& error) {
    if (std::string(error.what()).size() > 100'000)
      throw std::logic_error("a message of " + std::to_string(std::string(error.what()).size()) +
                             " bytes");
  }
}

}  // namespace thenar
