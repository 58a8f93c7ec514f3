#pragma once

/// STL files for meshes without a file, beside the file that refers to them.

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/shape_spec.h"

namespace thenar {

/// Returns the surface as stored in an STL file: corners in single precision, welded as by the
/// reader.
/// @throws DataError if no triangle is left of it
[[nodiscard]] TriangleMesh as_in_stl(const TriangleMesh& mesh);

/// Writer of a file and of STL files for its meshes that have no file yet.
class StlFiles {
 public:
  /// @param out  file that refers to the others, which are written beside it
  explicit StlFiles(std::string out) : out_(std::move(out)) {}

  /// Excludes the mesh files of these shapes from being overwritten. Call it for all shapes first.
  void leave(const std::vector<ShapeSpec>& shapes);
  /// Assigns a file beside `out`, "hand_palm_0.stl", to each mesh without one, if it bounds the
  /// same number of solids when read from there; else the triangles are kept in the shape.
  /// @param owner  owner of the shapes, for file names: "palm"
  void give(std::vector<ShapeSpec>& shapes, const std::string& owner);
  /// Returns the paths and contents of the files that give() made.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& files() const {
    return files_;
  }
  /// Writes the STL files, and `out` last, as it refers to them.
  void write(const std::string& text);

 private:
  std::string out_;
  std::set<std::string> taken_;  // normalised absolute paths that must not be overwritten
  std::vector<std::pair<std::string, std::string>> files_;
};

}  // namespace thenar
