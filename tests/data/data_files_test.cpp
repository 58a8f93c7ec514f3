// Every file in data/ reads, and says what its publication says.

#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "data/io/anthropometry.h"
#include "data/io/experiment.h"
#include "data/io/subject.h"
#include "data/io/toml_node.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

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

/// The TOML examples of docs/data_format.md, in order.
std::vector<std::string> documented_examples() {
  const std::string text = read_text_file(kData + "/../docs/data_format.md");
  const std::string open = "```toml\n", close = "```";
  std::vector<std::string> examples;
  for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at + 1)) {
    const std::size_t begin = at + open.size();
    examples.push_back(text.substr(begin, text.find(close, begin) - begin));
  }
  return examples;
}

TEST(DataFiles, DocumentedExamplesRead) {
  const std::vector<std::string> examples = documented_examples();
  ASSERT_EQ(examples.size(), 2U);
  EXPECT_EQ(parse_subject(examples[0], "subject.toml").name, "my_index");
  EXPECT_EQ(parse_experiment(examples[1], "experiment.toml").trials.size(), 2U);
}

}  // namespace
}  // namespace thenar
