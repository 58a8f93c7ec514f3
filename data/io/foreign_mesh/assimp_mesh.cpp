// The only fence of assimp.

#include "data/io/foreign_mesh/parsers.h"

#include <algorithm>
#include <array>
#include <exception>
#include <stdexcept>
#include <utility>
#include <vector>

#include <assimp/MemoryIOWrapper.h>
#include <assimp/ai_assert.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>

#include "base/error.h"
#include "data/io/mesh/mesh_file.h"

/// Replaces assimp's own, which would abort the program on some broken files.
void Assimp::aiAssertViolation(const char* expression, const char* /*file*/, int /*line*/) {
  throw std::runtime_error(std::string("the file is broken: not ") + expression);
}

namespace thenar {
namespace {

void append_face(const aiMesh& mesh, const aiFace& face, const aiMatrix4x4& place,
                 TriangleSoup& soup) {
  if (face.mNumIndices != 3) return;  // points and lines
  // Corners where the scene graph puts them.
  std::array<Eigen::Vector3d, 3> corner;
  for (unsigned k = 0; k < 3; ++k) {
    const aiVector3D p = place * mesh.mVertices[face.mIndices[k]];
    corner[k] = {p.x, p.y, p.z};
  }
  if (place.Determinant() < 0)
    std::swap(corner[1], corner[2]);  // a mirror turns surfaces inside out
  soup.corners.insert(soup.corners.end(), corner.begin(), corner.end());
}

/// Refuses a file of a few bytes that stands for millions of triangles because it names one mesh in
/// many places. 100,000 are always allowed, and no format takes less than a byte for a triangle.
void require_few(std::size_t triangles, std::size_t bytes) {
  const std::size_t most = std::min(kMaxTriangles, 100'000 + bytes);
  if (triangles > most)
    throw std::runtime_error(fmt::format("{} bytes stand for more than {} triangles", bytes, most));
}

/// Triangles of all nodes, each at its place.
TriangleSoup soup_of(const aiScene& scene, std::size_t bytes) {
  TriangleSoup soup;
  std::vector<std::pair<const aiNode*, aiMatrix4x4>> open;
  if (scene.mRootNode != nullptr) open.emplace_back(scene.mRootNode, aiMatrix4x4());
  // Depth-first walk on a stack of our own, with the pose of each parent.
  while (!open.empty()) {
    const auto [node, parent] = open.back();
    open.pop_back();
    const aiMatrix4x4 place = parent * node->mTransformation;
    // Meshes of this node.
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      const aiMesh& mesh = *scene.mMeshes[node->mMeshes[i]];
      require_few(soup.corners.size() / 3 + mesh.mNumFaces, bytes);
      for (unsigned f = 0; f < mesh.mNumFaces; ++f) append_face(mesh, mesh.mFaces[f], place, soup);
    }
    // Its children, in their order.
    for (unsigned i = node->mNumChildren; i-- > 0;) open.emplace_back(node->mChildren[i], place);
  }
  return soup;
}

/// Files that assimp can open: the mesh itself and, for glTF, buffers in its folder or below, each
/// read whole. Materials, textures and all other files do not exist for it.
class OneFolder : public Assimp::IOSystem {
 public:
  explicit OneFolder(std::string path) : path_(std::move(path)) {}

  [[nodiscard]] bool Exists(const char* file) const override { return is_served(file); }
  [[nodiscard]] char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    if (*mode != 'r' || !is_served(file)) return nullptr;
    const std::string text = read_permitted_file(file);
    bytes_ += text.size();
    auto* const bytes = new uint8_t[text.size()];  // owned by the stream
    std::copy(text.begin(), text.end(), bytes);
    return new Assimp::MemoryIOStream(bytes, text.size(), true);
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

  /// Number of bytes of all files opened.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  [[nodiscard]] bool is_served(const std::string& file) const {
    if (file == path_) return true;
    return mesh_format(path_) == MeshFormat::kGltf && is_file_beside(path_, file);
  }

  std::string path_;
  std::size_t bytes_ = 0;
};

[[noreturn]] void fail(const std::string& path, std::string why) {
  std::replace(why.begin(), why.end(), '\n', ' ');
  throw DataError(path, 1, why);
}

}  // namespace

TriangleSoup read_assimp_mesh(const std::string& path) {
  // Flags of assimp: split polygons into triangles, and check the scene
  constexpr unsigned kImportFlags = aiProcess_Triangulate | aiProcess_ValidateDataStructure;
  // Collada is checked first, because assimp trusts its numbers.
  if (mesh_format(path) == MeshFormat::kCollada) check_collada(read_permitted_file(path), path);
  Assimp::Importer importer;
  auto* const folder = new OneFolder(path);  // owned by the importer
  importer.SetIOHandler(folder);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  // From here on no other file can be opened.
  forbid_opening_files();
  try {
    const aiScene* const scene = importer.ReadFile(path, kImportFlags);
    if (scene == nullptr) fail(path, importer.GetErrorString());
    return soup_of(*scene, folder->bytes());
  } catch (const Error&) {
    throw;
  } catch (const std::exception& broken) {
    fail(path, broken.what());
  }
}

}  // namespace thenar
