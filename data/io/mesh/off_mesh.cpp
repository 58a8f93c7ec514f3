#include "data/io/mesh/off_mesh.h"

#include <set>

#include "base/error.h"
#include "data/io/mesh/text_lines.h"

namespace thenar {
namespace {

constexpr int kMost = 100'000'000;  // corners or faces: anything above is no count

void go_on(TextLines& lines) {
  if (!lines.next()) lines.fail("the file ends before all corners and faces are told");
}

}  // namespace

Polygons parse_off(const std::string& text, const std::string& path) {
  static const std::set<std::string_view> kinds{"OFF",   "COFF",   "NOFF",   "CNOFF",
                                                "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
  TextLines lines(text, path);
  go_on(lines);
  const std::string_view kind = lines.word();
  if (kinds.count(kind) == 0)
    lines.fail(fmt::format("wanted an OFF in text, got {}", in_quotes(kind)));
  // The counts stand behind the word or on the next line.
  TextLines same = lines;
  if (same.word().empty()) go_on(lines);
  const int corners = lines.whole(0, kMost), faces = lines.whole(0, kMost);
  // "0 0 0" and a line's end take 6 bytes, the shortest face takes 2.
  if (6.0 * corners + 2.0 * faces > static_cast<double>(lines.bytes_left()) + 1)
    lines.fail(fmt::format("{} corners and {} faces are promised, more than {} bytes can hold",
                           corners, faces, lines.bytes_left()));

  Polygons found;
  for (int i = 0; i < corners; ++i) {
    go_on(lines);
    const double x = lines.number(), y = lines.number(), z = lines.number();
    found.vertices.emplace_back(x, y, z);
  }
  for (int i = 0; i < faces; ++i) {
    go_on(lines);
    const int sides = lines.whole(1, kMost);
    for (int k = 0; k < sides; ++k) found.corners.push_back(lines.whole(0, corners - 1));
    found.sizes.push_back(sides);
    found.lines.push_back(lines.line());
  }
  return found;
}

}  // namespace thenar
