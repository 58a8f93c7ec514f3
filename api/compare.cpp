#include "api/compare.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "api/named/data_folders.h"
#include "api/named/files.h"
#include "api/named/material_names.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/rung_names.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/import_robot.h"
#include "grasp/compare/compare_hands.h"
#include "grasp/compare/comparison_file.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

// Triangles of each drawn link of a human hand, as many hands share a page
constexpr int kLinkTriangles = 2500;
constexpr const char* kProgram = "/proc/self/exe";  // executable of this process on Linux

/// @throws InputError where there is no object, or a file of another kind
std::string object_file(const std::string& name, const std::string& data) {
  std::string file = named_file("object", name, "objects", ".toml", data_folders(data));
  if (fs::path(file).extension() != ".toml") {
    throw InputError(
        fmt::format("'{}' is not an object file (TOML): `thenar import`, given its mass and "
                    "material{}, makes one",
                    file, is_mesh_file(file) ? ", and the unit of its numbers" : ""));
  }
  require_kind(file, {"object"});
  return file;
}

ComparedHand to_compare(const NamedHand& named) {
  // Copy the facts that every task needs: geometry, friction and closing speeds.
  ComparedHand hand;
  hand.name = named.name;
  hand.hand = named.hand;
  hand.contact = named.contact;
  hand.rates = named.rates;
  hand.warnings = named.warnings;
  // Robots have no opposition targets, so only human hands pass the Kapandji points to the
  // comparison.
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

/// Returns the SHA-256 of a hand's data, independent of the files it was read from: of a robot its
/// description and meshes, of a subject its file; "" for a built-in hand.
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

/// The hands by their names; fewer if it is stopped.
std::vector<NamedHand> hands_of(const CompareRequest& request, const Progress& progress) {
  HumanHandOptions human;
  human.path = request.path;
  human.skin.drawn = kLinkTriangles;
  std::vector<NamedHand> hands;
  for (const std::string& name : request.hands) {
    if (progress.stop()) break;
    hands.push_back(
        in_field("hands", [&] { return hand_by_name(name, data_folders(request.data), human); }));
  }
  return hands;
}

/// The objects as their files have them: some may have no material.
std::vector<BodySpec> objects_of(const CompareRequest& request) {
  std::vector<BodySpec> objects;
  for (const std::string& name : request.objects)
    objects.push_back(
        read_object(in_field("objects", [&] { return object_file(name, request.data); })));
  append_all(objects, request.own_objects);
  return objects;
}

/// @throws InputError for an object of a material that the table has not
void require_object_materials(const CompareRequest& request, const std::vector<BodySpec>& objects,
                              const Materials& table) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string named = i < request.objects.size()
                                  ? object_file(request.objects[i], request.data)
                                  : objects[i].name;
    const std::vector<std::string> unknown = unknown_materials(named, {objects[i].material}, table);
    require(unknown.empty(), "{}; a materials file may give others",
            unknown.empty() ? "" : unknown.front());
  }
}

/// Builds the compared hands; warnings state assumptions about the objects.
std::vector<ComparedHand> compared_hands(const std::vector<NamedHand>& named,
                                         const std::vector<std::string>& without_material) {
  std::vector<ComparedHand> hands =
      transformed(named, [](const NamedHand& each) { return to_compare(each); });
  for (const std::string& object : without_material)
    for (ComparedHand& hand : hands)
      hand.warnings.push_back(fmt::format("no material is stated of object '{}': {} is taken",
                                          object, kDefaultMaterial));
  return hands;
}

CompareOptions options_of(const CompareRequest& request, const Materials& materials) {
  // Threads change the speed alone; every other option changes the result and is part of the
  // inputs.
  CompareOptions options;
  options.approaches = request.approaches;
  options.best = request.best;
  options.threads = request.threads;
  options.seed = request.seed;
  options.normalise_size = request.normalise_size;
  options.materials = materials;
  options.tasks = request.tasks;
  return options;
}

