#pragma once

/// Reading whole files without trusting what stands under their names.

#include <cstddef>
#include <string>

namespace thenar {

/// Whether a regular file, or a link to one, is there; false also where that cannot be found out,
/// as of names that are too long.
[[nodiscard]] bool is_file(const std::string& path);

/// All bytes of a regular file, or of a link to one. A folder, a pipe, a socket or a device (which
/// may block for ever, or never end) is refused before anything is read from it.
/// @param most  bytes; a longer file is refused before memory is taken for it
/// @throws DataError `path:1: ...` if there is no such file, or it is none of these.
[[nodiscard]] std::string read_file(const std::string& path, std::size_t most);

/// The first bytes of a regular file: all of them if it has no more.
/// @param count  how many are wanted [bytes]
/// @throws DataError like read_file().
[[nodiscard]] std::string read_start(const std::string& path, std::size_t count);

}  // namespace thenar
