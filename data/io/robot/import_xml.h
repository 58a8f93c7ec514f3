#pragma once

/// Numbers in XML attributes, and notes about elements that are not read. For sources only.

#include <map>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/graspit/xml_file.h"

namespace thenar::internal {

/// Reads finite numbers, separated by spaces or commas.
/// @param what  their name in the message
/// @throws DataError with the line of `node`.
[[nodiscard]] std::vector<double> parse_numbers(const XmlFile& file, const pugi::xml_node& node,
                                                const std::string& text, const std::string& what);

/// Reads exactly one number. @throws DataError
[[nodiscard]] double parse_number(const XmlFile& file, const pugi::xml_node& node,
                                  const std::string& text, const std::string& what);

/// Reads exactly three numbers. @throws DataError
[[nodiscard]] Eigen::Vector3d parse_vector3(const XmlFile& file, const pugi::xml_node& node,
                                            const std::string& text, const std::string& what);

/// Reads an attribute as a number, `otherwise` if it is absent. @throws DataError
[[nodiscard]] double number_or(const XmlFile& file, const pugi::xml_node& node,
                               const char* attribute, double otherwise);

/// Reads an attribute that must be present and not empty. @throws DataError
[[nodiscard]] std::string required_text(const XmlFile& file, const pugi::xml_node& node,
                                        const char* attribute);

/// Adds a unique name: the wanted one, with an added number where needed; `otherwise` replaces "".
[[nodiscard]] std::string add_unique_name(std::set<std::string>& names, const std::string& wanted,
                                          const std::string& otherwise = "");

/// Collects elements that are not read, each message once with its lines; `file` must outlive it:
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
  std::map<std::string, std::size_t> by_what_;  // index among the entries
};

}  // namespace thenar::internal
