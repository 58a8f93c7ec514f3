#pragma once

/// Import of files that a user drops into a live world: objects, obstacles, hands.

#include <array>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "live/world/world_edits.h"

namespace thenar {

/// File that was dropped.
struct DroppedFile {
  std::string name;   // path relative to the drop: "hand/meshes/tip.stl"
  std::string bytes;  // content
};

/// Role in which imported files are added to a world.
enum class DroppedAs { kObject, kObstacle, kHand };
inline constexpr std::array kDroppedAsNames{EnumName{DroppedAs::kObject, "object"},
                                            EnumName{DroppedAs::kObstacle, "obstacle"},
                                            EnumName{DroppedAs::kHand, "hand"}};

/// Body that was read from a file of any format and repaired; it does not refer to the file.
struct ImportedBody {
  BodySpec body;
  std::vector<std::string> warnings;
};

/// Reads an object or a mesh. Meshes get kDefaultMaterial, and open meshes are closed. The
/// triangles are stored in the body, so the file is not needed afterwards.
/// @param units  unit of the numbers of a mesh: "m", "cm", "mm", "in"; empty: m
/// @throws InputError, DataError as import_file()
[[nodiscard]] ImportedBody read_imported_body(const std::string& file,
                                              const std::string& units = "");

/// Adds a dropped object, obstacle or hand at a free position. The main file is the first robot
/// file (URDF, MJCF, GraspIt! XML, TOML) for a hand, else the first object file (TOML, XML), else
/// the first mesh; it may refer only to files of the same drop. Hidden files, whose names begin
/// with a dot, are ignored. Files of hands stay in the world's temporary folder, up to 256 MB, and
/// are copied when the world is saved. If this throws, the world is unchanged.
/// @param units  as for read_imported_body()
/// @throws InputError for too large, too many or no files, an invalid or repeated name, or no
///         usable main file; DataError for an invalid file
AddedThing import_dropped(LiveWorld& live, const std::vector<DroppedFile>& files, DroppedAs as,
                          const Progress& progress = {}, const std::string& units = "");

}  // namespace thenar
