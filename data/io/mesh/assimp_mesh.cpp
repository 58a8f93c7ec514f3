// The one fence of assimp.

#include "data/io/mesh/assimp_mesh.h"

#include <algorithm>
#include <array>
#include <exception>
#include <stdexcept>
#include <utility>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include "base/error.h"
#include "data/io/mesh/collada_text.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/mesh/off_text.h"
#include "data/io/mesh/ply_header.h"
#include "data/io/toml_node.h"

namespace Assimp {
/// Stands before assimp's own, which would abort the program on some broken files.
[[noreturn]] void aiAssertViolation(const char* expression, const char* file, int line);
void aiAssertViolation(const char* expression, const char* /*file*/, int /*line*/) {
  throw std::runtime_error(std::string("the file is broken: not ") + expression);
}
}  // namespace Assimp

namespace thenar {
namespace {

void append_face(const aiMesh& mesh, const aiFace& face, const aiMatrix4x4& place,
                 TriangleSoup& soup) {
  if (face.mNumIndices != 3) return;  // points and lines
  std::array<Eigen::Vector3d, 3> corner;
  for (unsigned k = 0; k < 3; ++k) {
    const aiVector3D p = place * mesh.mVertices[face.mIndices[k]];
    corner[k] = {p.x, p.y, p.z};
  }
  if (place.Determinant() < 0)
    std::swap(corner[1], corner[2]);  // a mirror turns surfaces inside out
  soup.corners.insert(soup.corners.end(), corner.begin(), corner.end());
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the scene graph
void append_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent,
                 TriangleSoup& soup) {
  const aiMatrix4x4 place = parent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) append_face(mesh, mesh.mFaces[f], place, soup);
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    append_node(scene, *node.mChildren[i], place, soup);
}

const aiScene* read_scene(Assimp::Importer& importer, const std::string& path) {
  constexpr unsigned kSteps = aiProcess_Triangulate | aiProcess_ValidateDataStructure;
  if (mesh_format(path) == MeshFormat::kPly) {
    const std::string ply = format_first(read_text_file(path), path);
    return importer.ReadFileFromMemory(ply.data(), ply.size(), kSteps, "ply");
  }
  if (mesh_format(path) == MeshFormat::kCollada) check_collada(read_text_file(path), path);
  if (mesh_format(path) != MeshFormat::kOff) return importer.ReadFile(path, kSteps);
  const std::string obj = off_as_obj(read_text_file(path), path);
  return importer.ReadFileFromMemory(obj.data(), obj.size(), kSteps, "obj");
}

[[noreturn]] void fail(const std::string& path, std::string why) {
  std::replace(why.begin(), why.end(), '\n', ' ');
  throw DataError(path, 1, why);
}

}  // namespace

TriangleSoup read_assimp_mesh(const std::string& path) {
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = nullptr;
  try {
    scene = read_scene(importer, path);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& broken) {
    fail(path, broken.what());
  }
  if (scene == nullptr) fail(path, importer.GetErrorString());
  TriangleSoup soup;
  if (scene->mRootNode != nullptr) append_node(*scene, *scene->mRootNode, {}, soup);
  return soup;
}

}  // namespace thenar
