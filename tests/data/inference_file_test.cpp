// Tests for data/io/inference_file.cpp; inference_file_test.py opens what THENAR_INFERENCE_SAMPLE
// leaves with xarray.

#include "data/io/inference_file.h"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/error.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

class InferenceFileTest : public TemporaryFolder {};

/// Two chains of three draws; value of draw d of chain c of parameter p: 100 c + 10 d + p.
InferenceFile example() {
  InferenceFile file;
  file.attributes = {{"seed", "7"},
                     {"inputs", std::string(200000, 'x')},
                     {"note", "µ, two\nlines"},
                     {"nothing", ""}};
  InferenceGroup& posterior = file.groups["posterior"];
  posterior.lengths = {{"chain", 2}, {"draw", 3}, {"parameter", 2}};
  posterior.coordinates["parameter"] = {"axis/CMC1_FE/point", "größe"};
  InferenceArray x{{}, {"chain", "draw", "parameter"}, "mm", "place of an axis", false, false};
  for (int c = 0; c < 2; ++c)
    for (int d = 0; d < 3; ++d)
      for (int p = 0; p < 2; ++p) x.values.push_back(100 * c + 10 * d + p);
  posterior.arrays["x"] = x;
  posterior.arrays["noise"] = {{0.1, 1e-300, -5, 3, 1e300, 2}, {"chain", "draw"}, "N", ""};
  InferenceGroup& stats = file.groups["sample_stats"];
  stats.lengths = {{"chain", 2}, {"draw", 3}};
  stats.arrays["diverging"] = {{0, 1, 0, 0, 0, 1}, {"chain", "draw"}, "1", "", false, true};
  stats.arrays["tree_depth"] = {{1, 2, 3, 4, 5, 1e9}, {"chain", "draw"}, "1", "depth", true, false};
  InferenceGroup& observed = file.groups["observed_data"];
  observed.lengths = {{"trial", 2}, {"none", 0}};
  observed.coordinates["trial"] = {"key pinch", ""};
  observed.arrays["force"] = {{4, std::numeric_limits<double>::quiet_NaN()}, {"trial"}, "N", ""};
  observed.arrays["scale"] = {{0.25}, {}, "1", "of all forces"};
  observed.arrays["empty"] = {{}, {"none"}, "1", ""};
  return file;
}

/// Equal to the bit, NaN to NaN.
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
           return x == y || (x != x && y != y);
         });
}

TEST_F(InferenceFileTest, ReadsBackEveryBit) {
  const InferenceFile file = example();
  write_inference(file, path("a.nc"));
  const InferenceFile back = read_inference(path("a.nc"));
  EXPECT_EQ(back.attributes, file.attributes);
  ASSERT_EQ(back.groups.size(), file.groups.size());
  for (const auto& [name, group] : file.groups) {
    const InferenceGroup& other = back.groups.at(name);
    EXPECT_EQ(other.lengths, group.lengths) << name;
    EXPECT_EQ(other.coordinates, group.coordinates) << name;
    ASSERT_EQ(other.arrays.size(), group.arrays.size()) << name;
    for (const auto& [key, array] : group.arrays) {
      const InferenceArray& found = other.arrays.at(key);
      EXPECT_TRUE(same(found.values, array.values)) << key;
      EXPECT_EQ(found.dimensions, array.dimensions) << key;
      EXPECT_EQ(found.unit, array.unit) << key;
      EXPECT_EQ(found.description, array.description) << key;
      EXPECT_EQ(found.integer, array.integer) << key;
      EXPECT_EQ(found.boolean, array.boolean) << key;
    }
  }
}

// Left for inference_file_test.py, which names the file.
TEST_F(InferenceFileTest, LeavesASampleForOtherPrograms) {
  const char* sample = std::getenv("THENAR_INFERENCE_SAMPLE");
  if (!sample) GTEST_SKIP() << "THENAR_INFERENCE_SAMPLE names no file";
  write_inference(example(), sample);
  EXPECT_TRUE(fs::exists(sample));
}

