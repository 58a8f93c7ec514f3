#pragma once

/// Searches in lists, and transformations of lists.

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace thenar {

/// Returns true if a list contains a value.
template <typename List, typename Value>
[[nodiscard]] bool contains(const List& list, const Value& value) {
  return std::find(std::begin(list), std::end(list), value) != std::end(list);
}

/// Returns the index of the first entry with a value; -1: there is none.
template <typename List, typename Value>
[[nodiscard]] int place_in(const List& list, const Value& value) {
  const auto found = std::find(std::begin(list), std::end(list), value);
  return found == std::end(list) ? -1 : static_cast<int>(found - std::begin(list));
}

/// Returns the first entry that passes a test; null: there is none.
template <typename List, typename Test>
[[nodiscard]] auto* find_where(List& list, const Test& test) {
  const auto found = std::find_if(std::begin(list), std::end(list), test);
  return found == std::end(list) ? nullptr : &*found;
}

/// Returns the first entry whose member `name` equals `name`; null: there is none.
template <typename List>
[[nodiscard]] auto* find_named(List& list, const std::string& name) {
  return find_where(list, [&](const auto& each) { return each.name == name; });
}

/// Returns the index of the first entry whose member `name` equals `name`; -1: there is none.
template <typename Entry>
[[nodiscard]] int place_named(const std::vector<Entry>& list, const std::string& name) {
  const Entry* found = find_named(list, name);
  return found == nullptr ? -1 : static_cast<int>(found - list.data());
}

/// Returns true if any entry passes a test.
template <typename List, typename Test>
[[nodiscard]] bool any_of(const List& list, const Test& test) {
  return std::any_of(std::begin(list), std::end(list), test);
}

/// Returns true if all entries pass a test.
template <typename List, typename Test>
[[nodiscard]] bool all_of(const List& list, const Test& test) {
  return std::all_of(std::begin(list), std::end(list), test);
}

/// Returns the results of a function for each entry, or a member of each, in the order of the list.
template <typename List, typename Make>
[[nodiscard]] auto transformed(const List& list, const Make& make) {
  std::vector<std::decay_t<decltype(std::invoke(make, *std::begin(list)))>> made;
  made.reserve(static_cast<std::size_t>(std::distance(std::begin(list), std::end(list))));
  for (const auto& each : list) made.push_back(std::invoke(make, each));
  return made;
}

/// Returns the members `name` of all entries, in the order of the list.
template <typename List>
[[nodiscard]] std::vector<std::string> names_of(const List& list) {
  return transformed(list, [](const auto& each) { return each.name; });
}

/// Returns the keys of a map, in its order.
template <typename Map>
[[nodiscard]] std::vector<typename Map::key_type> map_keys(const Map& map) {
  return transformed(map, [](const auto& each) { return each.first; });
}

/// Removes the entries that pass a test.
template <typename List, typename Test>
void erase_where(List& list, const Test& test) {
  list.erase(std::remove_if(std::begin(list), std::end(list), test), std::end(list));
}

/// Adds all entries of a list to the end of another.
template <typename List, typename More>
void append_all(List& list, const More& more) {
  list.insert(std::end(list), std::begin(more), std::end(more));
}

/// Adds those entries of a list to the end of another that are not in it yet.
template <typename List, typename More>
void append_new(List& list, const More& more) {
  for (const auto& each : more)
    if (!contains(list, each)) list.push_back(each);
}

}  // namespace thenar
