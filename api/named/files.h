#pragma once

/// Files that a question reads or writes: their text, what they are, and whether they are of the
/// right kind.

#include <string>
#include <vector>

#include "base/provenance.h"

namespace thenar {

/// Returns a data file as text with its path. @throws DataError if it cannot be read.
[[nodiscard]] SourceText read_source(const std::string& path);

/// Returns a sentence if damage of a binary result could not be noticed: files of older versions
/// have no checksum. Empty for all others.
[[nodiscard]] std::vector<std::string> checksum_warnings(const std::string& path);

/// Refuses to write a result over anything that is not a result, and where no file can be made.
/// @throws InputError saying which.
void require_result_path(const std::string& path);

/// Kind of a file, as a person calls it.
struct FileContents {
  // "subject", "experiment", "fit settings", "proportions", "net", "materials", "robot", "object",
  // "world", "scene", "pad", "presses of a pad", "mesh", "fit", "posterior", "motion", "scene run",
  // "contacts", "comparison", "page", "answer", "folder"; "": none that is known
  std::string kind;
  std::string format;                 // "TOML", "HDF5", "netCDF", "URDF", "JSON", ..; "": not known
  std::vector<std::string> commands;  // lines that take it: "thenar explain hand.toml"
};

/// Finds the kind of a file by its content, of meshes by the ending of the name. A damaged binary
/// file may stay unknown; its reader then says what is wrong.
/// @throws InputError if there is no file of that name, with the nearest one beside it; DataError
/// if a TOML file is wrong or of no kind.
[[nodiscard]] FileContents contents_of(const std::string& path);

/// Refuses a file that is known to be of another kind:
/// "'P.nc' is a posterior, wanted a fit; commands that take it: thenar posterior summary P.nc, ..".
/// A file of unknown kind, or one that cannot be parsed, is left to its reader.
/// @param kinds  those that are wanted, as FileContents::kind
/// @param hint   what to do with a robot, an object or a mesh instead; empty: nothing
/// @throws InputError so, or if there is no file
void require_kind(const std::string& path, const std::vector<std::string>& kinds,
                  const std::string& hint = "");

}  // namespace thenar
