// Tests for api/named/files.cpp.

#include "api/named/files.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "base/file_io.h"
#include "data/io/inference_file.h"
#include "data/io/result_file.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

const std::string kFolder = testing::TempDir() + "thenar_files/";

std::string written(const std::string& name, const std::string& text) {
  write_file(kFolder + name, text);
  return kFolder + name;
}

/// A result with one array. @param key  that tells its kind
std::string result_with(const std::string& name, const std::string& key) {
  ResultFile file;
  file.add(key, Eigen::VectorXd::Zero(2), "1", {"coordinate"});
  file.add("excursion", 0, "m");
  std::filesystem::create_directories(kFolder);
  write_result(file, kFolder + name);
  return kFolder + name;
}

std::string kind(const std::string& path) { return contents_of(path).kind; }

TEST(ContentsOf, KnowsWhatComesWithThenar) {
  EXPECT_EQ(kind(kData + "/subjects/an_chao_index.toml"), "subject");
  EXPECT_EQ(kind(kData + "/experiments/synek2019_H01.toml"), "experiment");
  EXPECT_EQ(kind(kData + "/nets/winslow.toml"), "net");
  EXPECT_EQ(kind(kData + "/robots/barrett.toml"), "robot");
  EXPECT_EQ(kind(kData + "/objects/mug.toml"), "object");
  EXPECT_EQ(kind(kData + "/objects/mug.obj"), "mesh");
  EXPECT_EQ(kind(kData + "/worlds/jaw_box.toml"), "world");
  EXPECT_EQ(kind(kData + "/contacts/two_soft_fingers.json"), "contacts");
  EXPECT_EQ(kind(kData), "folder");
}

TEST(ContentsOf, TellsBinaryResultsByWhatTheyHold) {
  EXPECT_EQ(kind(result_with("fit.h5", "fit/z")), "fit");
  EXPECT_EQ(kind(result_with("motion.h5", "excitation")), "motion");
  EXPECT_EQ(kind(result_with("other.h5", "numbers")), "");
  InferenceFile posterior;
  posterior.groups["posterior"].arrays["x"] = {{1}, {}, "1", "", false, false};
  write_inference(posterior, kFolder + "P.nc");
  EXPECT_EQ(kind(kFolder + "P.nc"), "posterior");
}

TEST(ContentsOf, TellsTextsByTheirContent) {
  EXPECT_EQ(kind(written("a.urdf", "<robot name='a'><link name='b'/></robot>")), "robot");
  EXPECT_EQ(contents_of(kFolder + "a.urdf").format, "URDF");
  EXPECT_EQ(kind(written("body.xml", "<root><geometryFile>b.off</geometryFile></root>")), "object");
  EXPECT_EQ(kind(written("a.html", "<script id=\"thenar-report\">{}</script>")), "page");
  EXPECT_EQ(kind(written("a.json", "{\"provenance\": {}}")), "answer");
  EXPECT_EQ(kind(written("notes.txt", "milk, eggs")), "");
}

TEST(ContentsOf, NamesTheFileThatWasMeant) {
  written("fit1.csv", "a");
  EXPECT_EQ(message_of([] { (void)contents_of(kFolder + "fir1.csv"); }),
            "there is no file '" + kFolder + "fir1.csv', did you mean 'fit1.csv'?");
  // An ending in common is no likeness.
  EXPECT_EQ(message_of([] { (void)contents_of(kFolder + "wxyz.csv"); }),
            "there is no file '" + kFolder + "wxyz.csv'");
}

TEST(RequireKind, NamesAnotherKind) {
  const std::string path = result_with("fit 2.h5", "fit/z");
  EXPECT_NO_THROW(require_kind(path, {"fit"}));
  EXPECT_EQ(message_of([&] { require_kind(path, {"posterior"}); }),
            "'" + path + "' is a fit, wanted a posterior");
  // Advice is for parts of a world alone.
  EXPECT_EQ(message_of([&] { require_kind(path, {"world"}, "put it into a world"); }),
            "'" + path + "' is a fit, wanted a world");
  const std::string mug = kData + "/objects/mug.toml";
  EXPECT_EQ(message_of([&] { require_kind(mug, {"world"}, "put it into a world"); }),
            "'" + mug + "' is an object, wanted a world; put it into a world");
}

}  // namespace
}  // namespace thenar
