#include "data/io/mesh/ply_header.h"

#include <regex>
#include <sstream>

#include "base/error.h"

namespace thenar {

void check_ply_header(const std::string& text, const std::string& path) {
  static const std::string kType =
      "(char|uchar|short|ushort|int|uint|float|double|u?int(8|16|32)|float(32|64))";
  static const std::regex known("(comment|obj_info)( .*)?|element [a-zA-Z_]+ [0-9]{1,8}|property " +
                                kType + " \\S+|property list " + kType + " " + kType +
                                " \\S+|end_header");
  static const std::regex format("format (ascii|binary_(little|big)_endian) 1\\.0");
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line.erase(line.find_last_not_of(" \t\r") + 1);
    const bool good = number == 1   ? line == "ply"
                      : number == 2 ? std::regex_match(line, format)
                                    : std::regex_match(line, known);
    if (!good)
      throw DataError(path, number,
                      fmt::format("wanted the header of a PLY, got '{}'", line.substr(0, 40)));
    if (line == "end_header") return;
  }
  throw DataError(path, number, "the header of this PLY has no end");
}

}  // namespace thenar
