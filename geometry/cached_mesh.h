#pragma once

/// Meshes that cost seconds, kept from one run to the next.

#include <functional>
#include <optional>
#include <string>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// The mesh that was kept for an input (kept()), or else what `make` returns, which is kept.
/// @param kind, input  as of kept()
[[nodiscard]] TriangleMesh cached_mesh(const std::string& kind, const std::string& input,
                                       const std::function<TriangleMesh()>& make);

/// All of a mesh, to be part of an input or a result.
[[nodiscard]] std::string bytes_of(const TriangleMesh& mesh);

/// The mesh of bytes_of(); nothing if these are not the bytes of a mesh.
[[nodiscard]] std::optional<TriangleMesh> mesh_of(const std::string& bytes);

/// Numbers as they stand in memory.
template <typename T>
void append_bytes(std::string& bytes, const T* numbers, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(numbers), count * sizeof(T));
}

}  // namespace thenar
