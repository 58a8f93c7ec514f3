// thenar: the human hand, fitted to forces. `thenar --help` lists the subcommands.

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/progress_bar.h"
#include "base/cache.h"
#include "base/error.h"
#include "data/io/nearest_name.h"

namespace thenar {
namespace {

/// Names what a misspelt command was meant to be.
void require_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  const std::string name = argv[1];
  require(std::find(names.begin(), names.end(), name) != names.end(),
          "there is no command '{}'{}; `thenar --help` lists them", name,
          did_you_mean(name, names));
}

}  // namespace
}  // namespace thenar

int main(int argc, char** argv) {
  thenar::use_cache(thenar::cache_options_of_user());
  CLI::App app("thenar: models of the human hand, fitted to forces", "thenar");
  app.require_subcommand(1);
  app.set_version_flag("--version", THENAR_VERSION);
  thenar::add_validate(app);
  thenar::add_explain(app);
  thenar::add_pose(app);
  thenar::add_tip_force(app);
  thenar::add_feasible_force(app);
  thenar::add_tendon(app);
  thenar::add_simulate(app);
  thenar::add_study(app);
  thenar::add_fit(app);
  thenar::add_predict(app);
  thenar::add_posterior(app);
  thenar::add_quality(app);
  thenar::add_grasp(app);
  thenar::add_close(app);
  thenar::add_compare(app);
  thenar::add_import(app);
  thenar::add_demo(app);
  try {
    thenar::require_command(app, argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::RuntimeError& silent) {
    return silent.get_exit_code();
  } catch (const thenar::Interrupted& e) {
    fmt::print(stderr, "thenar: {}\n", e.what());
    return thenar::exit_code_of_interruption();
  } catch (const std::exception& e) {
    fmt::print(stderr, "thenar: {}\n", e.what());
    return 1;
  }
  return 0;
}
