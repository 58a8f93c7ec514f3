#pragma once

/// One cube in every mesh format, as other programs write it.

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

namespace thenar {

/// Corners of the cube 0..2 in the file's unit: bit k of the number is coordinate k, over 2.
inline std::string cube_corners(const std::string& prefix, const std::string& separator) {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += prefix + std::to_string(i % 2 * 2) + " " + std::to_string(i / 2 % 2 * 2) + " " +
            std::to_string(i / 4 * 2) + separator;
  return text;
}

/// Its six faces, counterclockwise seen from outside.
inline constexpr std::array<std::array<int, 4>, 6> kCubeFaces{
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

inline std::string cube_faces(const std::string& prefix, int first, const std::string& between,
                              const std::string& end) {
  std::string text;
  for (const auto& face : kCubeFaces) {
    text += prefix;
    for (int k = 0; k < 4; ++k)
      text += (k == 0 ? "" : between) + std::to_string(face[static_cast<std::size_t>(k)] + first);
    text += end;
  }
  return text;
}

inline std::string cube_obj() {
  return "# a cube\no cube\n" + cube_corners("v ", "\n") + cube_faces("f ", 1, " ", "\n");
}

inline std::string cube_off() {
  return "OFF\n8 6 12\n" + cube_corners("", "\n") + cube_faces("4 ", 0, " ", "\n");
}

inline std::string ply_header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment a cube\nelement vertex 8\nproperty float x\nproperty float y\n"
         "property float z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string cube_ply() {
  return ply_header("ascii") + cube_corners("", "\n") + cube_faces("4 ", 0, " ", "\n");
}

template <typename T>
std::string bytes_of(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

inline std::array<float, 3> cube_corner(int i) {
  const int y = i / 2 % 2, z = i / 4;
  return {static_cast<float>(i % 2 * 2), static_cast<float>(y * 2), static_cast<float>(z * 2)};
}

inline std::string cube_binary_ply() {
  std::string text = ply_header("binary_little_endian");
  for (int i = 0; i < 8; ++i)
    for (const float x : cube_corner(i)) text += bytes_of(x);
  for (const auto& face : kCubeFaces) {
    text += bytes_of(std::uint8_t{4});
    for (const int corner : face) text += bytes_of(std::int32_t{corner});
  }
  return text;
}

/// Calls visit(corner, corner, corner) for the cube's twelve triangles.
template <typename Visit>
void each_cube_triangle(const Visit& visit) {
  for (const auto& f : kCubeFaces) {
    visit(f[0], f[1], f[2]);
    visit(f[0], f[2], f[3]);
  }
}

inline std::string cube_stl() {
  std::string text = "solid cube\n";
  each_cube_triangle([&](int a, int b, int c) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int i : {a, b, c}) {
      text += "vertex";
      for (const float x : cube_corner(i)) text += " " + std::to_string(x);
      text += "\n";
    }
    text += "endloop\nendfacet\n";
  });
  return text + "endsolid cube\n";
}

inline std::string cube_binary_stl() {
  std::string text = std::string(80, ' ') + bytes_of(std::uint32_t{12});
  each_cube_triangle([&](int a, int b, int c) {
    text += std::string(12, '\0');
    for (const int i : {a, b, c})
      for (const float x : cube_corner(i)) text += bytes_of(x);
    text += std::string(2, '\0');
  });
  return text;
}

/// Base64 without line breaks. @param bytes  of a length that 3 divides
inline std::string base64(const std::string& bytes) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i + 2 < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | static_cast<std::uint8_t>(bytes[i + k]);
    for (int shift = 18; shift >= 0; shift -= 6) text += letters[three >> shift & 63];
  }
  return text;
}

/// In a node that stands 10 along x.
inline std::string cube_gltf() {
  std::string buffer;
  for (int i = 0; i < 8; ++i)
    for (const float x : cube_corner(i)) buffer += bytes_of(x);
  each_cube_triangle([&](int a, int b, int c) {
    for (const int i : {a, b, c}) buffer += bytes_of(static_cast<std::uint16_t>(i));
  });
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "translation": [10, 0, 0]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3",
       "min": [0, 0, 0], "max": [2, 2, 2]},
      {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 96},
                    {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
    "buffers": [{"byteLength": 168, "uri": "data:application/octet-stream;base64,)" +
         base64(buffer) + "\"}]}";
}

inline std::string cube_vrml1(const std::string& header = "#VRML V1.0 ascii") {
  return header + "\nSeparator {\n  Transform { translation 10 0 0 }\n  Coordinate3 { point [\n" +
         cube_corners("", ",\n") + "] }\n  IndexedFaceSet { coordIndex [\n" +
         cube_faces("", 0, ", ", ", -1,\n") + "] }\n}\n";
}

inline std::string cube_vrml2() {
  return "#VRML V2.0 utf8\nTransform { translation 10 0 0 children [ Shape {\n"
         "  geometry IndexedFaceSet { coord Coordinate { point [\n" +
         cube_corners("", ",\n") + "] } coordIndex [\n" + cube_faces("", 0, ", ", ", -1,\n") +
         "] } } ] }\n";
}

/// Moved 10 along x; in half metres; "z is up", which is not heeded.
inline std::string cube_collada() {
  return "<?xml version='1.0'?>\n<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
         "version='1.4.1'><asset><unit name='half' meter='0.5'/><up_axis>Z_UP</up_axis></asset>"
         "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='a' "
         "count='24'>" +
         cube_corners("", " ") +
         "</float_array><technique_common><accessor source='#a' count='8' stride='3'><param "
         "name='X' type='float'/><param name='Y' type='float'/><param name='Z' type='float'/>"
         "</accessor></technique_common></source><vertices id='v'><input semantic='POSITION' "
         "source='#p'/></vertices><polylist count='6'><input semantic='VERTEX' source='#v' "
         "offset='0'/><vcount>4 4 4 4 4 4</vcount><p>" +
         cube_faces("", 0, " ", " ") +
         "</p></polylist></mesh></geometry></library_geometries><library_visual_scenes>"
         "<visual_scene id='s'><node><matrix>2 0 0 20 0 2 0 0 0 0 2 0 0 0 0 1</matrix>"
         "<instance_geometry url='#g'/></node></visual_scene></library_visual_scenes><scene>"
         "<instance_visual_scene url='#s'/></scene></COLLADA>";
}

}  // namespace thenar
