#include "data/io/mesh/obj_mesh.h"

#include <charconv>
#include <limits>

#include "base/error.h"
#include "data/io/mesh/text_lines.h"

namespace thenar {
namespace {

/// The vertex of a corner "V", "V/T", "V//N" or "V/T/N", from 0; V counts from 1, or from the last
/// one backwards if it is negative.
int vertex_of(TextLines& lines, std::string_view corner, std::size_t count) {
  const std::string_view first = corner.substr(0, corner.find('/'));
  int number = 0;
  const auto [stop, error] = std::from_chars(first.data(), first.data() + first.size(), number);
  if (error != std::errc() || stop != first.data() + first.size() || number == 0)
    lines.fail(fmt::format("wanted the number of a vertex, got {}", in_quotes(corner)));
  if (number > 0) return number - 1;
  if (static_cast<std::size_t>(-static_cast<long>(number)) > count)
    lines.fail(
        fmt::format("corner {} of a face lies before the first of {} vertices", number, count));
  return static_cast<int>(count) + number;
}

}  // namespace

Polygons parse_obj(const std::string& text, const std::string& path) {
  TextLines lines(text, path);
  Polygons found;
  while (lines.next()) {
    const std::string_view kind = lines.word();
    if (kind == "v") {
      const double x = lines.number(), y = lines.number(), z = lines.number();
      found.vertices.emplace_back(x, y, z);
    } else if (kind == "f") {
      const std::size_t first = found.corners.size();
      for (std::string_view corner; !(corner = lines.word()).empty();)
        found.corners.push_back(vertex_of(lines, corner, found.vertices.size()));
      found.sizes.push_back(static_cast<int>(found.corners.size() - first));
      found.lines.push_back(lines.line());
    }
  }
  return found;
}

}  // namespace thenar
