#pragma once

/// Names and paths that come from outside: from a client's request, a dropped file, a log, a result
/// file, or a file that names another. What such a text may be is decided here and nowhere else;
/// tests/outside_paths_test.py lists the places that make paths of texts.

#include <cstddef>
#include <optional>
#include <string>

namespace thenar {

/// Purpose of a name from outside.
enum class OutsideUse {
  kRead,    // a name, or any file of this machine: UTF-8 as it is, without control characters
  kInside,  // a file in a folder: also relative, without "..", no part of it begins with a dot
};

/// Most bytes of a path from outside.
inline constexpr std::size_t kLongestOutsidePath = 4000;

/// Returns the fault of a text, as "a control character at byte 3"; nothing if it may be taken.
[[nodiscard]] std::optional<std::string> outside_fault(const std::string& text, OutsideUse use);

/// Returns the text as a path, "a/b" of kInside for "./a//b". It is this string that is to be
/// looked at and opened.
/// @throws InputError with the fault
[[nodiscard]] std::string outside_path(const std::string& text, OutsideUse use);

/// Returns the path of a file that a file in `folder` names: beside it, or where an absolute name
/// leads.
/// @throws InputError with the fault of the name, or if it leads out of a LinkFence
[[nodiscard]] std::string linked_path(const std::string& folder, const std::string& name);

/// Returns whether files in `folder` may name a file: false if a LinkFence stands between them.
[[nodiscard]] bool may_link(const std::string& folder, const std::string& path);

/// Keeps what stands in a folder together for as long as it lives: files in a subfolder of it name
/// files of the same subfolder alone, links followed. What strangers sent is put into such folders.
class LinkFence {
 public:
  explicit LinkFence(const std::string& folder);
  ~LinkFence();
  LinkFence(const LinkFence&) = delete;
  LinkFence& operator=(const LinkFence&) = delete;

 private:
  std::string folder_;
};

}  // namespace thenar
