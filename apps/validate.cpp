// thenar validate FILE|NAME... [--subject S] [--json] [--csv] [-o FILE]
//
// What every file is and holds, or what is wrong with it and where; whether experiments suit a
// subject.

#include <memory>

#include "api/validate.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "report/answers/validation.h"

namespace thenar {
void add_validate(CLI::App& app) {
  auto options = std::make_shared<Arguments<ValidateRequest>>();
  CLI::App* command =
      app.add_subcommand("validate", "Identify files, and report their first error");
  command
      ->add_option("files", options->request.things,
                   "Files to check (TOML, HDF5, netCDF), or names of bundled items")
      ->required();
  command->add_option("--subject", options->request.subject,
                      "Subject (name or file) to check the experiments against: digit, joints, "
                      "muscles, postures, forces");
  add_materials_option(*command, options->request.materials);
  add_data_option(*command, options->request.data);
  add_output_options(*command, options->outputs, {true, true});
  add_examples(*command, {"validate data/subjects/*.toml data/experiments/*.toml",
                          "validate synek2019_H01 --subject synek2019_middle"});
  command->callback([options] {
    const Validation found = validate(options->request);
    deliver(options->outputs, found);
    if (!found.valid()) throw CLI::RuntimeError(1);  // exits silently: all has been said
  });
}

}  // namespace thenar
