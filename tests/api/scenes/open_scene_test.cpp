// Tests for api/scenes/open_scene.cpp: parts by name or by file are the same.

#include "api/scenes/open_scene.h"

#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_io.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

const std::string kData = THENAR_DATA_DIR;

class NamedScene : public TemporaryFolder {
 protected:
  /// Opens a mug and a hand, each given by a name or a path.
  RequestedScene opened(const std::string& mug, const std::string& hand) const {
    write_file(path("s.toml"),
               fmt::format("name = 's'\nsource = 'Scene'\n[sources]\nScene = 'Made up'\n"
                           "[[body]]\nname = 'cup'\nfile = '{}'\nposition_mm = [500, 0, 0]\n"
                           "[[hand]]\nname = 'jaw'\nfile = '{}'\n[stepping]\nduration_s = 0.01\n",
                           mug, hand));
    SceneRequest request;
    request.scene = path("s.toml");
    request.data = kData;
    return open_requested_scene(request);
  }
};

TEST_F(NamedScene, HasTheSamePartsAsByFiles) {
  const std::string mug = kData + "/objects/mug.toml", jaw = kData + "/robots/parallel_jaw.toml";
  const RequestedScene named = opened("mug", "parallel_jaw"), filed = opened(mug, jaw);
  const auto whole = [](const FileDigests& files) {
    FileDigests out;
    for (const auto& [file, digest] : files)
      out[std::filesystem::weakly_canonical(file).string()] = digest;
    return out;
  };
  // All files are recorded: scene, object with its mesh, hand.
  const FileDigests files = whole(named.open.files);
  EXPECT_EQ(files.at(std::filesystem::weakly_canonical(mug).string()),
            digests_of({mug}).begin()->second);
  EXPECT_EQ(files.count(std::filesystem::weakly_canonical(jaw).string()), 1U);
  EXPECT_EQ(files.size(), whole(filed.open.files).size());
  EXPECT_EQ(named.open.built.scene.mechanism.bodies.size(),
            filed.open.built.scene.mechanism.bodies.size());
}

TEST_F(NamedScene, TakesSubjectsByName) {
  const RequestedScene scene = opened("mug", "human_hand");
  EXPECT_GT(scene.open.built.scene.mechanism.bodies.size(), 10U);
  EXPECT_THROW((void)opened("mugg", "human_hand"), DataError);
}

}  // namespace
}  // namespace thenar
