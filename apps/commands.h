#pragma once

/// Subcommands of `thenar`, each defined in the file of its name.

#include <CLI/CLI.hpp>

namespace thenar {

void add_ask(CLI::App& app);
void add_close(CLI::App& app);
void add_compare(CLI::App& app);
void add_demo(CLI::App& app);
void add_digit_commands(CLI::App& app);
void add_explain(CLI::App& app);
void add_fit(CLI::App& app);
void add_grasp(CLI::App& app);
void add_import(CLI::App& app);
void add_list(CLI::App& app);
void add_pad(CLI::App& app);
void add_pose(CLI::App& app);
void add_posterior(CLI::App& app);
void add_predict(CLI::App& app);
void add_quality(CLI::App& app);
void add_rerun(CLI::App& app);
void add_serve(CLI::App& app);
void add_simulate(CLI::App& app);
void add_study(CLI::App& app);
void add_tendon(CLI::App& app);
void add_validate(CLI::App& app);
void add_view(CLI::App& app);

}  // namespace thenar
