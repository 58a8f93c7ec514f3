#pragma once

/// Small mesh files made to crash, exhaust or spy on whoever reads them, with what refuses each.

#include <string>
#include <vector>

#include "tests/data/mesh/cube_files.h"

namespace thenar {

inline std::string times(const std::string& text, int n) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

/// `text` with the first `from` in it turned into `to`.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// Each level of a scene uses the one below ten times. @param leaf  what stands at the bottom
inline std::string tenfold_vrml(int levels, const std::string& leaf) {
  std::string text = "#VRML V2.0 utf8\nDEF N0 Group { children [ " + leaf + " ] }\n";
  for (int i = 1; i <= levels; ++i)
    text += "DEF N" + std::to_string(i) + " Group { children [" +
            times(" USE N" + std::to_string(i - 1), 10) + " ] }\n";
  return text;
}

inline std::string tenfold_inventor(int levels) {
  std::string text = "#Inventor V2.1 ascii\nDEF N0 Separator { Sphere {} }\n";
  for (int i = 1; i <= levels; ++i)
    text += "DEF N" + std::to_string(i) + " Separator {" +
            times(" USE N" + std::to_string(i - 1), 10) + " }\n";
  return text;
}

/// Ten <instance_node> of the node below on every level.
inline std::string tenfold_collada(int levels) {
  std::string nodes = "<library_nodes><node id='n0'><instance_geometry url='#g'/></node>";
  for (int i = 1; i <= levels; ++i)
    nodes += "<node id='n" + std::to_string(i) + "'>" +
             times("<instance_node url='#n" + std::to_string(i - 1) + "'/>", 10) + "</node>";
  nodes += "</library_nodes><library_visual_scenes>";
  const std::string text = with(cube_collada(), "<library_visual_scenes>", nodes);
  return with(text, "<instance_geometry url='#g'/></node></visual_scene>",
              "<instance_node url='#n" + std::to_string(levels) + "'/></node></visual_scene>");
}

inline std::string ply_promise(const std::string& format, const std::string& count) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + count +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list "
         "uint int vertex_indices\nend_header\n";
}

/// A glTF in bytes around a JSON.
inline std::string glb(const std::string& json) {
  const auto size = static_cast<std::uint32_t>(json.size());
  return "glTF" + bytes_of(std::uint32_t{2}) + bytes_of(size + 20) + bytes_of(size) + "JSON" + json;
}

struct HostileFile {
  std::string name;  // its ending is its kind
  std::string content;
  std::string refusal;  // what its message has; empty: it is read, and does no harm
};

inline std::vector<HostileFile> hostile_meshes() {
  constexpr int kDeep = 100'000;
  const std::string deep = "nests at most";
  std::vector<HostileFile> files{
      // Nesting, on which parsers recurse.
      {"deep.dae", "<COLLADA>" + times("<node>", kDeep) + times("</node>", kDeep) + "</COLLADA>",
       deep},
      {"deep.gltf", "{\"a\":" + times("[", kDeep) + times("]", kDeep) + "}", deep},
      {"deep.glb", glb("{\"a\":" + times("{\"a\":", kDeep) + "1" + times("}", kDeep) + "}"), deep},
      // Promises that the file cannot keep.
      {"vertices.ply", ply_promise("ascii", "100000000"), "3: the header promises"},
      {"wraps.ply", ply_promise("ascii", "18446744073709551615"), "3: the header promises"},
      {"too_large.ply", ply_promise("ascii", "99999999999999999999"), "3: wanted the header"},
      {"list.ply",
       ply_promise("binary_little_endian", "1") + times(bytes_of(1.0F), 3) +
           bytes_of(std::uint32_t{0xffffffff}),
       "ends before"},
      {"face.ply", ply_promise("ascii", "1") + "0 0 0\n4000000000 0\n", "wanted a finite number"},
      {"far.ply", ply_promise("ascii", "1") + "0 0 0\n3 0 0 2000000000\n", "a face has corner"},
      {"count.stl", std::string(80, ' ') + bytes_of(std::uint32_t{0xffffffff}) + times("x", 100),
       "wanted 4294967295 triangles"},
      {"count.off", "OFF\n100000000 100000000 0\n0 0 0\n", "are promised"},
      {"sides.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n100000000 0 1 2\n", "wanted a finite number"},
      {"far.obj", "v 0 0 0\nf 1 1 2000000000\n", "a face has corner"},
      {"back.obj", "v 0 0 0\nf -1 -1 -2147483648\n", "before the first"},
      {"accessor.gltf", with(cube_gltf(), "\"count\": 36", "\"count\": 2000000000"), ":"},
      {"zeros.gltf",
       with(cube_gltf(), R"({"bufferView": 0, "componentType": 5126, "count": 8)",
            R"({"componentType": 5126, "count": 1000000000)"),
       ":"},
      {"buffer.gltf", with(cube_gltf(), "\"byteLength\": 168", "\"byteLength\": 4000000000"), ":"},
      // Cycles and products.
      {"cycle.gltf", with(cube_gltf(), R"({"mesh": 0,)", R"({"children": [0], "mesh": 0,)"), ":"},
      {"cycle.dae", with(cube_collada(), "<node>", "<node id='n'><instance_node url='#n'/>"),
       "contains itself"},
      {"tenfold.dae", tenfold_collada(9), "stand for more than"},
      {"words.stl", "solid " + times("facet ", 100'000) + "\n", "cut off"},
      {"white.stl", "solid facet" + times(" ", 1'000'000) + "\n", "cut off"},
      {"comment.ply", "ply\nformat ascii 1.0\ncomment " + times("x", 1'000'000) + "\nend_header\n",
       "without triangles"},
  };
  // A comb: cutting off its teeth takes the square of their number.
  std::string comb, face = "f";
  for (int i = 0; i < 40'000; ++i) {
    comb += "v " + std::to_string(i) + (i % 2 == 0 ? " 1 0\n" : " 2 0\n");
    face += " " + std::to_string(40'000 - i);
  }
  files.push_back(
      {"comb.obj", comb + "v 0 0 0\nv 40000 0 0\n" + face + " 40001 40002\n", "convex"});
#ifdef THENAR_HAS_COIN
  const std::vector<HostileFile> scenes{
      {"deep.iv", "#Inventor V2.1 ascii\n" + times("Separator {", kDeep) + times("}", kDeep), deep},
      {"deep.wrl", "#VRML V2.0 utf8\n" + times("Group { children [", kDeep) + times("] }", kDeep),
       deep},
      {"itself.iv", "#Inventor V2.1 ascii\nFile { name \"itself.iv\" }\n", "2: <File>"},
      {"itself.wrl", "#VRML V2.0 utf8\n\nInline { url \"itself.wrl\" }\n", "3: <Inline>"},
      {"old.wrl", "#VRML V1.0 ascii\nWWWInline { name \"old.wrl\" }\n", "2: <WWWInline>"},
      {"proto.wrl", "#VRML V2.0 utf8\nEXTERNPROTO P [] \"proto.wrl\"\nP {}\n", "EXTERNPROTO"},
      {"tenfold.wrl", tenfold_vrml(9, "Shape { geometry Box {} }"), "stands for more than"},
      {"tenfold.iv", tenfold_inventor(9), "stands for more than"},
  };
  files.insert(files.end(), scenes.begin(), scenes.end());
#endif
  return files;
}

}  // namespace thenar
