#include "apps/options.h"

#include <filesystem>

#include <fmt/ranges.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/rung_names.h"

namespace thenar {

void add_data_option(CLI::App& command, std::string& data) {
  command.add_option("--data", data,
                     "Data folder (with robots/, objects/, ...), searched before THENAR_DATA, "
                     "./data and the data installed with thenar");
}

void add_materials_option(CLI::App& command, std::string& file) {
  command.add_option("--materials", file,
                     "File of materials and friction of your own (TOML), over the built-in table");
}

void add_path_option(CLI::App& command, std::optional<Path>& path) {
  command.add_option_function<std::string>(
      "--path", [&path](const std::string& name) { path = path_named(name); },
      "Tendon paths: straight between via points, polynomials fitted to wrapped ones, or wrapped "
      "over the subject's surfaces; default: wrapped where the subject defines wrapping surfaces, "
      "via otherwise: " +
          listed(path_names()));
}

void add_hand_path_option(CLI::App& command, std::optional<Path>& path) {
  add_path_option(command, path);
  command.get_option("--path")->description(
      "Tendon paths of human hands whose names state none; default: wrapped where the subject "
      "defines wrapping surfaces, via otherwise: " +
      listed(path_names()));
}

void add_fit_path_option(CLI::App& command, std::optional<Path>& path) {
  add_path_option(command, path);
  command.get_option("--path")->description(
      "Tendon paths of a fit: via, straight between via points; its force model has no others");
}

void add_examples(CLI::App& command, const std::vector<std::string>& lines) {
  std::string text = lines.size() == 1 ? "Example:" : "Examples:";
  for (const std::string& line : lines) text += "\n  thenar " + line;
  const std::string before = command.get_footer();
  command.footer(before.empty() ? text : before + "\n\n" + text);
}

void require_ending(const std::string& path, const std::vector<std::string>& endings) {
  const std::string ending = std::filesystem::path(path).extension();
  require(contains(endings, ending), "wanted an output that ends in {}, got '{}'",
          fmt::join(endings, " or "), path);
}

}  // namespace thenar
