#include "server/mesh_store.h"

#include <cstdint>
#include <limits>

#include "base/error.h"
#include "base/provenance.h"
#include "server/bytes.h"

namespace thenar {
namespace {

constexpr unsigned long kKeptScenes = 8;           // number of scenes whose meshes are kept
constexpr Eigen::Index kMaxShortVertices = 65536;  // largest mesh with indices of two bytes
constexpr std::size_t kIdDigits = 32;              // hexadecimal digits of an id: 128 bits

}  // namespace

std::string mesh_bytes(const TriangleMesh& mesh) {
  // Check the size, and write the numbers of vertices and triangles.
  constexpr auto kMaxCount = std::numeric_limits<std::uint32_t>::max();
  require(mesh.vertices.cols() <= kMaxCount && mesh.triangles.cols() <= kMaxCount,
          "a mesh of {} vertices is too large to be shown", mesh.vertices.cols());
  const bool is_short = mesh.vertices.cols() <= kMaxShortVertices;
  LittleEndianWriter out(static_cast<std::size_t>(8 + 12 * mesh.vertices.cols() +
                                                  (is_short ? 6 : 12) * mesh.triangles.cols()));
  out.add<std::uint32_t>(mesh.vertices.cols());
  out.add<std::uint32_t>(mesh.triangles.cols());
  // Write the vertices, then the triangles.
  for (const double coordinate : mesh.vertices.reshaped()) out.add<float>(coordinate);
  for (const int corner : mesh.triangles.reshaped())
    if (is_short)
      out.add<std::uint16_t>(corner);
    else
      out.add<std::uint32_t>(corner);
  return out.take();
}

std::string MeshStore::add(const std::shared_ptr<const TriangleMesh>& mesh) {
  // Reuse the encoding of the same object.
  const std::lock_guard<std::mutex> lock(mutex_);
  Known& known = known_[mesh.get()];
  if (known.mesh.lock() == mesh) {
    const auto found = entries_.find(known.id);
    if (found != entries_.end()) {
      found->second.scene = scene_;
      return known.id;
    }
  }
  // Encode the mesh; its id is a hash of the bytes.
  auto bytes = std::make_shared<const std::string>(mesh_bytes(*mesh));
  known = {mesh, sha256(*bytes).substr(0, kIdDigits)};
  entries_[known.id] = {std::move(bytes), scene_};
  return known.id;
}

void MeshStore::begin_scene() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++scene_;
  for (auto entry = entries_.begin(); entry != entries_.end();)
    entry = entry->second.scene + kKeptScenes < scene_ ? entries_.erase(entry) : std::next(entry);
  for (auto known = known_.begin(); known != known_.end();)
    known = known->second.mesh.expired() ? known_.erase(known) : std::next(known);
}

std::shared_ptr<const std::string> MeshStore::bytes(const std::string& id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : found->second.bytes;
}

}  // namespace thenar
