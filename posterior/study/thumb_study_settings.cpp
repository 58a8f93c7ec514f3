#include <initializer_list>

#include <fmt/format.h>

#include "data/io/toml_node.h"
#include "posterior/study/thumb_study.h"

namespace thenar {
namespace {

constexpr bool kBothModels[] = {false, true};

/// Both models at some noises, 2 postures.
void add_noises(Arms arms, std::initializer_list<double> noises, double skewness,
                std::vector<ThumbFitSettings>& fits) {
  for (const double noise : noises)
    for (const bool skewed : kBothModels) fits.push_back({skewed, arms, noise, 2, skewness, false});
}

/// 1, 3 and 4 postures at 10 %; 2 are among the noises.
void add_postures(bool skewed, Arms arms, std::vector<ThumbFitSettings>& fits) {
  for (const int postures : {1, 3, 4}) fits.push_back({skewed, arms, 0.1, postures, 1, false});
}

}  // namespace

ThumbStudyInputs thumb_study_inputs(const std::string& data) {
  const auto read = [&](const char* file) {
    const std::string path = data + "/" + file;
    return SourceText{path, read_text_file(path)};
  };
  return {read("subjects/arms_five_axis_thumb.toml"),
          read("subjects/mechanical_five_axis_thumb.toml"), read("fits/five_axis_orthogonal.toml"),
          read("fits/five_axis_skewed.toml")};
}

ThumbStudySettings full_thumb_study() {
  ThumbStudySettings settings;
  add_noises(Arms::kFixed, {0.01, 0.05, 0.1, 0.2}, 1, settings.fits);
  add_noises(Arms::kFixed, {0.05, 0.1, 0.2}, 2, settings.fits);
  for (const bool skewed : kBothModels) {
    add_postures(skewed, Arms::kFixed, settings.fits);
    settings.fits.push_back({skewed, Arms::kFixed, 0.1, 2, 1, true});
  }
  add_noises(Arms::kFree, {0.05, 0.1, 0.2}, 1, settings.fits);
  // Where anatomy hardly helps, there may be several modes.
  for (const int postures : {1, 2, 4})
    for (const bool skewed : kBothModels)
      settings.fits.push_back({skewed, Arms::kFixed, 0.05, postures, 1, false, 3});
  return settings;
}

ThumbStudySettings quick_thumb_study() {
  ThumbStudySettings settings;
  add_noises(Arms::kFixed, {0.05, 0.1, 0.2}, 1, settings.fits);
  add_postures(true, Arms::kFixed, settings.fits);
  settings.draws = 500;
  settings.warm_up = 500;
  settings.mode_starts = 8;
  settings.retries = 1;
  return settings;
}

std::string describe_fit(const ThumbFitSettings& settings) {
  return fmt::format(
      "{}, arms {}, {:.0f} % noise, {} {}{}{}", settings.skewed ? "skewed" : "orthogonal",
      settings.arms == Arms::kFixed ? "known" : "free", 100 * settings.noise, settings.postures,
      settings.postures == 1 ? "posture" : "postures", settings.with_tasks ? ", with tasks" : "",
      settings.prior_width == 1 ? "" : fmt::format(", {} x prior", settings.prior_width));
}

}  // namespace thenar
