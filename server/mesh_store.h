#pragma once

/// Meshes that clients fetch by the hash of their content, so that each travels once.

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// A mesh as clients read it, little-endian: u32 vertices, u32 triangles, then of every vertex f32
/// x, y, z [m], then of every triangle three numbers that count vertices from 0: u16 where there
/// are up to 65536 vertices, else u32.
/// @throws InputError if there are more than 2^32 - 1 of either.
[[nodiscard]] std::string mesh_bytes(const TriangleMesh& mesh);

/// Encoded meshes of the scenes that were shown last. Several threads may use it at once.
class MeshStore {
 public:
  /// Keeps a mesh. A mesh that has been added as the same object is not encoded again.
  /// @returns its id: 32 hexadecimal digits
  std::string add(const std::shared_ptr<const TriangleMesh>& mesh);
  /// Begins a scene: meshes that none of the last eight scenes has added are let go.
  void begin_scene();
  /// The bytes of a mesh; null if none has that id.
  [[nodiscard]] std::shared_ptr<const std::string> bytes(const std::string& id) const;

 private:
  struct Entry {
    std::shared_ptr<const std::string> bytes;
    unsigned long scene = 0;  // that used it last
  };
  struct Known {
    std::weak_ptr<const TriangleMesh> mesh;  // tells whether the address is still its own
    std::string id;
  };

  mutable std::mutex mutex_;
  std::map<std::string, Entry> entries_;
  std::map<const TriangleMesh*, Known> known_;
  unsigned long scene_ = 0;
};

}  // namespace thenar
