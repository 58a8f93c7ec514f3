#pragma once

/// What the program thenar-mesh-reader says on its standard output: triangles, or why there are
/// none. The side that reads trusts none of it.

#include <string>

#include "data/io/mesh/triangle_soup.h"

namespace thenar {

/// The corners of a soup in single precision, as assimp and Coin have them, and its exact shapes.
[[nodiscard]] std::string answer_of(const TriangleSoup& soup);

/// A message in place of triangles. @param message  "path:line: .." or without a place
[[nodiscard]] std::string answer_of(const std::string& message);

/// The triangles and exact shapes of an answer.
/// @param path  of the mesh file, to which messages belong
/// @throws DataError with the message of the answer; or if it is neither, is cut off, promises
/// more than it holds, or has a shape that is none.
[[nodiscard]] TriangleSoup parse_answer(const std::string& answer, const std::string& path);

}  // namespace thenar
