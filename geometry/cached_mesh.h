#pragma once

/// Meshes that cost seconds, cached from one run to the next.

#include <functional>
#include <optional>
#include <string>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// Returns the mesh that is cached for an input, or the result of `make`, which is then cached.
/// @param kind, input  as in base/cache.h
[[nodiscard]] TriangleMesh cached_mesh(const std::string& kind, const std::string& input,
                                       const std::function<TriangleMesh()>& make);

/// Bytes of a whole mesh, to be part of an input or a result.
[[nodiscard]] std::string bytes_of(const TriangleMesh& mesh);

/// The mesh of bytes_of(); nothing if these are not the bytes of a mesh.
[[nodiscard]] std::optional<TriangleMesh> mesh_of(const std::string& bytes);

/// Appends numbers as they stand in memory.
template <typename T>
void append_bytes(std::string& bytes, const T* numbers, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(numbers), count * sizeof(T));
}

}  // namespace thenar
