#include "server/mesh_store.h"

#include <cstdint>
#include <limits>

#include "base/error.h"
#include "base/provenance.h"
#include "server/bytes.h"

namespace thenar {
namespace {

constexpr unsigned long kScenesKept = 8;      // a client may still fetch what an older scene named
constexpr Eigen::Index kFewVertices = 65536;  // that two bytes count
constexpr std::size_t kIdDigits = 32;         // of the SHA-256 in hexadecimal: 128 bits

}  // namespace

std::string mesh_bytes(const TriangleMesh& mesh) {
  constexpr auto kMost = std::numeric_limits<std::uint32_t>::max();
  require(mesh.vertices.cols() <= kMost && mesh.triangles.cols() <= kMost,
          "a mesh of {} vertices is too large to be shown", mesh.vertices.cols());
  const bool few = mesh.vertices.cols() <= kFewVertices;
  LittleEndianWriter out(static_cast<std::size_t>(8 + 12 * mesh.vertices.cols() +
                                                  (few ? 6 : 12) * mesh.triangles.cols()));
  out.add<std::uint32_t>(mesh.vertices.cols());
  out.add<std::uint32_t>(mesh.triangles.cols());
  for (const double coordinate : mesh.vertices.reshaped()) out.add<float>(coordinate);
  for (const int corner : mesh.triangles.reshaped())
    if (few)
      out.add<std::uint16_t>(corner);
    else
      out.add<std::uint32_t>(corner);
  return out.take();
}

std::string MeshStore::add(const std::shared_ptr<const TriangleMesh>& mesh) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Known& known = known_[mesh.get()];
  if (known.mesh.lock() == mesh) {
    const auto found = entries_.find(known.id);
    if (found != entries_.end()) {
      found->second.scene = scene_;
      return known.id;
    }
  }
  auto bytes = std::make_shared<const std::string>(mesh_bytes(*mesh));
  known = {mesh, sha256(*bytes).substr(0, kIdDigits)};
  entries_[known.id] = {std::move(bytes), scene_};
  return known.id;
}

void MeshStore::begin_scene() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++scene_;
  for (auto entry = entries_.begin(); entry != entries_.end();)
    entry = entry->second.scene + kScenesKept < scene_ ? entries_.erase(entry) : std::next(entry);
  for (auto known = known_.begin(); known != known_.end();)
    known = known->second.mesh.expired() ? known_.erase(known) : std::next(known);
}

std::shared_ptr<const std::string> MeshStore::bytes(const std::string& id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : found->second.bytes;
}

}  // namespace thenar
