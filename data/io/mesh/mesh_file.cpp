#include "data/io/mesh/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include "base/error.h"

namespace thenar {
namespace {

/// By the ending; null: it is no mesh.
const MeshFormat* find_format(const std::string& path) {
  static const std::map<std::string, MeshFormat> formats{
      {".obj", MeshFormat::kObj},     {".stl", MeshFormat::kStl},   {".ply", MeshFormat::kPly},
      {".off", MeshFormat::kOff},     {".gltf", MeshFormat::kGltf}, {".glb", MeshFormat::kGltf},
      {".dae", MeshFormat::kCollada}, {".wrl", MeshFormat::kVrml},  {".vrml", MeshFormat::kVrml},
      {".iv", MeshFormat::kInventor}};
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found = formats.find(ending);
  return found == formats.end() ? nullptr : &found->second;
}

}  // namespace

MeshFormat mesh_format(const std::string& path) {
  const MeshFormat* format = find_format(path);
  if (format == nullptr)
    throw DataError(path, 1,
                    "a mesh is .obj, .stl, .ply, .off, .gltf, .glb, .dae, .wrl, .vrml or .iv");
  return *format;
}

bool is_mesh_file(const std::string& path) { return find_format(path) != nullptr; }

}  // namespace thenar
