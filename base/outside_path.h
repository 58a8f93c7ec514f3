#pragma once

/// Validation of untrusted names and paths: from a client's request, a dropped file, a log, a
/// result file, or a file that names another. Such texts are checked here and nowhere else;
/// tests/outside_paths_test.py lists the places that make paths of texts.

#include <cstddef>
#include <optional>
#include <string>

namespace thenar {

/// Purpose of an untrusted name.
enum class OutsideUse {
  kRead,    // a name, or any file of this machine: UTF-8 without control characters
  kInside,  // a file in a folder: in addition relative, without "..", no part begins with a dot
};

/// Largest length of an untrusted path [bytes].
inline constexpr std::size_t kMaxOutsidePath = 4000;

/// Returns the fault of a text: "a control character at byte 3"; absent if it is acceptable.
[[nodiscard]] std::optional<std::string> outside_fault(const std::string& text, OutsideUse use);

/// Returns the text as a normalised path, for kInside "a/b" for "./a//b". Use the returned string
/// for all checks and for opening.
/// @throws InputError with the fault
[[nodiscard]] std::string outside_path(const std::string& text, OutsideUse use);

/// Returns the path of a file that is named in a file in `folder`: relative to the folder, or
/// absolute.
/// @throws InputError with the fault of the name, or if it leaves a LinkFence
[[nodiscard]] std::string linked_path(const std::string& folder, const std::string& name);

/// Returns true if files in `folder` may refer to a file: no LinkFence separates them.
[[nodiscard]] bool may_link(const std::string& folder, const std::string& path);

/// Scope in which files in a subfolder of `folder` may refer only to files of the same subfolder,
/// after links are resolved. Uploaded files are put into such folders.
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
