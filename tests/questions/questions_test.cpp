// Every question of the table by its example: C++, SI and printed JSON are the same numbers.

#include <cmath>
#include <filesystem>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "questions/question.h"
#include "questions/request_file.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

/// Endings of keys in SI and printed, and one printed unit in SI.
struct Ending {
  std::string si, printed;
  double size;
};

const std::vector<Ending>& endings() {
  static const std::vector<Ending> kEndings{{"_N_m_per_rad", "_Nm_per_deg", 180 / M_PI},
                                            {"_N_per_rad", "_N_per_deg", 180 / M_PI},
                                            {"_N_m", "_N_mm", 1e-3},
                                            {"_N_m", "_Nm", 1},
                                            {"_m_per_s", "_mm_per_s", 1e-3},
                                            {"_m2", "_mm2", 1e-6},
                                            {"_Pa", "_kPa", 1e3},
                                            {"_rad", "_deg", M_PI / 180},
                                            {"_m", "_mm", 1e-3},
                                            {"_m_per_rad", "_mm_per_rad", 1e-3},
                                            {"_N_per_m", "_N_per_mm", 1e3},
                                            // Keys of earlier versions.
                                            {"_m_per_s", "_m_s", 1},
                                            {"_m_per_s", "_mm_s", 1e-3},
                                            {"_rad_per_s", "_rad_s", 1},
                                            {"_rad_per_s", "_deg_s", M_PI / 180},
                                            {"_N_m", "", 1},
                                            {"_m_per_s", "", 1},
                                            {"_rad_per_s", "", 1},
                                            {"_m", "", 1},
                                            {"_rad", "", 1},
                                            {"_N", "", 1}};
  return kEndings;
}

bool ends(const std::string& text, const std::string& with) {
  return text.size() >= with.size() &&
         text.compare(text.size() - with.size(), with.size(), with) == 0;
}

/// One printed unit in SI, of the two keys of one field; 0 if they are not of one field.
double size_of(const std::string& si, const std::string& printed) {
  if (si == printed) return 1;
  for (const Ending& each : endings())
    if (ends(si, each.si) && ends(printed, each.printed) &&
        si.substr(0, si.size() - each.si.size()) ==
            printed.substr(0, printed.size() - each.printed.size()))
      return each.size;
  return 0;
}

/// A time that a computation took, which is not in replies.
bool is_cpu(const std::string& key) {
  return ends(key, "cpu_s") || key == "seconds" || key == "cpu_s_per_simulated_s";
}

/// A number without a unit beside others that have that of the key around them.
bool is_pure(const std::string& key) { return ends(key, "_ess") || key == "r_hat"; }

/// Compares what is printed with SI, by 4e-16 relative. @return how many numbers have a unit that
/// is printed otherwise
int compare(const OrderedJson& si, const OrderedJson& printed, double size,
            const std::string& where) {
  int scaled = 0;
  if (si.is_number_float()) {
    const double a = si.get<double>(), b = printed.get<double>() * size;
    EXPECT_LE(std::abs(a - b), 4e-16 * std::abs(a)) << where;
    return size != 1 ? 1 : 0;
  }
  EXPECT_EQ(si.type(), printed.type()) << where;
  if (si.is_array()) {
    EXPECT_EQ(si.size(), printed.size()) << where;
    for (std::size_t i = 0; i < std::min(si.size(), printed.size()); ++i)
      scaled += compare(si[i], printed[i], size, where + "." + std::to_string(i));
  } else if (si.is_object()) {
    auto other = printed.begin();
    for (const auto& [key, value] : si.items()) {
      while (other != printed.end() && is_cpu(other.key())) ++other;
      if (other == printed.end()) {
        ADD_FAILURE() << where << "." << key << " is not printed";
        return scaled;
      }
      const double its_size = size_of(key, other.key());
      EXPECT_GT(its_size, 0) << where << ": " << key << " and " << other.key();
      scaled += compare(value, other.value(),
                        its_size != 1  ? its_size
                        : is_pure(key) ? 1
                                       : size,
                        where + "." + key);
      ++other;
    }
  } else {
    EXPECT_EQ(si, printed) << where;
  }
  return scaled;
}

class EveryQuestion : public TemporaryFolder, public testing::WithParamInterface<std::size_t> {
 protected:
  /// In a folder of its own, with the fit that the example of predictions names.
  void SetUp() override {
    std::filesystem::current_path(folder_);
    if (question().name != "predict") return;
    Json fit = Json::parse(question_named("fit").example);
    fit["output"] = "fit.h5";
    (void)question_named("fit").ask(fit, THENAR_DATA_DIR, {});
  }
  void TearDown() override { std::filesystem::current_path(before_); }

  [[nodiscard]] const Question& question() const { return questions()[GetParam()]; }

 private:
  const std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_P(EveryQuestion, PrintsTheNumbersThatItHasInSi) {
  const Answer answer = question().ask(Json::parse(question().example), THENAR_DATA_DIR, {});
  const OrderedJson si = answer.json(UnitSystem::kSi), printed = answer.json(UnitSystem::kPrinted);
  EXPECT_GT(si.size(), 2U);
  (void)compare(si, printed, 1, question().name);
  EXPECT_FALSE(answer.text().empty());
}

TEST_P(EveryQuestion, RecordsARequestThatGivesTheSameBits) {
  const Answer first = question().ask(Json::parse(question().example), THENAR_DATA_DIR, {});
  const RequestFile recorded =
      parse_request(request_text(question().name, first.request), "recorded.toml");
  const Answer again = recorded.ask({});
  EXPECT_EQ(json_text(again.json(UnitSystem::kSi), -1), json_text(first.json(UnitSystem::kSi), -1));
  EXPECT_EQ(again.request, first.request);
}

TEST_P(EveryQuestion, SaysWhatItsParametersAre) {
  for (const Param& param : question().params) {
    EXPECT_FALSE(param.member.description.empty()) << param.member.name;
    EXPECT_EQ(param.member.description.back(), '.') << param.member.name;
  }
}

std::string name_of_case(const testing::TestParamInfo<std::size_t>& info) {
  return questions()[info.param].name;
}

INSTANTIATE_TEST_SUITE_P(Questions, EveryQuestion,
                         testing::Range(static_cast<std::size_t>(0), questions().size()),
                         name_of_case);

}  // namespace
}  // namespace thenar
