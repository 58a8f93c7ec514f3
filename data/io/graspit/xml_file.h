#pragma once

/// XML files that remember line numbers.

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pugi {
class xml_node;
}

namespace thenar {

/// A parsed file. Its nodes point into it: it must outlive them.
class XmlFile {
 public:
  /// Reads and parses `path`, in UTF-8 or Latin-1. @throws DataError if it cannot be read, is not
  /// XML, or exceeds the limits of file_guard.h.
  explicit XmlFile(const std::string& path);
  /// Parses `text`; `path` only names it in messages.
  XmlFile(std::string text, std::string path);
  ~XmlFile();
  XmlFile(const XmlFile&) = delete;
  XmlFile& operator=(const XmlFile&) = delete;

  /// Returns the outermost element.
  [[nodiscard]] pugi::xml_node root() const;
  [[nodiscard]] std::string root_name() const;

  [[nodiscard]] const std::string& path() const { return path_; }

  /// Returns the line number of an element, from 1.
  [[nodiscard]] int line(const pugi::xml_node& node) const;

  /// Renames elements that differ from one of these names by case only.
  /// @param names  separated by spaces
  void settle_case(const std::string& names);

  /// Throws a DataError at an element.
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& what) const;

  /// Returns the text inside an element, without white space around it.
  [[nodiscard]] std::string text(const pugi::xml_node& node) const;

  /// Returns the numbers in an element's text, separated by spaces, commas or brackets.
  /// @param count  number wanted; 0: any
  /// @throws DataError if their number differs, or one is not a finite number.
  [[nodiscard]] std::vector<double> numbers(const pugi::xml_node& node, int count = 0) const;
  /// Returns the three numbers in an element.
  [[nodiscard]] Eigen::Vector3d vector3(const pugi::xml_node& node) const;

  /// Returns the warning "path:line: <name> is not understood and was left out".
  [[nodiscard]] std::string not_understood(const pugi::xml_node& node) const;

 private:
  struct Document;
  std::string text_;
  std::string path_;
  std::unique_ptr<Document> document_;
};

}  // namespace thenar

namespace thenar::internal {

/// Returns the next node after `node` in the order of the text, below `top`: its first child,
/// otherwise the next sibling of it or of an ancestor; null at the end. Needs no stack, however
/// deep the XML nests: for (pugi::xml_node node = top; node; node = next_below(top, node)) ..
/// @tparam Node  pugi::xml_node
template <typename Node>
[[nodiscard]] Node next_below(const Node& top, Node node) {
  if (const Node child = node.first_child()) return child;
  for (; node && node != top; node = node.parent())
    if (const Node next = node.next_sibling()) return next;
  return {};
}

}  // namespace thenar::internal
