#pragma once

/// Walks over XML that need no stack, however deep it nests.

namespace thenar::internal {

/// The node behind `node` in the order of the text, below `top`: its first child, else the next
/// beside it or beside one above it. Null behind the last.
/// for (pugi::xml_node node = top; node; node = next_below(top, node)) ..
/// @tparam Node  pugi::xml_node
template <typename Node>
[[nodiscard]] Node next_below(const Node& top, Node node) {
  if (const Node child = node.first_child()) return child;
  for (; node && node != top; node = node.parent())
    if (const Node next = node.next_sibling()) return next;
  return {};
}

}  // namespace thenar::internal
