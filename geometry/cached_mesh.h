#pragma once

/// Cache of meshes that take seconds to build, kept from one run to the next.

#include <functional>
#include <optional>
#include <string>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// Returns the cached mesh of an input, or builds it with `make` and caches it.
/// @param kind, input  keys of base/cache.h
[[nodiscard]] TriangleMesh cached_mesh(const std::string& kind, const std::string& input,
                                       const std::function<TriangleMesh()>& make);

/// Serializes a mesh, to be part of an input or a result.
[[nodiscard]] std::string bytes_of(const TriangleMesh& mesh);

/// Deserializes a mesh; nothing if the bytes are not those of a mesh.
[[nodiscard]] std::optional<TriangleMesh> mesh_of(const std::string& bytes);

/// Appends numbers in their binary representation.
template <typename T>
void append_bytes(std::string& bytes, const T* numbers, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(numbers), count * sizeof(T));
}

}  // namespace thenar
