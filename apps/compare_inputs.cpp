#include "apps/compare_inputs.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "api/data_folders.h"
#include "api/files.h"
#include "base/error.h"
#include "base/provenance.h"
#include "data/io/file_kind.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/import_robot.h"
#include "report/json.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

constexpr int kFine = 2500;  // triangles of each link of a human hand: many hands share a page
constexpr const char* kProgram = "/proc/self/exe";  // of this process, on Linux

/// @throws InputError where there is no object, or a file of another kind
std::string object_file(const std::string& name, const std::string& data) {
  std::string file = named_file("object", name, "objects", ".toml", data_folders(data));
  if (fs::path(file).extension() != ".toml") {
    const std::string made = fs::path(file).stem().string() + ".toml";
    throw InputError(
        fmt::format("'{}' is no object file (TOML): `thenar import {}{} --out {}` makes one; state "
                    "its mass_g and material there",
                    file, file, is_mesh_file(file) ? " --units mm" : "", made));
  }
  const FileKind kind = find_file_kind(file);
  require(kind == FileKind::kObject, "'{}' is a file of kind '{}': wanted an object", file,
          name_of(kind));
  return file;
}

ComparedHand to_compare(const NamedHand& named) {
  ComparedHand hand;
  hand.name = named.name;
  hand.hand = named.hand;
  hand.contact = named.contact;
  hand.rates = named.rates;
  hand.warnings = named.warnings;
  if (named.targets.empty()) return hand;
  const SkinLandmark& thumb = pad_of(named.patches, "thumb");
  hand.thumb = {"thumb", thumb.link, thumb.p, 0};
  for (const OppositionTarget& target : named.targets)
    hand.places.push_back({target.name, target.mark.link, target.mark.p, target.score});
  return hand;
}

template <typename Matrix>
std::string bytes_of(const Matrix& matrix) {
  return {reinterpret_cast<const char*>(matrix.data()),
          static_cast<std::size_t>(matrix.size()) * sizeof(typename Matrix::Scalar)};
}

/// Corners and triangles of all meshes.
std::string mesh_bytes(const std::vector<ShapeSpec>& shapes) {
  std::string bytes;
  for (const ShapeSpec& shape : shapes)
    bytes += bytes_of(shape.mesh.vertices) + bytes_of(shape.mesh.triangles);
  return bytes;
}

std::string object_hash(const BodySpec& object) {
  return sha256(object_toml(object) + mesh_bytes(object.shapes));
}

/// Of what was read, whatever files it came from; of a subject its file; "" if it is built in.
std::string hand_hash(const std::string& hand, const std::string& data) {
  const HandSource source = find_hand(hand, data_folders(data));
  if (source.human) return source.file.empty() ? "" : sha256(read_source(source.file).text);
  const RobotSpec robot = import_robot(source.file);
  std::string bytes = robot_toml(robot);
  for (const RobotLink& link : robot.links) bytes += mesh_bytes(link.shapes);
  return sha256(bytes);
}

std::string program_hash() {
  std::ostringstream bytes;
  bytes << std::ifstream(kProgram, std::ios::binary).rdbuf();
  return sha256(bytes.str());
}

}  // namespace

std::vector<NamedHand> named_hands(const CompareQuestion& question) {
  HumanHandOptions human;
  human.skin.drawn = kFine;
  std::vector<NamedHand> hands;
  for (const std::string& name : question.hands)
    hands.push_back(hand_by_name(name, data_folders(question.data), human));
  return hands;
}

std::vector<ComparedHand> hands_of(const CompareQuestion& question,
                                   const std::vector<NamedHand>& named) {
  std::vector<ComparedHand> hands;
  for (const NamedHand& each : named) hands.push_back(to_compare(each));
  for (const std::string& name : question.objects)
    if (read_object(object_file(name, question.data)).material.empty())
      for (ComparedHand& hand : hands)
        hand.warnings.push_back(fmt::format("no material is stated of object '{}': {} is taken",
                                            name, kDefaultMaterial));
  return hands;
}

std::vector<BodySpec> objects_of(const CompareQuestion& question) {
  std::vector<BodySpec> objects;
  for (const std::string& name : question.objects)
    objects.push_back(read_object(object_file(name, question.data)));
  for (BodySpec& object : objects)
    if (object.material.empty()) object.material = kDefaultMaterial;
  return objects;
}

CompareOptions options_of(const CompareQuestion& question) {
  CompareOptions options;
  options.approaches = question.approaches;
  options.best = question.best;
  options.threads = question.threads;
  options.seed = question.seed;
  options.normalise_size = question.normalise;
  options.tasks.clear();
  for (const std::string& task : question.tasks) options.tasks.push_back(grasp_task(task));
  return options;
}

OrderedJson compare_inputs(const CompareQuestion& question) {
  OrderedJson contents = OrderedJson::object();
  for (const std::string& hand : question.hands)
    if (const std::string hash = hand_hash(hand, question.data); !hash.empty())
      contents["hand " + current_hand_name(hand)] = hash;
  for (const BodySpec& object : objects_of(question))
    contents["object " + object.name] = object_hash(object);
  std::vector<std::string> hands;
  for (const std::string& hand : question.hands) hands.push_back(current_hand_name(hand));
  return {{"hands", hands},
          {"objects", question.objects},
          {"tasks", question.tasks},
          {"approaches", question.approaches},
          {"best", question.best},
          {"seed", question.seed},
          {"normalise_size", question.normalise},
          {"contents", contents},
          {"program", program_hash()},
          {"versions", versions()}};
}

nlohmann::json compare_provenance(const OrderedJson& inputs) {
  nlohmann::json provenance = inputs.at("versions");
  for (const auto& [what, hash] : inputs.at("contents").items())
    provenance[what] = "sha256 " + hash.get<std::string>();
  provenance["program"] = "sha256 " + inputs.at("program").get<std::string>();
  provenance["seed"] = std::to_string(inputs.at("seed").get<unsigned>());
  return provenance;
}

}  // namespace thenar
