// Every file in data/ reads, and says what its publication says.

#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "data/io/anthropometry.h"
#include "data/io/experiment.h"
#include "data/io/scaled_hand.h"
#include "data/io/subject.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

const std::string kData = THENAR_DATA_DIR;

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(kData + "/" + folder))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  return paths;
}

TEST(DataFiles, EverySubjectReads) {
  const std::vector<std::string> paths = files_in("subjects");
  EXPECT_GE(paths.size(), 8U);
  std::set<std::string> names;
  for (const std::string& path : paths) {
    const Subject subject = read_subject(path);
    EXPECT_EQ(subject.name, std::filesystem::path(path).stem().string());
    EXPECT_TRUE(names.insert(subject.name).second);
  }
}

TEST(DataFiles, EveryExperimentReads) {
  for (const std::string& path : files_in("experiments")) {
    const Experiment experiment = read_experiment(path);
    EXPECT_EQ(experiment.name, std::filesystem::path(path).stem().string());
    EXPECT_FALSE(experiment.trials.empty());
  }
}

TEST(DataFiles, EveryProportionReads) {
  for (const std::string& path : files_in("anthropometry"))
    EXPECT_FALSE(read_proportions(path).digits.empty());
}

}  // namespace
}  // namespace thenar
