// Tests for api/named/recorded_run.cpp.

#include "api/named/recorded_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/file_io.h"
#include "base/provenance.h"
#include "data/io/inference_file.h"
#include "data/io/result_file.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

class Recorded : public TemporaryFolder {
 protected:
  std::string written(const std::string& name, const std::string& text) {
    write_file(path(name), text);
    return path(name);
  }
  /// Provenance of `thenar pose 'my hand.toml'` in the folder, with the hash of a text.
  [[nodiscard]] std::string provenance(const std::string& hand) const {
    return fmt::format(
        R"({{"provenance": {{"command": "thenar pose 'my hand.toml'", "folder": "{}",
             "date": "2026-01-31T12:00:00Z", "commit": "", "my hand.toml": "sha256 {}"}}}})",
        path(""), sha256(hand));
  }
};

TEST_F(Recorded, IsReadFromPagesAndJson) {
  (void)written("my hand.toml", "a");
  const std::string page =
      written("a.html", R"(<script type="application/json" id="thenar-report">)" + provenance("a") +
                            "</script><script>code</script>");
  for (const std::string& file : {page, written("a.json", provenance("a"))}) {
    const RecordedRun found = read_recorded_run(file);
    EXPECT_EQ(found.run.arguments, (std::vector<std::string>{"pose", "my hand.toml"}));
    EXPECT_EQ(found.run.date, "2026-01-31T12:00:00Z");
    EXPECT_EQ(found.inputs.size(), 1U);
    EXPECT_TRUE(found.warnings.empty());
    EXPECT_EQ(found.compared, 1);
    EXPECT_EQ(found.changed, 0);
    EXPECT_NO_THROW(require_repeatable(found, {"pose"}));
  }
}

TEST_F(Recorded, NamesInputsThatHaveChanged) {
  (void)written("my hand.toml", "b");
  const RecordedRun found = read_recorded_run(written("a.json", provenance("a")));
  EXPECT_EQ(found.warnings, std::vector<std::string>{"input 'my hand.toml' has changed since"});
  EXPECT_EQ(found.changed, 1);
}

// Nets are part of the program, also those of runs that named their files alone; paths are files.
TEST_F(Recorded, MissesNoBuiltInNet) {
  std::string nets = provenance("a");
  nets.insert(nets.find("\"my hand"),
              R"("built-in winslow.toml": "sha256 0", )"
              R"("chao_an.toml": "sha256 0", "n/winslow.toml": "sha256 0", )");
  (void)written("my hand.toml", "a");
  const RecordedRun found = read_recorded_run(written("a.json", nets));
  EXPECT_EQ(found.warnings, std::vector<std::string>{"input 'n/winslow.toml' is gone"});
  EXPECT_EQ(found.compared, 2);
}

TEST_F(Recorded, IsReadFromBinaryResults) {
  ResultFile fit;
  fit.add("fit/z", Eigen::VectorXd::Zero(2), "1", {"coordinate"});
  fit.add("inputs/subject/path", "hand.toml");
  fit.add("inputs/subject/text", "a");
  for (const char* key : {"folder", "date", "commit"})
    fit.add(std::string("provenance/") + key, path(""));
  fit.add("provenance/command", "thenar fit hand.toml");
  write_result(fit, path("fit.h5"));
  EXPECT_EQ(read_recorded_run(path("fit.h5")).run.arguments.front(), "fit");
  EXPECT_EQ(read_recorded_run(path("fit.h5")).inputs.at("hand.toml"), sha256("a"));

  InferenceFile posterior;
  posterior.groups["posterior"].arrays["x"] = {{1}, {}, "1", "", false, false};
  posterior.attributes = {{"run_command", "thenar fit hand.toml"}, {"run_folder", path("")}};
  write_inference(posterior, path("P.nc"));
  EXPECT_EQ(read_recorded_run(path("P.nc")).run.arguments.back(), "hand.toml");
}

TEST_F(Recorded, RanOnStraightPathsBeforeTheyWrapped) {
  RecordedRun run;
  for (const char* version : {"", "0.1.0"}) {
    run.version = version;
    EXPECT_TRUE(ran_on_straight_paths(run)) << version;
  }
  for (const char* version : {"0.2.0", "0.10.1", "1.0.0"}) {
    run.version = version;
    EXPECT_FALSE(ran_on_straight_paths(run)) << version;
  }
}

TEST_F(Recorded, KnowsTheVersionOfEveryKindOfFile) {
  EXPECT_EQ(read_recorded_run(written("old.json", provenance("a"))).version, "");
  std::string versioned = provenance("a");
  versioned.insert(versioned.find("\"date\""), "\"thenar\": \"0.2.0\", ");
  EXPECT_EQ(read_recorded_run(written("new.json", versioned)).version, "0.2.0");
  ResultFile motion;
  motion.add("fit/z", Eigen::VectorXd::Zero(2), "1", {"coordinate"});
  motion.add("provenance/command", "thenar fit hand.toml");
  motion.add("provenance/folder", path(""));
  motion.add("provenance/versions/thenar", "0.1.0");
  write_result(motion, path("fit.h5"));
  EXPECT_EQ(read_recorded_run(path("fit.h5")).version, "0.1.0");
  InferenceFile posterior;
  posterior.groups["posterior"].arrays["x"] = {{1}, {}, "1", "", false, false};
  posterior.attributes = {{"run_command", "thenar fit hand.toml"},
                          {"run_folder", path("")},
                          {"version_thenar", "0.2.1"}};
  write_inference(posterior, path("P.nc"));
  EXPECT_EQ(read_recorded_run(path("P.nc")).version, "0.2.1");
}

TEST_F(Recorded, RefusesWhatIsNoCommand) {
  EXPECT_NE(message_of([&] {
              (void)read_recorded_run(written("b.json", "{}"));
            }).find("records no command"),
            std::string::npos);
  RecordedRun other;
  other.file = "a.json";
  other.run = {{"rerun", "a.json"}, path(""), "", ""};
  const auto words = [&] { require_repeatable(other, {"pose", "rerun"}); };
  EXPECT_EQ(message_of(words),
            "'a.json' records 'thenar rerun a.json', which is not a command to run again");
  const auto of_servers = [&] { require_repeatable(other, {"pose", "view", "serve"}); };
  for (const char* name : {"--version", "view", "serve"}) {
    other.run.arguments = {name, "--port", "0"};
    EXPECT_THROW(of_servers(), InputError) << name;
  }
  other.run = {{"pose"}, "/nowhere/at/all", "", ""};
  EXPECT_THROW(words(), InputError);
}

}  // namespace
}  // namespace thenar
