#pragma once

/// Posterior files: ArviZ InferenceData with inputs and settings of the run as attributes.

#include <map>
#include <string>

#include "base/error.h"
#include "data/io/inference_file.h"
#include "posterior/run/sample_posterior.h"

namespace thenar::internal {

/// Attributes of a file by name.
using Attributes = std::map<std::string, std::string>;

inline constexpr const char* kPosteriorFormat =
    "thenar posterior 1";  // value of the format attribute

// Append inputs, settings and the record of the run.
void add_inputs(const FitInputs& inputs, Attributes& to);
void add_settings(const PosteriorSettings& settings, Attributes& to);
void add_record(const RunRecord& run, Attributes& to);

/// Reads attributes by name; keeps a reference to `attributes`, which must outlive it.
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

 private:
  const Attributes& attributes_;
};

[[nodiscard]] FitInputs inputs_of(const AttributeReader& given);
[[nodiscard]] PosteriorSettings settings_of(const AttributeReader& given);
[[nodiscard]] RunRecord record_of(const AttributeReader& given);  // empty in older files

}  // namespace thenar::internal

namespace thenar {

/// Describes a posterior file: parameters, sampler statistics, pointwise log likelihood, replicated
/// and measured forces, prior draws, and all inputs needed to repeat the run. Layout:
/// docs/data_format.md.
[[nodiscard]] InferenceFile describe_posterior(const PosteriorRun& run);

/// Writes to a temporary file and renames it when complete.
void write_posterior(const PosteriorRun& run, const std::string& path);

/// Reads draws from the file and rebuilds the posterior from the inputs in it.
/// @throws DataError if the file is not a posterior that thenar wrote.
[[nodiscard]] PosteriorRun read_posterior(const std::string& path);

}  // namespace thenar
