// Tests for data/io/result_file.cpp.

#include "data/io/result_file.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <sys/resource.h>

#include "base/error.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

class ResultFileTest : public TemporaryFolder {};

ResultFile example_result() {
  ResultFile file;
  Eigen::MatrixXd matrix(2, 3);
  matrix << 1, 2, 3, 0.1, -1e-300, 5;
  file.add("group/matrix", matrix, "N", {"trial", "component"});
  file.add("group/vector", Eigen::Vector3d(1, 2, 3), "m", {"joint"});
  file.add("number", 1.0 / 3, "1");
  file.add("text", std::string("two\nlines, µ"));
  file.add("list", std::vector<std::string>{"a", "", "c"});
  file.add("empty", std::vector<std::string>{});
  return file;
}

std::string refusal(const std::string& path) {
  try {
    (void)read_result(path);
  } catch (const DataError& e) {
    return e.what();
  }
  return "";
}

TEST_F(ResultFileTest, ReadsBackEveryBit) {
  const ResultFile file = example_result();
  write_result(file, path("a.h5"));
  const ResultFile back = read_result(path("a.h5"));
  EXPECT_EQ(back.matrix("group/matrix"), file.matrix("group/matrix"));
  EXPECT_EQ(back.matrix("group/vector"), file.matrix("group/vector"));
  EXPECT_EQ(back.arrays.at("group/matrix").unit, "N");
  EXPECT_EQ(back.number("number"), 1.0 / 3);
  EXPECT_EQ(back.text("text"), "two\nlines, µ");
  EXPECT_EQ(back.list("list"), file.list("list"));
  EXPECT_TRUE(back.list("empty").empty());
  EXPECT_EQ(back.arrays.size(), file.arrays.size());
  EXPECT_EQ(back.texts.size(), file.texts.size());
}

TEST_F(ResultFileTest, LabelsDimensions) {
  write_result(example_result(), path("a.h5"));
  const hid_t h5 = H5Fopen(path("a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t dataset = H5Dopen2(h5, "group/matrix", H5P_DEFAULT);
  EXPECT_EQ(H5DSget_num_scales(dataset, 0), 1);
  EXPECT_EQ(H5DSget_num_scales(dataset, 1), 1);
  EXPECT_GT(H5LTpath_valid(h5, "group/trial", 1), 0);
  H5Dclose(dataset);
  H5Fclose(h5);
}

TEST_F(ResultFileTest, RefusesForeignFiles) {
  EXPECT_EQ(refusal(path("none.h5")),
            path("none.h5") + ":1: wanted an HDF5 result file that thenar wrote");
  std::ofstream(path("text.h5")) << "not HDF5";
  EXPECT_EQ(refusal(path("text.h5")),
            path("text.h5") + ":1: wanted an HDF5 result file that thenar wrote");
  H5Fclose(H5Fcreate(path("other.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_EQ(refusal(path("other.h5")),
            path("other.h5") + ":1: wanted a result file of thenar, got another HDF5 file");
}

TEST_F(ResultFileTest, LeavesNothingHalfWritten) {
  std::ofstream(path("file")) << "in the way";
  EXPECT_THROW(write_result(example_result(), path("file/a.h5")), InputError);
  ResultFile clash = example_result();
  clash.add("number/below", 1, "1");  // a group where a number already stands
  EXPECT_THROW(write_result(clash, path("clash.h5")), InputError);
  fs::create_directories(folder_ / "folder" / "inside");
  EXPECT_THROW(write_result(example_result(), path("folder")), InputError);
  for (const auto& entry : fs::directory_iterator(folder_))
    EXPECT_TRUE(entry.path().filename() == "file" || entry.path().filename() == "folder")
        << entry.path();
}

TEST_F(ResultFileTest, KeepsTheOldFileWhereTheNewOneFails) {
  write_result(example_result(), path("a.h5"));
  ResultFile clash = example_result();
  clash.add("number/below", 1, "1");
  EXPECT_THROW(write_result(clash, path("a.h5")), InputError);
  EXPECT_EQ(read_result(path("a.h5")).number("number"), 1.0 / 3);
}

/// Ends the process: 0 if the file is refused where none may exceed 4096 bytes. HDF5 tidies up at
/// exit, which must work, too.
[[noreturn]] void exit_refused_on_a_full_disk(const ResultFile& file, const std::string& path) {
  (void)std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{4096, 4096};
  (void)setrlimit(RLIMIT_FSIZE, &limit);
  try {
    write_result(file, path);
  } catch (const InputError&) {
    std::exit(0);
  }
  std::exit(1);
}

TEST_F(ResultFileTest, KeepsTheOldFileOnAFullDisk) {
  write_result(example_result(), path("a.h5"));
  ResultFile large = example_result();
  large.add("large", Eigen::MatrixXd::Ones(100, 100), "1", {"row", "column"});  // 80 kB
  EXPECT_EXIT(exit_refused_on_a_full_disk(large, path("a.h5")), testing::ExitedWithCode(0), "");
  EXPECT_EQ(read_result(path("a.h5")).number("number"), 1.0 / 3);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "no temporary is left";
}

// HDF5 would note when every array was made, to the second.
TEST_F(ResultFileTest, IsTheSameBytesASecondLater) {
  write_result(example_result(), path("a.h5"));
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  write_result(example_result(), path("b.h5"));
  const auto bytes = [&](const char* name) {
    std::ifstream file(path(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_EQ(bytes("a.h5"), bytes("b.h5"));
}

TEST(ResultFileAccess, NamesWhatIsMissing) {
  const ResultFile file = example_result();
  const auto message = [](const auto& ask) -> std::string {
    try {
      (void)ask();
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message([&] { return file.number("nothing"); }), "result file has no array 'nothing'");
  EXPECT_EQ(message([&] { return file.text("nothing"); }), "result file has no text 'nothing'");
  EXPECT_EQ(message([&] { return file.number("group/vector"); }),
            "result 'group/vector' is not a single number");
  EXPECT_EQ(message([&] { return file.text("list"); }), "result 'list' is not a single text");
}

}  // namespace
}  // namespace thenar
