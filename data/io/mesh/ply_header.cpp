#include "data/io/mesh/ply_header.h"

#include <regex>
#include <sstream>

#include "base/error.h"

namespace thenar {

std::string format_first(std::string text, const std::string& path) {
  static const std::string kType =
      "(char|uchar|short|ushort|int|uint|float|double|u?int(8|16|32)|float(32|64))";
  static const std::regex known("(comment|obj_info)( .*)?|element [a-zA-Z_]+ [0-9]{1,8}|property " +
                                kType + " \\S+|property list " + kType + " " + kType +
                                " \\S+|end_header");
  static const std::regex format("format (ascii|binary_(little|big)_endian) 1\\.0");
  std::istringstream lines(text);
  int number = 0;
  bool has_format = false;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line.erase(line.find_last_not_of(" \t\r") + 1);
    const bool good = number == 1 ? line == "ply"
                      : has_format
                          ? std::regex_match(line, known)
                          : std::regex_match(line, format) || line.rfind("comment", 0) == 0;
    has_format = has_format || line.rfind("format", 0) == 0;
    if (!good)
      throw DataError(path, number,
                      fmt::format("wanted the header of a PLY, got '{}'", line.substr(0, 40)));
    if (line != "end_header") continue;
    const std::size_t first = text.find('\n') + 1;
    return text.erase(first, text.find("\nformat") + 1 - first);
  }
  throw DataError(path, number, "the header of this PLY has no end");
}

}  // namespace thenar
