#pragma once

/// Files that a question reads or writes: their text, their kind, and checks of that kind.

#include <string>
#include <vector>

#include "base/provenance.h"

namespace thenar {

/// Returns a data file as text with its path. @throws DataError if it cannot be read.
[[nodiscard]] SourceText read_source(const std::string& path);

/// Returns a warning if damage to a binary result would go unnoticed, because files of older
/// versions have no checksum; else nothing.
[[nodiscard]] std::vector<std::string> checksum_warnings(const std::string& path);

/// Checks that a result can be written to a path and overwrites nothing but a result. @throws
/// InputError otherwise.
void require_result_path(const std::string& path);

/// Kind of a file, in words.
struct FileContents {
  // "subject", "experiment", "fit settings", "proportions", "net", "materials", "robot", "object",
  // "world", "scene", "pad", "presses of a pad", "mesh", "fit", "posterior", "motion", "scene run",
  // "contacts", "comparison", "page", "answer", "folder"; "": unknown
  std::string kind;
  std::string format;  // "TOML", "HDF5", "netCDF", "URDF", "JSON", ..; "": not known
};

/// Finds the kind of a file by its content, of meshes by the ending of the name. A damaged binary
/// file may stay unknown; its reader then says what is wrong.
/// @throws InputError if there is no such file, with the nearest name in its folder; DataError if a
/// TOML file is wrong or of no known kind.
[[nodiscard]] FileContents contents_of(const std::string& path);

/// Returns the file that a request names: its path, or a name of the data. The kind is checked.
/// @param field   field of the request, which errors name
/// @param kind    "world", see FileContents::kind;  @param folder  "worlds"
/// @param data    folder with worlds/ ..; empty: the usual ones
/// @throws InputError as named_file() and require_kind()
[[nodiscard]] std::string requested_file(const char* field, const std::string& kind,
                                         const std::string& name, const std::string& folder,
                                         const std::string& data, const std::string& hint = "");

/// Throws WrongKindError for a file that is known to be of another kind:
/// "'P.nc' is a posterior, wanted a fit".
/// Files of unknown kind, and those that cannot be parsed, are accepted here: their reader reports
/// the error.
/// @param kinds  accepted kinds, see FileContents::kind
/// @param hint   advice for a robot, an object or a mesh; empty: none
/// @throws WrongKindError as above, InputError if there is no file
void require_kind(const std::string& path, const std::vector<std::string>& kinds,
                  const std::string& hint = "");

}  // namespace thenar
