#include "data/io/mesh/foreign_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

#include <unistd.h>

#include "base/error.h"
#include "data/io/file_guard.h"
#include "data/io/mesh/bounded_process.h"
#include "data/io/mesh/reader_answer.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;
constexpr const char* kReaderProgram = "thenar-mesh-reader";
constexpr double kNoTime = 0.05;          // A reader is not started with less time left [s]
constexpr double kTimePerMegabyte = 0.2;  // Processor time added for each megabyte [s]
// A reader that takes less processor time only waits for other processes [s]
constexpr double kMinBusyTime = 0.5;

/// Places where the program may be, best first.
std::vector<fs::path> reader_places() {
  // An explicit choice is the only one.
  const char* const named = std::getenv("THENAR_MESH_READER");
  if (named != nullptr && *named != '\0') return {named};
  std::vector<fs::path> places;
  // Beside this program, where it was built or installed, on the PATH.
  std::error_code unknown;
  const fs::path self = fs::read_symlink("/proc/self/exe", unknown);
  if (!unknown) places.push_back(self.parent_path() / kReaderProgram);
  places.push_back(fs::path(THENAR_READER_BUILT) / kReaderProgram);
  places.push_back(fs::path(THENAR_READER_INSTALLED) / kReaderProgram);
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (fs::path(folder).is_absolute()) places.push_back(fs::path(folder) / kReaderProgram);
  return places;
}

/// Reads the words of a VRML or Inventor scene, without texts and comments.
class SceneWords {
 public:
  SceneWords(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  /// The next word, or one of the signs {}[]; empty at the end of the text.
  std::string_view next() {
    // Characters that are words by themselves, and those that separate words
    constexpr std::string_view kBracketSigns = "{}[]", kWordSeparators = " \t\r\n,";
    while (at_ < text_.size()) {
      const char c = text_[at_];
      // Skip comments, texts and white space.
      if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (c == '"') {
        skip_text();
      } else if (kWordSeparators.find(c) != std::string_view::npos) {
        line_ += c == '\n' ? 1 : 0;
        ++at_;
      } else {
        // A sign, or a word up to the next separator.
        const std::size_t begin = at_++;
        if (kBracketSigns.find(c) == std::string_view::npos)
          while (at_ < text_.size() && kBracketSigns.find(text_[at_]) == std::string_view::npos &&
                 kWordSeparators.find(text_[at_]) == std::string_view::npos && text_[at_] != '"')
            ++at_;
        return text_.substr(begin, at_ - begin);
      }
    }
    return {};
  }

  [[noreturn]] void fail(const std::string& what) const { throw DataError(path_, line_, what); }

 private:
  void skip_text() {
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
      line_ += at_ < text_.size() && text_[at_] == '\n' ? 1 : 0;
    }
    at_ = std::min(at_ + 1, text_.size());
  }

  std::string_view text_;
  const std::string& path_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// Returns whether a node stands for another file.
bool includes_file(std::string_view node) {
  constexpr std::array<std::string_view, 5> kIncluding{"File", "SoFile", "Inline", "WWWInline",
                                                       "VRMLInline"};
  return std::find(kIncluding.begin(), kIncluding.end(), node) != kIncluding.end();
}

void refuse_inclusion(std::string_view text, const std::string& path) {
  SceneWords words(text, path);
  // A node is a name followed by a brace.
  std::string_view before = words.next();
  for (std::string_view word; !before.empty(); before = word) {
    word = words.next();
    if ((word == "{" && includes_file(before)) || before == "EXTERNPROTO")
      words.fail(
          fmt::format("<{}> puts another file in its place, which is not read: write the "
                      "scene into one file, or turn it into an OBJ",
                      before));
  }
}

/// The JSON chunk of a GLB, behind its header; empty if it is malformed.
std::string_view json_of_glb(std::string_view bytes) {
  // Bytes of the header of a GLB file and of its first chunk [bytes]
  constexpr std::size_t kGlbHeadSize = 20;
  if (bytes.size() < kGlbHeadSize || bytes.substr(0, 4) != "glTF") return {};
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 12, sizeof(size));
  return bytes.substr(kGlbHeadSize, size);
}

/// Checks a file against its limits before the program sees it.
void guard(const std::string& path, MeshFormat format) {
  if (format == MeshFormat::kCollada) {
    (void)read_guarded(path, GuardedKind::kCollada);
  } else if (format == MeshFormat::kGltf) {
    const std::string text = read_guarded(path, GuardedKind::kMesh);
    const bool bytes = text.compare(0, 4, "glTF") == 0;
    guard_text(bytes ? json_of_glb(text) : text, path, GuardedKind::kJson);
  } else {
    refuse_inclusion(read_guarded(path, GuardedKind::kScene), path);
  }
}

}  // namespace

std::string find_mesh_reader() {
  for (const fs::path& place : reader_places())
    if (access(place.c_str(), X_OK) == 0) return place.string();
  return "";
}

TriangleSoup read_foreign_mesh(const std::string& path, MeshFormat format, MeshTime& left) {
  const MeshReaderLimits limits;
  // Limits of size and nesting first.
  guard(path, format);
  // Time that earlier meshes of the file have left.
  if (left.processor <= kNoTime || left.clock <= kNoTime)
    throw DataError(path, 1,
                    "is not read: the meshes before it took all the time that those of one file "
                    "may take");
  const std::string program = find_mesh_reader();
  if (program.empty())
    throw DataError(path, 1,
                    fmt::format("glTF, Collada, VRML and Inventor are read by the program {}, "
                                "which is not there: install it beside the command, or name it "
                                "with THENAR_MESH_READER",
                                kReaderProgram));
  // Large files may take longer.
  left.processor += kTimePerMegabyte * static_cast<double>(fs::file_size(path)) / 1e6;
  const double seconds = std::min<double>(limits.processor_seconds, std::ceil(left.processor));
  const ProcessEnd end = run_bounded({program, path, fmt::format("{:.0f}", seconds)},
                                     std::min(limits.clock_seconds, left.clock),
                                     kMaxTriangles * 36 + kMaxExact * 128 + 1000);
  // Charge the time; waiting for a busy machine is free.
  left.processor -= end.processor;
  if (end.too_long || end.processor > kMinBusyTime) left.clock -= end.clock;
  // An answer says more than the way the program ended, which may be a crash after it.
  const std::string failure = end.failure();
  if (!failure.empty())
    throw DataError(path, 1,
                    fmt::format("cannot be read: the program that reads it {}; it may take {} s "
                                "of the processor and {} MB",
                                failure, seconds, limits.memory >> 20));
  return parse_answer(end.output, path);
}

}  // namespace thenar
