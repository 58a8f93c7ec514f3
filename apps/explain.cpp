// thenar explain FILE|NAME [--digit D] [--settings NAME|FITS.toml] [--path P] [--json] [-o FILE]
//
// Explains a file: kept and dropped parts, assumptions, costs, and fitted values.

#include <memory>

#include "api/explain.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "report/explain/explanation.h"

namespace thenar {
void add_explain(CLI::App& app) {
  auto options = std::make_shared<Arguments<ExplainRequest>>();
  CLI::App* command = app.add_subcommand(
      "explain",
      "Show the model built from a file, its assumptions, its cost and its fit parameters");
  command
      ->add_option(
          "file", options->request.thing,
          "Subject, experiment, net, fit, robot, object, world, scene or materials: a file, or "
          "the name of one that comes with thenar")
      ->required();
  // These narrow the explanation of a subject, and are refused for anything else.
  command->add_option("--digit", options->request.digit,
                      "Digit of a subject to explain; default: the only one");
  add_path_option(*command, options->request.path);
  command->add_option("--settings", options->request.settings,
                      "Fit settings for a subject: name or file; default: built in for the digit");
  add_data_option(*command, options->request.data);
  add_output_options(*command, options->outputs, {});
  add_examples(*command, {"explain synek2019_middle", "explain mirakhorlo2016 --digit index",
                          "explain synek2019_H01"});
  command->callback([options] {
    const ThingExplained found = explain_thing(options->request);
    print_warnings(found.outcome.warnings);
    deliver(options->outputs, found);
  });
}

}  // namespace thenar
