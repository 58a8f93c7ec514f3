#pragma once

/// Meshes that stand in no file, as STL files beside the file that names them.

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/shape_spec.h"

namespace thenar {

/// Returns the surface as an STL file keeps it: corners in single precision, welded as they are
/// read.
/// @throws DataError if no triangle is left of it
[[nodiscard]] TriangleMesh as_in_stl(const TriangleMesh& mesh);

/// A file and the STL files of the meshes that it names and that stand in no file yet.
class StlFiles {
 public:
  /// @param out  the file that names the others, which stand beside it
  explicit StlFiles(std::string out) : out_(std::move(out)) {}

  /// Leaves the files alone where meshes of these shapes stand. To be called of all shapes first.
  void leave(const std::vector<ShapeSpec>& shapes);
  /// Gives each mesh that stands in no file one beside `out`, "hand_palm_0.stl", if it bounds as
  /// many solids when it is read from there; else the triangles stay in the shape.
  /// @param owner  whose shapes they are, for names: "palm"
  void give(std::vector<ShapeSpec>& shapes, const std::string& owner);
  /// Returns the paths and contents of the files that give() made.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& files() const {
    return files_;
  }
  /// Writes them, and `out` last, as it names the others.
  void write(const std::string& text);

 private:
  std::string out_;
  std::set<std::string> taken_;  // normal absolute paths that are not to be written
  std::vector<std::pair<std::string, std::string>> files_;
};

}  // namespace thenar