template <typename Key>
JsonNode texts_node(const std::map<Key, std::string>& texts) {
  JsonNode node(JsonKind::kObject);
  for (const auto& [name, text] : texts) node.set(name, text);
  return node;
}

/// All files of the hands and objects.
FileDigests files_of(const std::vector<NamedHand>& hands, const std::vector<BodySpec>& objects) {
  FileDigests files;
  for (const NamedHand& hand : hands) files.insert(hand.files.begin(), hand.files.end());
  for (const BodySpec& object : objects) files.insert(object.files.begin(), object.files.end());
  return files;
}

/// SHA-256 of all hands and objects, as "hand barrett" and "object mug".
JsonNode content_hashes(const CompareRequest& request, const std::vector<BodySpec>& objects,
                        const Materials& materials) {
  // Hands are hashed under their current name, so that a renamed hand stays comparable.
  JsonNode contents(JsonKind::kObject);
  for (const std::string& hand : request.hands)
    if (const std::string hash = hand_hash(hand, request.data); !hash.empty())
      contents.set("hand " + current_hand_name(hand), hash);
  for (const BodySpec& object : objects) contents.set("object " + object.name, object_hash(object));
  // Materials decide friction and pads, hence their text and the laws they point to belong to the
  // key.
  if (!request.materials.empty())
    contents.set("materials " + request.materials, sha256(read_source(request.materials).text));
  for (const auto& [path, hash] : materials.files) contents.set("laws " + path, hash);
  return contents;
}

/// Returns all inputs that determine the result, by name: the request without threads, and the
/// contents of everything that it names.
JsonNode inputs_of(const CompareRequest& request, const std::vector<BodySpec>& objects,
                   const Materials& materials) {
  // Use current names: a file that was written under an old name of a hand still matches.
  // The number of threads is left out, since it does not change the result.
  JsonNode inputs;
  inputs.set("hands", transformed(request.hands, current_hand_name))
      .set("objects", request.objects)
      .set("tasks", transformed(request.tasks, [](GraspTask task) { return name_of(task); }))
      .set("approaches", request.approaches)
      .set("best", request.best)
      .set("seed", request.seed)
      .set("normalise_size", request.normalise_size)
      .set("paths", asked_paths(request.path))
      .set("contents", content_hashes(request, objects, materials))
      .set("program", program_hash())
      .set("versions", texts_node(versions()));
  return inputs;
}

/// Converts inputs_of() to a map name -> text, with versions of programs and the seed.
std::map<std::string, std::string> input_texts(const JsonNode& inputs, unsigned seed) {
  std::map<std::string, std::string> texts = versions();
  const JsonNode& contents = *inputs.find("contents");
  for (std::size_t i = 0; i < contents.names.size(); ++i)
    texts[contents.names[i]] = "read as " + contents.items[i].text;
  texts["program"] = "build " + inputs.find("program")->text;
  texts["paths"] = inputs.find("paths")->text;
  texts["seed"] = std::to_string(seed);
  return texts;
}

void require_fits(const BestGrasp& best, const NamedHand& hand, const std::string& path) {
  // Throw for stored cells of another version of the hand: their postures have other lengths.
  const Eigen::Index angles = hand.hand->layout().lower.size();
  if (best.q.size() != angles)
    throw DataError(path, 1,
                    fmt::format("a posture of '{}' has {} angles, wanted {}", hand.name,
                                best.q.size(), angles));
  // A contact refers to a surface by index, which must exist in the hand as it is built today.
  const auto surfaces = static_cast<int>(hand.hand->surfaces().size());
  for (const HandContact& contact : best.contacts)
    if (contact.surface >= surfaces)
      throw DataError(path, 1,
                      fmt::format("a contact of '{}' is on surface {}, and it has {}", hand.name,
                                  contact.surface, surfaces));
}

/// Postures of a file are of as many joints as the hands have, contacts on surfaces of theirs.
void require_postures(const std::vector<HandOnObject>& cells, const std::vector<NamedHand>& named,
                      const std::string& path) {
  for (const HandOnObject& cell : cells)
    for (const NamedHand& hand : named)
      for (const BestGrasp& best : cell.best)
        if (hand.name == cell.hand) require_fits(best, hand, path);
}

