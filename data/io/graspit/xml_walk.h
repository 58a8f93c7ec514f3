#pragma once

/// Walks over XML that need no stack, however deep it nests. Only sources include this.

#include <pugixml.hpp>

namespace thenar::internal {

/// The node behind `node` in the order of the text, below `top`: its first child, else the next
/// beside it or beside one above it. Null behind the last.
/// for (pugi::xml_node node = top; node; node = next_below(top, node)) ..
[[nodiscard]] inline pugi::xml_node next_below(const pugi::xml_node& top, pugi::xml_node node) {
  if (const pugi::xml_node child = node.first_child()) return child;
  for (; node && node != top; node = node.parent())
    if (const pugi::xml_node next = node.next_sibling()) return next;
  return {};
}

}  // namespace thenar::internal
