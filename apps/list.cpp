// thenar list [subjects|experiments|worlds|hands|objects|nets|..] [SUBJECT] [--json] [--csv] [-o
// FILE]
//
// Names that commands take, with what each is.

#include <memory>

#include "api/named/catalogue.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/nearest_name.h"
#include "report/answers/catalogue.h"

namespace thenar {
void add_list(CLI::App& app) {
  auto options = std::make_shared<Arguments<CatalogueRequest>>();
  CLI::App* command = app.add_subcommand(
      "list", "List the names that commands accept: subjects, worlds, hands, objects ..");
  command->add_option("what", options->request.what,
                      "Kind of names (default: all): " + listed(catalogue_words()));
  command->add_option("of", options->request.of,
                      "Subject (name or file) whose joints, muscles or digits are listed; joints "
                      "also of a robot");
  add_materials_option(*command, options->request.materials);
  add_data_option(*command, options->request.data);
  add_output_options(*command, options->outputs, {true, true});
  add_examples(*command, {"list", "list hands", "list muscles mirakhorlo2016 --csv"});
  command->callback([options] {
    const Catalogue found = list_names(options->request);
    print_warnings(found.warnings);
    deliver(options->outputs, found);
  });
}

}  // namespace thenar