TEST_F(InferenceFileTest, RefusesArraysThatDoNotFit) {
  const auto refusal = [&](const auto& change) {
    InferenceFile file = example();
    change(file.groups["posterior"]);
    return message_of([&] { write_inference(file, path("a.nc")); });
  };
  EXPECT_EQ(refusal([](InferenceGroup& g) { g.arrays["noise"].values.pop_back(); }),
            "array 'noise' has 5 values, its dimensions 6");
  EXPECT_EQ(refusal([](InferenceGroup& g) { g.lengths.erase("draw"); }),
            "array 'noise': dimension 'draw' has no length");
  EXPECT_EQ(refusal([](InferenceGroup& g) { g.coordinates["parameter"].pop_back(); }),
            "dimension 'parameter' has 1 names, its length is 2");
  EXPECT_EQ(refusal([](InferenceGroup& g) { g.coordinates["muscle"] = {"FPL"}; }),
            "dimension 'muscle' has names, but no length");
  EXPECT_EQ(refusal([](InferenceGroup& g) { g.arrays["draw"] = g.arrays["noise"]; }),
            "array 'draw' is named like a dimension");
  EXPECT_EQ(refusal([](InferenceGroup& g) { g.arrays["noise"].integer = true; }),
            "array 'noise' of integers has a value 0.1");
  EXPECT_EQ(refusal([](InferenceGroup& g) { g.arrays["noise"].boolean = true; }),
            "array 'noise' of bools has a value 0.1");
  EXPECT_EQ(refusal([](InferenceGroup& g) { g.arrays["a/b"] = g.arrays["noise"]; }),
            "netCDF could not add variable a/b: NetCDF: Name contains illegal characters");
  EXPECT_FALSE(fs::exists(path("a.nc")));
  EXPECT_TRUE(fs::is_empty(folder_)) << "no temporary is left";
}

TEST_F(InferenceFileTest, RefusesWhatIsNotOurs) {
  const std::string none = path("a.nc") + ":1: wanted a posterior file (netCDF-4)";
  const auto refusal = [&] {
    return message_of<DataError>([&] { (void)read_inference(path("a.nc")); });
  };
  EXPECT_EQ(refusal(), none);
  std::ofstream(path("a.nc")) << "chain,draw,x\n";
  EXPECT_EQ(refusal(), none);
  H5Fclose(H5Fcreate(path("a.nc").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_EQ(refusal(),
            path("a.nc") + ":1: wanted an inference file of thenar, got another netCDF file");
}

TEST_F(InferenceFileTest, RefusesAFileCutShort) {
  write_inference(example(), path("a.nc"));
  fs::resize_file(path("a.nc"), fs::file_size(path("a.nc")) / 2);
  EXPECT_THROW((void)read_inference(path("a.nc")), DataError);
}

/// Writes more than the disk takes, in a process of its own.
void exit_refused_on_a_full_disk(const std::string& path) {
  (void)std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{16384, 16384};  // [bytes]
  setrlimit(RLIMIT_FSIZE, &limit);
  const std::string message = message_of([&] { write_inference(example(), path); });
  std::exit(message.find("is the disk full?") != std::string::npos ? 0 : 1);
}

TEST_F(InferenceFileTest, KeepsTheOldFileOnAFullDisk) {
  InferenceFile old;
  old.attributes["seed"] = "8";
  write_inference(old, path("a.nc"));
  EXPECT_EXIT(exit_refused_on_a_full_disk(path("a.nc")), testing::ExitedWithCode(0), "");
  EXPECT_EQ(read_inference(path("a.nc")).attributes.at("seed"), "8");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "no temporary is left";
}

TEST_F(InferenceFileTest, RefusesAFolderThatIsAFile) {
  std::ofstream(path("file")) << "no folder";
  EXPECT_THROW(write_inference(example(), path("file/a.nc")), InputError);
}

}  // namespace
}  // namespace thenar
