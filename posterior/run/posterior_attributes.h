#pragma once

/// What a posterior file keeps as attributes: inputs and settings, to run it again.

#include <map>
#include <string>

#include "base/error.h"
#include "posterior/run/sample_posterior.h"

namespace thenar::internal {

using Attributes = std::map<std::string, std::string>;

inline constexpr const char* kPosteriorFormat = "thenar posterior 1";

void add_inputs(const FitInputs& inputs, Attributes& to);
void add_settings(const PosteriorSettings& settings, Attributes& to);

/// Attributes of a file, asked by name.
class Given {
 public:
  explicit Given(const Attributes& attributes) : attributes_(attributes) {}
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

[[nodiscard]] FitInputs inputs_of(const Given& given);
[[nodiscard]] PosteriorSettings settings_of(const Given& given);

}  // namespace thenar::internal
