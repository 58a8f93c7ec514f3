#include "data/io/file_kind.h"

#include <vector>

#include "base/error.h"
#include "base/lists.h"
#include "data/io/checked_file.h"
#include "data/io/file_guard.h"
#include "data/io/toml_node.h"

namespace thenar {
namespace {

bool has_any(const TomlNode& table, const std::vector<std::string>& keys) {
  return any_of(keys, [&](const std::string& key) { return table.find(key) != nullptr; });
}

/// Proportions have digits as fractions of a hand's length.
bool has_proportions(const TomlNode& top) {
  const TomlNode* digits = top.find("digit");
  return digits != nullptr && !digits->items.empty() &&
         has_any(digits->items.front(), {"joint_distal_ratio", "segment"});
}

/// Returns whether a key is a list of tables. Objects and nets have such keys, too, but not as
/// lists.
bool has_list(const TomlNode& top, const std::string& key) {
  const TomlNode* list = top.find(key);
  return list != nullptr && list->kind == TomlKind::kArray;
}

}  // namespace

FileKind find_file_kind(const std::string& path) {
  // HDF5 by its first bytes, TOML by keys that only one kind has.
  if (has_hdf5_start(path)) return FileKind::kResult;
  const TomlNode top = parse_toml(read_guarded(path, GuardedKind::kToml), path);
  if (has_any(top, {"parameter", "axis_distance", "robust_scale"})) return FileKind::kFitSettings;
  if (has_any(top, {"protocol", "trials", "posture", "noise"})) return FileKind::kExperiment;
  if (has_any(top, {"pulp"})) return FileKind::kPad;
  if (has_any(top, {"soft_finger", "elastic_foundation"})) return FileKind::kPadLaws;
  if (has_list(top, "press") || has_list(top, "constant")) return FileKind::kPadPresses;
  if (has_any(top, {"mean_subject"})) return FileKind::kAxisVariability;
  if (has_any(top, {"pinch"})) return FileKind::kPinchLosses;
  if (has_proportions(top)) return FileKind::kProportions;
  if (has_any(top, {"bone_lengths", "node", "band"})) return FileKind::kNet;
  if (has_any(top, {"link", "dof"})) return FileKind::kRobot;
  if (has_any(top, {"stepping", "gravity_m_s2", "force", "drive", "apart"}))
    return FileKind::kScene;
  if (has_any(top, {"hand", "body", "camera"})) return FileKind::kWorld;
  if (has_list(top, "shape")) return FileKind::kObject;
  if (has_list(top, "material") || has_list(top, "friction")) return FileKind::kMaterials;
  if (has_any(top, {"side", "segment", "joint", "dh_chain", "muscle", "strand", "tip_map"}))
    return FileKind::kSubject;
  throw DataError(
      path, 1,
      "wanted a subject ([[joint]], [[muscle]] ..), an experiment ([protocol], "
      "[trials]), fit settings ([[parameter]]), proportions ([[digit]]), variability of axes "
      "(mean_subject), losses of pinch ([pinch], [[block]]), a net ([[band]]), a robot ([[link]]), "
      "an object ([[shape]]), a world "
      "([[hand]], [[body]]), a scene ([stepping], [[body]]), a pad ([pulp]), laws of a pad "
      "([soft_finger]), presses of a pad ([[press]]) or materials ([[material]]), "
      "got none");
}

}  // namespace thenar
