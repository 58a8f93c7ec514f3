#pragma once

/// Meshes that clients fetch by the hash of their content, so that each is sent once.

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// Encodes a mesh for clients, little-endian: u32 number of vertices, u32 number of triangles, f32
/// x, y, z of every vertex [m], three vertex indices of every triangle from 0: u16 for up to 65536
/// vertices, else u32.
/// @throws InputError if there are more than 2^32 - 1 vertices or triangles
[[nodiscard]] std::string mesh_bytes(const TriangleMesh& mesh);

/// Encoded meshes of the scenes that were shown last. Thread-safe.
class MeshStore {
 public:
  /// Adds a mesh to the current scene; encodes it unless the same object was added before.
  /// @return its id: 32 hexadecimal digits
  std::string add(const std::shared_ptr<const TriangleMesh>& mesh);
  /// Begins a scene: removes meshes that none of the last eight scenes has added.
  void begin_scene();
  /// Returns the bytes of a mesh; null if the id is unknown.
  [[nodiscard]] std::shared_ptr<const std::string> bytes(const std::string& id) const;

 private:
  struct Entry {
    std::shared_ptr<const std::string> bytes;
    unsigned long scene = 0;  // last scene that added it
  };
  struct Known {
    std::weak_ptr<const TriangleMesh> mesh;  // expired: the address may belong to another mesh
    std::string id;
  };

  mutable std::mutex mutex_;
  std::map<std::string, Entry> entries_;
  std::map<const TriangleMesh*, Known> known_;
  unsigned long scene_ = 0;
};

}  // namespace thenar
