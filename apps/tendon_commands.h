#pragma once

/// The subcommands of `thenar tendon`; each stands in the file of its name.

#include <CLI/CLI.hpp>

namespace thenar {

void add_tendon_infer(CLI::App& tendon);
void add_tendon_solve(CLI::App& tendon);
void add_tendon_sweep(CLI::App& tendon);

}  // namespace thenar
