#pragma once

/// Numbers of options that have a least value.

#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace thenar {

/// "--approaches: wanted a whole number of at least 1, got 0".
[[nodiscard]] inline CLI::Validator at_least(long least) {
  const auto complaint = [least](const std::string& text) -> std::string {
    long value = 0;
    if (CLI::detail::lexical_cast(text, value) && value >= least) return "";
    return fmt::format("wanted a whole number of at least {}, got {}", least, text);
  };
  return {complaint, fmt::format("at least {}", least)};
}

}  // namespace thenar
