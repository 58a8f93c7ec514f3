#pragma once

/// Numbers in the attributes of XML, and what of a file was not read. Only sources include this.

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/graspit/xml_file.h"

namespace pugi {
class xml_node;
}

namespace thenar::internal {

/// Numbers set apart by spaces or commas, all finite.
/// @param what  names them in the message
/// @throws DataError with the line of `node`.
[[nodiscard]] std::vector<double> parse_numbers(const XmlFile& file, const pugi::xml_node& node,
                                                const std::string& text, const std::string& what);

/// One number, nothing else. @throws DataError
[[nodiscard]] double parse_number(const XmlFile& file, const pugi::xml_node& node,
                                  const std::string& text, const std::string& what);

/// Exactly three. @throws DataError
[[nodiscard]] Eigen::Vector3d parse_vector3(const XmlFile& file, const pugi::xml_node& node,
                                            const std::string& text, const std::string& what);

/// An attribute as a number, `otherwise` where it is absent. @throws DataError
[[nodiscard]] double number_or(const XmlFile& file, const pugi::xml_node& node,
                               const char* attribute, double otherwise);

/// An attribute that must be there and not empty. @throws DataError
[[nodiscard]] std::string required_text(const XmlFile& file, const pugi::xml_node& node,
                                        const char* attribute);

/// What was met and not understood, each once, with the lines it stands on:
/// "<transmission> is not read (2 times: lines 12, 30)".
class UnreadElements {
 public:
  explicit UnreadElements(const XmlFile& file) : file_(file) {}
  void note(const pugi::xml_node& node, const std::string& what);
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  struct Entry {
    std::string what;
    std::vector<int> lines;
  };
  const XmlFile& file_;
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t> by_what_;  // where each stands among the entries
};

}  // namespace thenar::internal
