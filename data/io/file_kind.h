#pragma once

/// Kinds of data files, recognised by their content.

#include <string>

namespace thenar {

enum class FileKind {
  kSubject,
  kExperiment,
  kFitSettings,
  kProportions,
  kAxisVariability,
  kPinchLosses,
  kNet,
  kResult,
  kObject,
  kWorld,
  kMaterials,
  kRobot,
  kScene,
  kPad,
  kPadLaws,
  kPadPresses
};

/// "subject", "experiment", "fit settings", "proportions", "variability of axes", "losses of
/// pinch", "net", "result", "object", "world", "materials", "robot", "scene", "pad", "laws of a
/// pad" or "presses of a pad".
[[nodiscard]] std::string name_of(FileKind kind);

/// Finds the kind of a file: an HDF5 result by its first bytes, a TOML file by its top-level keys.
/// @throws DataError if the file cannot be read, is not TOML, or has no key that tells.
[[nodiscard]] FileKind find_file_kind(const std::string& path);

}  // namespace thenar
