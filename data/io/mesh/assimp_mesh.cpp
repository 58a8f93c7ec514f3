// The one fence of assimp.

#include "data/io/mesh/assimp_mesh.h"

#include <algorithm>
#include <array>
#include <utility>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include "base/error.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/mesh/off_text.h"
#include "data/io/toml_node.h"

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

}  // namespace

TriangleSoup read_assimp_mesh(const std::string& path) {
  constexpr unsigned kSteps = aiProcess_Triangulate | aiProcess_ValidateDataStructure;
  Assimp::Importer importer;
  const aiScene* scene = nullptr;
  if (mesh_format(path) == MeshFormat::kOff) {
    const std::string obj = off_as_obj(read_text_file(path), path);
    scene = importer.ReadFileFromMemory(obj.data(), obj.size(), kSteps, "obj");
  } else {
    scene = importer.ReadFile(path, kSteps);
  }
  if (scene == nullptr) {
    std::string why = importer.GetErrorString();
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw DataError(path, 1, why);
  }
  TriangleSoup soup;
  if (scene->mRootNode != nullptr) append_node(*scene, *scene->mRootNode, {}, soup);
  return soup;
}

}  // namespace thenar
