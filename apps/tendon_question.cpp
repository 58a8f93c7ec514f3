#include "apps/tendon_question.h"

#include "apps/digit_question.h"
#include "apps/options.h"
#include "api/digits.h"
#include "apps/path_option.h"
#include "api/posture.h"
#include "report/table.h"
#include "report/json.h"
#include "base/error.h"
#include "tendons/net/build_tendons.h"

namespace thenar {
namespace {

std::unique_ptr<DigitTendons> build(const Subject& subject, const std::string& digit,
                                    const TendonQuestion& question) {
  TendonOptions options;
  const std::string hood = question.hood.empty() ? "net" : question.hood;
  options.hood = kHoods.at(hood);
  options.path = path_meant(question.path);
  options.frozen = parse_frozen(subject, question.frozen);
  const std::string name = net_meant(hood, question.net);
  if (name.empty()) return build_digit_tendons(subject, digit, options);
  const NetDescription net = find_net(name);
  return build_digit_tendons(subject, digit, options, &net);
}

}  // namespace

void add_options(CLI::App& command, TendonQuestion& question) {
  command.add_option("subject", question.subject, "Subject file (TOML)")->required();
  command.add_option("--digit", question.digit, "thumb, index, middle, ring or little");
  command.add_option("--hood", question.hood, "separate, fractions or net (default)")
      ->check(CLI::IsMember({"separate", "fractions", "net"}));
  add_path_option(command, question.path);
  command.add_option(
      "--net", question.net,
      "Extensor net: " + listed(known_nets()) + ", or a file (TOML); winslow if left out");
  command.add_option("--posture", question.posture,
                     "JOINT=degrees ..., or degrees in joint order; others stay at 0");
  command.add_option("--frozen", question.frozen, "JOINT=degrees ...: joints welded there");
  command.add_option("--tension", question.tension, "MUSCLE=newton ...; others are slack")
      ->required();
}

TendonCase find_tendons(const TendonQuestion& question) {
  const Subject subject = read_subject(question.subject);
  TendonCase at{subject.name, choose_digit(subject, question.digit), {}, nullptr, {}, {}};
  at.tendons = build(subject, at.digit, question);
  at.net = dynamic_cast<const NetTendons*>(at.tendons.get());
  const std::vector<std::string>& muscles = at.bones().names.muscles;
  require(!muscles.empty(), "no muscle of subject '{}' crosses a free joint of digit '{}'",
          subject.name, at.digit);
  at.q = parse_posture(at.bones().skeleton, question.posture);
  warn_of_limits(at.bones().skeleton, at.q);
  warn_of_collapse(at.net != nullptr ? at.net->linear() : *at.tendons, at.q);
  at.t = in_order(parse_named_numbers(question.tension, "MUSCLE=newton"), muscles, "muscle");
  for (Eigen::Index i = 0; i < at.t.size(); ++i)
    require(at.t[i] >= 0, "wanted a tension >= 0 of '{}', got {} N",
            muscles[static_cast<std::size_t>(i)], at.t[i]);
  return at;
}

nlohmann::ordered_json json_header(const TendonCase& at) {
  nlohmann::ordered_json json{
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
