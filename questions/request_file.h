#pragma once

/// Requests as files (TOML): the name of a question and its parameters, units in the keys.
///
///     question = "tip_force"
///     subject = "synek2019_middle"
///     posture_deg = {MCP3_FE = 40, PIP3 = 55}
///     tension_N = {FDP = 10}

#include <map>
#include <string>

#include "questions/question.h"

namespace thenar {

/// A request that was read.
struct RequestFile {
  const Question* question = nullptr;
  Json request;                      // parameters by key
  std::map<std::string, int> lines;  // of each key

  std::string path;
  /// Asks. @throws DataError at the line of a parameter that is wrong, and as Question::ask
  [[nodiscard]] Answer ask(const Progress& progress) const;
};

/// Reads a request. @throws DataError at the line of what is wrong
[[nodiscard]] RequestFile read_request(const std::string& path);
[[nodiscard]] RequestFile parse_request(const std::string& text, const std::string& path);

/// A request as text that read_request() reads back to the bit.
[[nodiscard]] std::string request_text(const std::string& question, const OrderedJson& request);

/// A request of a question to fill in: every parameter with what it is, its unit and usual value.
[[nodiscard]] std::string request_template(const Question& question);

}  // namespace thenar
