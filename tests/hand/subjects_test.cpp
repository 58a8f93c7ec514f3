// Every subject in data/: both machines agree, the laws of hands hold, masses are possible.

#include <filesystem>

#include <gtest/gtest.h>

#include "hand/skeleton_hand.h"
#include "tests/hand/hand_laws.h"
#include "tests/hand/same_machines.h"

namespace thenar {
namespace {

std::vector<std::string> subject_files() {
  std::vector<std::string> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(THENAR_DATA_DIR) / "subjects"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

class EverySubject : public testing::TestWithParam<std::string> {};

TEST_P(EverySubject, IsTheSameOnBothMachines) {
  expect_same_machines(build_skeleton(read_subject(GetParam())));
}

TEST_P(EverySubject, IsTheSameOnBothMachinesDigitByDigit) {
  const Subject subject = read_subject(GetParam());
  for (const Digit& digit : subject.digits) {
    SkeletonOptions options;
    options.digits = {digit.name};
    expect_same_machines(build_skeleton(subject, options));
  }
}

TEST_P(EverySubject, ObeysTheLawsOfHands) {
  const Skeleton skeleton = build_skeleton(read_subject(GetParam()));
  const Eigen::VectorXd limit = Eigen::VectorXd::Ones(skeleton.coordinates());  // [N m]
  expect_hand_laws(SkeletonHand(skeleton, {-limit, limit}), 91);
}

INSTANTIATE_TEST_SUITE_P(Data, EverySubject, testing::ValuesIn(subject_files()),
                         [](const testing::TestParamInfo<std::string>& file) {
                           std::string name = std::filesystem::path(file.param).stem().string();
                           for (char& c : name)
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           return name;
                         });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(EverySubject);

}  // namespace
}  // namespace thenar
