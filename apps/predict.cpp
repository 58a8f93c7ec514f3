// thenar predict FIT.h5 EXPERIMENT...
//
// Predicts the forces of any experiment on the fitted digit, also of a specimen that was never
// fitted, and compares them with the measurements.

#include "apps/commands.h"
#include "apps/request_options.h"

namespace thenar {

void add_predict(CLI::App& app) {
  const auto [command, typed] =
      add_question_command(app, {"predict",
                                 "predict",
                                 {"fit synek2019_H01 --subject an_chao_middle -o out/fit.h5",
                                  "predict out/fit.h5 synek2019_B01 --report out/predicted.html"}});
  command->add_flag("--allow-unconverged", typed->allow_unconverged,
                    "Exit without an error even if the fit has not converged");
}

}  // namespace thenar
