#include "apps/tendon_question.h"

#include <fmt/format.h>

#include "apps/options.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "report/words.h"

namespace thenar {
void add_options(CLI::App& command, TendonQuestion& question) {
  add_tendon_options(command, question.digit, "net");
  command.add_option("--tension", question.tension, "MUSCLE=newton ...; others are slack")
      ->required();
}

TendonCase find_tendons(const TendonQuestion& question) {
  const std::map<std::string, double> tension =
      parse_named_numbers(question.tension, "MUSCLE=newton");
  const DigitCase digit = build_digit(question.digit, Hood::kFloatingNet);
  require(digit.map.empty(), "digit '{}' of '{}' has no bones, only tip map '{}': ask tip-force",
          digit.digit, digit.subject.name, digit.map);
  print_warnings(digit.warnings);
  return {digit.subject.name,       digit.digit,  digit.tendons, digit.net, digit.grid,
          tensions(digit, tension), digit.sources};
}

std::string angles_in_words(const TendonCase& at, const Eigen::VectorXd& q) {
  return angles_in_words(at.bones().names.coordinates, at.grid.varied, q);
}

OrderedJson json_header(const TendonCase& at) {
  OrderedJson json{
      {"subject", at.subject}, {"digit", at.digit}, {"fidelity", describe(at.bones().fidelity)}};
  if (at.net != nullptr) json["net"] = at.net->net().net.name;
  json["tension_N"] = to_json(at.bones().names.muscles, at.t);
  return json;
}

std::string text_header(const TendonCase& at) {
  std::string pulled;
  for (Eigen::Index i = 0; i < at.t.size(); ++i)
    if (at.t[i] > 0)
      pulled +=
          fmt::format(" {}={:.4g}", at.bones().names.muscles[static_cast<std::size_t>(i)], at.t[i]);
  return fmt::format("{} of {}{} N\nmodel: {}{}\n", at.digit, at.subject,
                     pulled.empty() ? " at 0" : " under" + pulled, describe(at.bones().fidelity),
                     at.net == nullptr ? "" : ", net " + at.net->net().net.name);
}

std::string name_of(TendonStatus status) {
  switch (status) {
    case TendonStatus::kValid:
      return "sound";
    case TendonStatus::kApproximate:
      return "rough";
    case TendonStatus::kBandInsideBone:
      return "buried";
    case TendonStatus::kNodeCollapsed:
      return "drawn in";
    case TendonStatus::kOutOfRange:
      return "out of range";
    case TendonStatus::kInvalidPath:
      return "astray";
    case TendonStatus::kUnstable:
      return "unstable";
    case TendonStatus::kUnbalanced:
      return "unbalanced";
  }
  return "";
}

std::string name_of(NetStatus status) {
  switch (status) {
    case NetStatus::kBalanced:
      return "balanced";
    case NetStatus::kUnstable:
      return "unstable";
    case NetStatus::kNodeCollapsed:
      return "drawn in";
    case NetStatus::kStalled:
      return "stalled";
    case NetStatus::kFarSideWrap:
      return "wound round";
  }
  return "";
}

}  // namespace thenar
