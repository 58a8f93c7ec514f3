#include "base/outside_path.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <mutex>
#include <system_error>
#include <vector>

#include "base/error.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kShownName = 300;  // Most bytes of a name in a message [bytes]
// Most parts of a name; programs that tidy up give up on deeper names
constexpr std::ptrdiff_t kMaxNameParts = 32;

/// The place of the first control character, of C1 (U+0080 to U+009F in UTF-8) too; npos: none.
std::size_t find_control(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x20 || byte == 0x7F) return i;
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if (byte == 0xC2 && next >= 0x80 && next < 0xA0) return i;
  }
  return std::string::npos;
}

/// Returns the reason why a path is no file in a folder; nothing if it is one.
std::optional<std::string> fault_inside(const std::string& text) {
  const fs::path path(text);
  // Paths of other systems are refused too, because files travel.
  if (path.is_absolute()) return "an absolute path";
  if (text.find('\\') != std::string::npos) return "a backslash";
  for (const fs::path& part : path) {
    if (part == "..") return "'..', which leads out of the folder";
    if (part != "." && part.string().front() == '.') return "a part that begins with a dot";
  }
  if (std::distance(path.begin(), path.end()) > kMaxNameParts)
    return fmt::format("more than {} parts", kMaxNameParts);
  if (!path.has_filename() || path.filename() == ".") return "no name of a file";
  return std::nullopt;
}

/// Folders with fences; several sessions of a process may have one each.
struct Fences {
  std::mutex mutex;
  std::vector<std::string> folders;
};

Fences& fences() {
  static Fences all;
  return all;
}

fs::path real_path(const fs::path& path) {
  std::error_code none;
  const fs::path whole = fs::absolute(path, none);
  const fs::path real = fs::weakly_canonical(whole, none);
  return none ? whole.lexically_normal() : real;
}

bool is_below(const fs::path& folder, const fs::path& path) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

/// The subfolder that files in a folder may not name their way out of; "" if there is none.
fs::path fence_around(const std::string& folder) {
  Fences& all = fences();
  const std::lock_guard<std::mutex> lock(all.mutex);
  if (all.folders.empty()) return "";
  const fs::path real = real_path(folder.empty() ? "." : folder);
  for (const fs::path fenced : all.folders)
    if (real != fenced && is_below(fenced, real))
      return fenced / *real.lexically_relative(fenced).begin();
  return "";
}

}  // namespace

std::optional<std::string> outside_fault(const std::string& text, OutsideUse use) {
  if (text.size() > kMaxOutsidePath)
    return fmt::format("{} bytes, of which at most {} are taken", text.size(), kMaxOutsidePath);
  const std::size_t control = find_control(text);
  if (control != std::string::npos) return fmt::format("a control character at byte {}", control);
  return use == OutsideUse::kInside ? fault_inside(text) : std::nullopt;
}

std::string outside_path(const std::string& text, OutsideUse use) {
  const std::optional<std::string> fault = outside_fault(text, use);
  if (!fault) return use == OutsideUse::kInside ? fs::path(text).lexically_normal().string() : text;
  // The name itself is shown without what a terminal would obey.
  std::string shown = text.substr(0, kShownName);
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7F; }, '?');
  throw InputError(fmt::format("wanted {}, got '{}' with {}",
                               use == OutsideUse::kInside
                                   ? "the name of a file within the folder, like 'meshes/tip.stl'"
                                   : "a name or the path of a file",
                               shown, *fault));
}

bool may_link(const std::string& folder, const std::string& path) {
  const fs::path fence = fence_around(folder);
  return fence.empty() || is_below(fence, real_path(path));
}

std::string linked_path(const std::string& folder, const std::string& name) {
  std::string path =
      (fs::path(folder) / outside_path(name, OutsideUse::kRead)).lexically_normal().string();
  require(may_link(folder, path), "'{}' leads out of the folder that was dropped", name);
  return path;
}

LinkFence::LinkFence(const std::string& folder) : folder_(real_path(folder).string()) {
  const std::lock_guard<std::mutex> lock(fences().mutex);
  fences().folders.push_back(folder_);
}

LinkFence::~LinkFence() {
  Fences& all = fences();
  const std::lock_guard<std::mutex> lock(all.mutex);
  all.folders.erase(std::find(all.folders.begin(), all.folders.end(), folder_));
}

}  // namespace thenar
