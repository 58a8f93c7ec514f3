#pragma once

/// Kinds of data files, recognised by their content.

#include <array>
#include <string>

#include "base/enum_names.h"

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
inline constexpr std::array kFileKindNames{
    EnumName{FileKind::kSubject, "subject"},
    EnumName{FileKind::kExperiment, "experiment"},
    EnumName{FileKind::kFitSettings, "fit settings"},
    EnumName{FileKind::kProportions, "proportions"},
    EnumName{FileKind::kAxisVariability, "variability of axes"},
    EnumName{FileKind::kPinchLosses, "losses of pinch"},
    EnumName{FileKind::kNet, "net"},
    EnumName{FileKind::kResult, "result"},
    EnumName{FileKind::kObject, "object"},
    EnumName{FileKind::kWorld, "world"},
    EnumName{FileKind::kMaterials, "materials"},
    EnumName{FileKind::kRobot, "robot"},
    EnumName{FileKind::kScene, "scene"},
    EnumName{FileKind::kPad, "pad"},
    EnumName{FileKind::kPadLaws, "laws of a pad"},
    EnumName{FileKind::kPadPresses, "presses of a pad"}};
[[nodiscard]] inline std::string name_of(FileKind kind) { return name_in(kFileKindNames, kind); }

/// Finds the kind of a file: an HDF5 result by its first bytes, a TOML file by its top-level keys.
/// @throws DataError if the file cannot be read, is not TOML, or has no distinctive key.
[[nodiscard]] FileKind find_file_kind(const std::string& path);

}  // namespace thenar
