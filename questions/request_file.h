#pragma once

/// Request files (TOML): the name of a question and its parameters, with units in the keys.
///
///     question = "tip_force"
///     subject = "synek2019_middle"
///     posture_deg = {MCP3_FE = 40, PIP3 = 55}
///     tension_N = {FDP = 10}

#include <map>
#include <string>

#include "questions/question.h"

namespace thenar {

/// Content of a request file.
struct RequestFile {
  const Question* question = nullptr;
  Json request;                      // parameters by key
  std::map<std::string, int> lines;  // line of each key

  std::string path;
  /// Asks the question. @throws DataError with the line of an invalid parameter, and as
  /// Question::ask
  [[nodiscard]] Answer ask(const Progress& progress) const;
};

/// Reads a request file. @throws DataError with the line of the first error
[[nodiscard]] RequestFile read_request(const std::string& path);
[[nodiscard]] RequestFile parse_request(const std::string& text, const std::string& path);

/// Writes a request as text; read_request() restores all numbers exactly.
[[nodiscard]] std::string request_text(const std::string& question, const OrderedJson& request);

/// Writes a template of a request: every parameter with its description, unit and default value.
[[nodiscard]] std::string request_template(const Question& question);

}  // namespace thenar