/// Adds cells of an earlier run that this one did not reach.
Comparison joined(Comparison comparison, const std::vector<HandOnObject>& done) {
  for (const HandOnObject& cell : done)
    if (find_cell(comparison.cells, cell.hand, cell.object) == nullptr)
      comparison.cells.push_back(cell);
  return comparison;
}

/// Compares hands and objects of a result where an earlier run has not, and keeps it in the file.
Comparison go_on(const CompareRequest& request, CompareOptions options, const JsonNode& inputs,
                 const CompareResult& of, const std::vector<ComparedHand>& hands,
                 const Progress& progress) {
  SavedComparison kept;
  std::optional<FileLock> lock;  // another comparison would drop our cells, and we its
  if (!request.file.empty()) {
    lock.emplace(request.file);
    kept = read_comparison(request.file, inputs, current_hand_name, of.files);
    require_postures(kept.cells, of.hands, request.file);
  }
  // The file names this run only if it computed something.
  JsonNode provenance = kept.provenance;
  const auto save = [&](const Comparison& comparison) {
    if (!request.file.empty())
      write_comparison(request.file, joined(comparison, kept.cells), inputs, provenance);
  };
  // Write after every cell, so that a killed comparison continues where it was.
  options.keep = [&](const Comparison& comparison) {
    const bool has_new = any_of(comparison.cells, [&](const HandOnObject& cell) {
      return find_cell(kept.cells, cell.hand, cell.object) == nullptr;
    });
    if (has_new && !request.run.arguments.empty())
      provenance = continued_provenance(kept.provenance, request.run, of.files);
    save(comparison);
  };
  // Compare the pairs that the file lacks, and write all.
  const Comparison comparison = compare(hands, of.objects, options, progress, kept.cells);
  save(comparison);
  return joined(comparison, kept.cells);
}

}  // namespace

CompareResult compare_hands(const CompareRequest& request, const Progress& progress) {
  // Count pairs of a hand and an object, each of which is one cell of the table.
  CompareResult result;
  result.request = request;
  result.objects = objects_of(request);
  result.outcome = {Status::kStopped, 0, request.hands.size() * result.objects.size(), "pair", {}};
  // Objects without a material get the default; hands warn of it.
  std::vector<std::string> without_material;
  for (std::size_t i = 0; i < result.objects.size(); ++i)
    if (result.objects[i].material.empty()) {
      without_material.push_back(i < request.objects.size() ? request.objects[i]
                                                            : result.objects[i].name);
      result.objects[i].material = kDefaultMaterial;
    }
  const Materials materials = materials_of_file(request.materials);
  require_object_materials(request, result.objects, materials);
  // Collect the inputs before hands are built, because they decide whether stored cells are still
  // valid.
  const JsonNode inputs = inputs_of(request, result.objects, materials);
  result.inputs = input_texts(inputs, request.seed);
  // Find out that the file cannot be written before hours of work, not after.
  if (!request.file.empty()) require_writable(request.file);
  result.hands = hands_of(request, progress);
  if (result.hands.size() < request.hands.size()) return result;  // stopped
  // Collect the digests of all files that the result depends on.
  result.files = files_of(result.hands, result.objects);
  if (!request.materials.empty()) result.files.merge(digests_of({request.materials}));
  result.files.insert(materials.files.begin(), materials.files.end());
  // Every surface of a hand needs a known material, as friction and pads depend on it.
  for (const NamedHand& hand : result.hands) require_materials(hand, materials);
  result.comparison = go_on(request, options_of(request, materials), inputs, result,
                            compared_hands(result.hands, without_material), progress);
  // An interrupted comparison keeps its cells and stays marked as stopped.
  if (result.comparison.complete) result.outcome.status = Status::kSolved;
  result.outcome.done = result.comparison.cells.size();
  result.outcome.warnings = result.comparison.warnings;
  return result;
}

}  // namespace thenar
