// thenar: the human hand, fitted to forces. `thenar --help` lists the subcommands.

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/kind_commands.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/cache.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/lists.h"
#include "base/name_hint.h"
#include "base/nearest_name.h"
#include "base/progress_parts.h"

namespace thenar {
namespace {

/// Names what a misspelt command was meant to be.
void require_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  const std::string name = argv[1];
  require(contains(names, name), "there is no command '{}'{} `thenar --help` lists them", name,
          hint_before_list(name, names));
}

/// The innermost command that was named.
const CLI::App& named_command(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return *command;
}

/// The full name of a command: "tendon solve".
std::string full_name(const CLI::App& command) {
  std::string name = command.get_name();
  for (const CLI::App* above = command.get_parent(); above != nullptr; above = above->get_parent())
    name = fmt::format("{} {}", above->get_name(), name);
  return name;
}

/// ", did you mean '--robustness'?": the nearest option of a command; ";" for plain arguments.
std::string nearest_option(const CLI::App& command, const std::string& argument) {
  if (argument.rfind("--", 0) != 0) return ";";
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) append_all(names, option->get_lnames());
  const std::string nearest = nearest_name(argument.substr(2, argument.find('=') - 2), names);
  return nearest.empty() ? ";" : fmt::format(", did you mean '--{}'?", nearest);
}

/// A sentence about an argument that a command does not know.
std::string unknown_argument(const CLI::App& command, const std::string& argument) {
  return fmt::format("unknown {} '{}'{} see `{} --help`",
                     argument.rfind('-', 0) == 0 ? "option" : "argument", argument,
                     nearest_option(command, argument), full_name(command));
}

/// Error as the command line says it: with the option of the field that it names.
std::string sentence_of(const CLI::App& app, const Error& error) {
  std::string option = "--" + error.field();
  std::replace(option.begin(), option.end(), '_', '-');
  if (error.field().empty() || named_command(app).get_option_no_throw(option) == nullptr)
    return text_with_commands(error);
  return fmt::format("{} ({})", text_with_commands(error), option);
}

/// Shows no default value where it is empty.
void hide_empty_defaults(CLI::App& app) {
  // The program, its commands and theirs.
  std::vector<CLI::App*> commands{&app};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    for (CLI::Option* option : commands[i]->get_options())
      if (option->get_default_str() == "[]") option->default_str("");
    for (CLI::App* below : commands[i]->get_subcommands({})) commands.push_back(below);
  }
}

/// Prints the error of a command line, with a way out. @return the exit code
int complain_of_line(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = named_command(app);
  std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const std::vector<std::string> left = command.remaining();
    if (!left.empty()) text = unknown_argument(command, left.front());
  } else {
    text += fmt::format("; see `{} --help`", full_name(command));
  }
  fmt::print(stderr, "thenar: {}\n", text);
  return 1;
}

int run_command(int argc, char** argv) {
  use_cache(cache_options_of_user());
  CLI::App app("thenar: models of human and robot hands: fits, tendons, grasps, contact, pads",
               "thenar");
  app.option_defaults()->always_capture_default();
  app.require_subcommand(1);
  app.set_version_flag("--version", THENAR_VERSION);
  for (const auto add :
       {add_list,     add_validate, add_explain, add_pose,    add_digit_commands, add_tendon,
        add_simulate, add_pad,      add_study,   add_fit,     add_predict,        add_posterior,
        add_quality,  add_grasp,    add_close,   add_compare, add_view,           add_serve,
        add_import,   add_demo,     add_ask,     add_rerun})
    add(app);
  hide_empty_defaults(app);
  // Help and silent errors bring their own exit codes, an interruption has that of its signal.
  try {
    begin_run(argc, argv);
    require_command(app, argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::RuntimeError& silent) {
    return silent.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return complain_of_line(app, error);
  } catch (const Stopped& e) {
    fmt::print(stderr, "thenar: {}\n", e.what());
    return exit_code_of_interruption();
  } catch (const Error& e) {
    fmt::print(stderr, "thenar: {}\n", sentence_of(app, e));
    return 1;
  } catch (const std::exception& e) {
    fmt::print(stderr, "thenar: {}\n", e.what());
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace thenar

int main(int argc, char** argv) { return thenar::after_output(thenar::run_command(argc, argv)); }
