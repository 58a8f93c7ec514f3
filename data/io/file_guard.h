#pragma once

/// Limits that every file must satisfy before it is parsed: regular, of bounded size, nesting and
/// number of values. Parsers recurse with the nesting and use many bytes of memory for each byte of
/// the file, so that a small malicious file could crash the program or exhaust memory.

#include <cstddef>
#include <string>
#include <string_view>

namespace thenar {

/// Kind of file, which decides its limits and how its nesting is counted.
enum class GuardedKind {
  kToml,       // brackets, braces, dotted keys and headers
  kJson,       // brackets and braces; the JSON of glTF too
  kXml,        // tags: URDF, MJCF, GraspIt!
  kScene,      // braces and brackets of VRML and Inventor
  kMesh,       // size alone: STL, PLY, OFF, OBJ, glTF buffers, textures
  kResult,     // size alone: HDF5
  kInference,  // size alone: netCDF
  kCollada,    // tags around long lists of numbers
};

/// The limits of one kind; the table with its reasons is in file_guard.cpp.
struct FileLimit {
  GuardedKind kind;
  const char* name;    // name in messages: "TOML"
  std::size_t bytes;   // size of the file [bytes]
  int depth;           // nesting depth; 0: not counted
  std::size_t values;  // number of values, by its separators; 0: not counted
};

/// Returns the limits of a kind.
[[nodiscard]] const FileLimit& limit_of(GuardedKind kind);

/// Reads a regular file that satisfies the limits of its kind.
/// @throws DataError `path:line: what was wanted, what came`.
[[nodiscard]] std::string read_guarded(const std::string& path, GuardedKind kind);

/// Checks a text in memory against the limits of its kind, in one pass, without recursion, with one
/// number for each open bracket. The text need not be well-formed.
/// @param path        only names it in messages
/// @param first_line  number of the text's first line, for messages
/// @throws DataError at the line on which a limit is exceeded.
void guard_text(std::string_view text, const std::string& path, GuardedKind kind,
                int first_line = 1);

/// Returns the line of a text that holds the character at an offset, from 1; offsets beyond the
/// text count as its ends.
[[nodiscard]] int line_of_offset(std::string_view text, std::ptrdiff_t offset);

/// Returns true if `file`, which need not exist, is in the folder of `path` or below it, with links
/// resolved.
[[nodiscard]] bool is_in_folder_of(const std::string& path, const std::string& file);

}  // namespace thenar
