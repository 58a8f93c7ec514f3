#include "live/world/imported_files.h"

#include <filesystem>
#include <iterator>

namespace thenar {

namespace fs = std::filesystem;

std::string imported_hand_file(const LiveWorld& live, const PlacedHand& hand) {
  if (hand.file.empty()) return "";
  const fs::path file = fs::path(live.state().header->folder) / hand.file;
  return live.path_in_own_folder(fs::absolute(file).lexically_normal().string());
}

std::vector<std::string> imported_folders(const LiveWorld& live) {
  std::vector<std::string> folders;
  for (const PlacedHand& hand : live.state().placed) {
    const fs::path inside = imported_hand_file(live, hand);
    if (inside.empty()) continue;
    // Go up as many levels as the file has below its folder: FOLDER/3/a/robot.urdf is in FOLDER/3.
    fs::path folder =
        fs::absolute(fs::path(live.state().header->folder) / hand.file).lexically_normal();
    for (auto part = std::next(inside.begin()); part != inside.end(); ++part)
      folder = folder.parent_path();
    folders.push_back(folder.string());
  }
  return folders;
}

std::string file_seen_from(const std::string& folder, const std::string& file) {
  return fs::proximate(fs::absolute(file).lexically_normal(),
                       fs::absolute(folder.empty() ? "." : folder).lexically_normal())
      .generic_string();
}

}  // namespace thenar
