#include "apps/options.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/rung_names.h"

namespace thenar {

double parse_number(const std::string& text, const std::string& what) {
  std::size_t read = 0;
  double value = 0;
  try {
    value = std::stod(text, &read);
  } catch (const std::exception&) {
    read = 0;  // not a number at all, or one too large
  }
  require(read > 0 && read == text.size() && std::isfinite(value), "wanted {}, got '{}'", what,
          text);
  return value;
}

std::map<std::string, double> parse_named_numbers(const std::vector<std::string>& texts,
                                                  const std::string& what) {
  std::map<std::string, double> named;
  for (const std::string& text : texts) {
    const std::size_t sign = text.find('=');
    require(sign != std::string::npos && sign > 0, "wanted {}, got '{}'", what, text);
    const std::string name = text.substr(0, sign);
    const double value =
        parse_number(text.substr(sign + 1), fmt::format("{} for '{}'", what, name));
    require(named.emplace(name, value).second, "'{}' is given twice", name);
  }
  return named;
}

PostureRequest parse_posture(const std::vector<std::string>& texts, const std::string& what,
                             const std::string& number) {
  PostureRequest posture;
  posture.unit = PostureUnit::kTyped;
  const bool named = std::any_of(texts.begin(), texts.end(), [](const std::string& text) {
    return text.find('=') != std::string::npos;
  });
  if (named) {
    posture.named = parse_named_numbers(texts, what);
  } else {
    for (const std::string& text : texts) posture.in_order.push_back(parse_number(text, number));
  }
  return posture;
}

Vary parse_vary(const std::string& text) {
  const std::size_t equals = text.find('=');
  require(equals != std::string::npos, "wanted JOINT=from:to:step, got '{}'", text);
  const std::string steps = text.substr(equals + 1);
  const std::size_t first = steps.find(':'), second = steps.find(':', first + 1);
  require(first != std::string::npos && second != std::string::npos,
          "wanted from:to:step [deg], got '{}'", steps);
  return {text.substr(0, equals), parse_number(steps.substr(0, first), "an angle [deg]"),
          parse_number(steps.substr(first + 1, second - first - 1), "an angle [deg]"),
          parse_number(steps.substr(second + 1), "a step [deg]")};
}

void add_data_option(CLI::App& command, std::string& data) {
  command.add_option(
      "--data", data,
      "Folder with robots/, objects/.., before THENAR_DATA, ./data and what came with the program");
}

void add_materials_option(CLI::App& command, std::string& file) {
  command.add_option("--materials", file,
                     "File of materials and friction of your own (TOML), over the built-in table");
}

void add_path_option(CLI::App& command, std::optional<Path>& path) {
  command.add_option_function<std::string>(
      "--path", [&path](const std::string& name) { path = path_named(name); },
      "Tendon paths: straight between via points, polynomials fitted to wrapped ones, or wrapped "
      "over the subject's surfaces, as they are if left out where it states some: " +
          listed(path_names()));
}

void add_passive_option(CLI::App& command, PassiveMoments& passive) {
  command.add_option_function<std::string>(
      "--passive", [&passive](const std::string& word) { passive = passive_named(word); },
      "Passive moments of human joints, where the subject states some: on (default) or off");
}

void add_hand_path_option(CLI::App& command, std::optional<Path>& path) {
  add_path_option(command, path);
  command.get_option("--path")->description(
      "Tendon paths of human hands whose names state none; wrapped if left out where tendons "
      "name surfaces: " +
      listed(path_names()));
}

void add_fit_path_option(CLI::App& command, std::optional<Path>& path) {
  add_path_option(command, path);
  command.get_option("--path")->description(
      "Tendon paths of a fit: via, straight between via points; its force model has no others");
}

void add_posture_option(CLI::App& command, PostureRequest& posture, const std::string& help) {
  posture.unit = PostureUnit::kTyped;  // also of --vary, where no posture is given
  command.add_option_function<std::vector<std::string>>(
      "--posture",
      [&posture](const std::vector<std::string>& texts) { posture = parse_posture(texts); }, help);
}

void add_frozen_option(CLI::App& command, PostureRequest& frozen) {
  add_named_numbers(command, "--frozen", frozen.named, "JOINT=degrees",
                    "JOINT=degrees ...: joints welded there");
  frozen.unit = PostureUnit::kTyped;
}

CLI::Option* add_vary_option(CLI::App& command, std::vector<Vary>& vary) {
  return command.add_option_function<std::vector<std::string>>(
      "--vary",
      [&vary](const std::vector<std::string>& texts) {
        vary.clear();
        for (const std::string& text : texts) vary.push_back(parse_vary(text));
      },
      "JOINT=from:to:step [deg] ...; the last one varies fastest");
}

void add_hood_option(CLI::App& command, std::optional<Hood>& hood, const std::string& usual) {
  command.add_option_function<std::string>(
      "--hood", [&hood](const std::string& name) { hood = hood_named(name); },
      "Extensor hood: " + listed(hood_names()) + "; " + usual + " if left out");
}

void add_net_option(CLI::App& command, std::string& net) {
  command.add_option("--net", net,
                     "Extensor net: " + listed(known_nets()) +
                         ", or a file (TOML); extensor_hood if the hood is a net");
}

CLI::Option* add_named_numbers(CLI::App& command, const std::string& option,
                               std::map<std::string, double>& named, const std::string& what,
                               const std::string& help) {
  return command.add_option_function<std::vector<std::string>>(
      option,
      [&named, what](const std::vector<std::string>& texts) {
        named = parse_named_numbers(texts, what);
      },
      help);
}

namespace {

void add_subject_options(CLI::App& command, DigitRequest& request) {
  add_passive_option(command, request.passive);
  command.add_option("subject", request.subject, "A subject: its name, or its file (TOML)")
      ->required();
  command.add_option("--digit", request.digit, "thumb, index, middle, ring or little");
  add_posture_option(command, request.posture);
  add_frozen_option(command, request.frozen);
  add_path_option(command, request.path);
  add_data_option(command, request.data);
}

}  // namespace

void add_digit_options(CLI::App& command, DigitRequest& request) {
  add_subject_options(command, request);
  command.add_option("--map", request.map, "A published tip map instead of bones and tendons");
}

void add_tendon_options(CLI::App& command, DigitRequest& request, const std::string& usual_hood) {
  add_subject_options(command, request);
  add_hood_option(command, request.hood, usual_hood);
  add_net_option(command, request.net);
}

void add_world_options(CLI::App& command, WorldRequest& request) {
  command.add_option("world", request.world, "A world: its name, or its file (TOML)")->required();
  command.add_option("--hand", request.hand, "Which hand, where there are several");
  command.add_option("--object", request.object, "Which object, where there are several");
  add_passive_option(command, request.passive);
  add_hand_path_option(command, request.path);
  add_data_option(command, request.data);
}

void add_examples(CLI::App& command, const std::vector<std::string>& lines) {
  std::string text = lines.size() == 1 ? "Example:" : "Examples:";
  for (const std::string& line : lines) text += "\n  thenar " + line;
  const std::string before = command.get_footer();
  command.footer(before.empty() ? text : before + "\n\n" + text);
}

CLI::Validator at_least(long least) {
  const auto complaint = [least](const std::string& text) -> std::string {
    long value = 0;
    if (CLI::detail::lexical_cast(text, value) && value >= least) return "";
    return fmt::format("wanted a whole number of at least {}, got {}", least, text);
  };
  return {complaint, fmt::format("at least {}", least)};
}

void require_ending(const std::string& path, const std::vector<std::string>& endings) {
  const std::string ending = std::filesystem::path(path).extension();
  require(path.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end(),
          "wanted an output that ends in {}, got '{}'", fmt::join(endings, " or "), path);
}

}  // namespace thenar
