#pragma once

/// What a posterior file keeps as attributes: inputs and settings, to run it again.

#include <map>
#include <string>

#include "base/error.h"
#include "data/io/inference_file.h"
#include "posterior/run/sample_posterior.h"

namespace thenar::internal {

using Attributes = std::map<std::string, std::string>;

inline constexpr const char* kPosteriorFormat = "thenar posterior 1";

void add_inputs(const FitInputs& inputs, Attributes& to);
void add_settings(const PosteriorSettings& settings, Attributes& to);

/// Attributes of a file, asked by name.
class AttributeReader {
 public:
  explicit AttributeReader(const Attributes& attributes) : attributes_(attributes) {}
  [[nodiscard]] const std::string& text(const std::string& name) const {
    const auto found = attributes_.find(name);
    require(found != attributes_.end(), "the attribute '{}' is missing", name);
    return found->second;
  }
  [[nodiscard]] bool has(const std::string& name) const { return attributes_.count(name) > 0; }
  [[nodiscard]] SourceText source(const std::string& key) const {
    return {text(key + "_path"), text(key + "_text")};
  }
  [[nodiscard]] double number(const std::string& name) const {
    return std::stod(text("setting_" + name));
  }
  [[nodiscard]] int integer(const std::string& name) const {
    return static_cast<int>(number(name));
  }

 private:
  const Attributes& attributes_;
};

[[nodiscard]] FitInputs inputs_of(const AttributeReader& given);
[[nodiscard]] PosteriorSettings settings_of(const AttributeReader& given);

}  // namespace thenar::internal

namespace thenar {

// A posterior as ArviZ InferenceData; the layout is in docs/data_format.md.

/// Parameters, statistics of the sampler, pointwise log likelihood, replicated and measured
/// forces, draws from the prior, and everything needed to run it again.
[[nodiscard]] InferenceFile describe_posterior(const PosteriorRun& run);

/// Writes to a temporary file and renames it when complete.
void write_posterior(const PosteriorRun& run, const std::string& path);

/// Rebuilds the posterior from the inputs in the file and takes the draws from it.
/// @throws DataError if the file is not a posterior that thenar wrote.
[[nodiscard]] PosteriorRun read_posterior(const std::string& path);

}  // namespace thenar
