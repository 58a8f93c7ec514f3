#pragma once

/// Standard output of the program thenar-mesh-reader: triangles, or the reason why there are none.
/// The reading side validates all of it.

#include <string>

#include "data/io/mesh/triangle_soup.h"

namespace thenar {

/// Encodes the corners of a soup, in single precision as in assimp and Coin, and exact shapes.
[[nodiscard]] std::string answer_of(const TriangleSoup& soup);

/// Encodes a message instead. @param message  "path:line: .." or without a place
[[nodiscard]] std::string answer_of(const std::string& message);

/// Reads the triangles and exact shapes of an answer.
/// @param path  path of the mesh file, for messages
/// @throws DataError with the message of the answer; or if it is malformed, cut off, promises more
/// than it holds, or has an invalid shape.
[[nodiscard]] TriangleSoup parse_answer(const std::string& answer, const std::string& path);

}  // namespace thenar
