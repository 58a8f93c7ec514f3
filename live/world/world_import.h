#pragma once

/// Files that a person drops into a live world: objects, obstacles, hands.

#include <array>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "live/world/world_edits.h"

namespace thenar {

/// A file as it was dropped.
struct DroppedFile {
  std::string name;  // its path within what was dropped: "hand/meshes/tip.stl"
  std::string bytes;
};

/// Role in which imported files are added to a world.
enum class DroppedAs { kObject, kObstacle, kHand };
inline constexpr std::array kDroppedAsNames{EnumName{DroppedAs::kObject, "object"},
                                            EnumName{DroppedAs::kObstacle, "obstacle"},
                                            EnumName{DroppedAs::kHand, "hand"}};

/// A body that was read from a file of any format, mended, all of it in memory.
struct ImportedBody {
  BodySpec body;
  std::vector<std::string> warnings;
};

/// Reads an object or a mesh; a mesh without a material is of kDefaultMaterial, open ones are
/// closed. Its triangles are in the body, whose file is not needed any more.
/// @param units  of a mesh: "m", "cm", "mm", "in"; empty: m
/// @throws InputError, DataError as import_file()
[[nodiscard]] ImportedBody imported_body(const std::string& file, const std::string& units = "");

/// Adds what was dropped, at the origin or beside what stands there. One of the files is the thing,
/// the others are what it names: of a hand the first robot (URDF, MJCF, GraspIt! XML, TOML), else
/// the first object file (TOML, XML), else the first mesh. They are written to the world's own
/// folder and removed with it; worlds that are saved take those of hands along. A world keeps at
/// most 256 MB of them. Hidden files, whose names begin with a dot, are left out; a file names
/// others of the same drop alone.
/// @param units  as of imported_body()
/// @throws InputError for more, for no file, a name that leads elsewhere or is given twice, or none
/// that is
///         such a thing; DataError where one is wrong. The world stays as it was then.
AddedThing import_dropped(LiveWorld& live, const std::vector<DroppedFile>& files, DroppedAs as,
                          const Progress& progress = {}, const std::string& units = "");

}  // namespace thenar
