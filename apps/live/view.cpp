// thenar view [FILE ...] [--port N] [--no-open] [--remote PORT] [--bind ADDRESS] [--token TEXT |
// --no-token]
//
// A page in the browser that shows worlds, motions, digits and fits, and moves them.

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include "apps/commands.h"
#include "apps/live/live_options.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "server/line_server.h"
#include "server/web_server.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX has it nowhere else

namespace thenar {
namespace {

struct ViewArguments {
  LiveArguments live;
  bool closed = false;        // no browser is opened
  std::optional<int> remote;  // port for programs
};

/// Lets the desktop open an address; where there is none, nothing happens. A browser that was
/// started so outlives Ctrl-C, and writes nothing here.
void open_browser(const std::string& address) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  std::string program = "xdg-open", argument = address;
  std::vector<char*> words{program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t files;
  posix_spawnattr_t group;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&group);
  // The browser is a process of its own group, without a terminal.
  for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&files, file, "/dev/null", O_RDWR, 0);
  posix_spawnattr_setflags(&group, POSIX_SPAWN_SETPGROUP);
  pid_t child = 0;
  (void)posix_spawnp(&child, program.c_str(), &files, &group, words.data(), environ);
  posix_spawnattr_destroy(&group);
  posix_spawn_file_actions_destroy(&files);
}

void run_view(const ViewArguments& options) {
  const Progress progress = terminal_progress();
  // The page and the programs share one engine, and so one session.
  const ServerAccess access = checked_access(options.live);
  const auto engine = open_engine(options.live, progress);
  const WebServer server(*engine, access);
  const auto kept = keep_token(access, server.port());
  std::optional<LineServer> remote;
  std::unique_ptr<TokenFile> kept_of_remote;
  if (options.remote) {
    ServerAccess of_programs = access;
    of_programs.port = *options.remote;
    remote.emplace(*engine, of_programs);
    kept_of_remote = keep_token(access, remote->port());
  }
  // The address holds the token, which the page then keeps as a cookie.
  const std::string address = url_of(access, server.port());
  print_answer(address + (access.token.empty() ? "/" : "/?token=" + access.token) + "\n");
  if (remote) print_answer(fmt::format("programs: {}:{}\n", access.address, remote->port()));
  std::fflush(stdout);
  if (!options.closed) open_browser(address + server.opening_target());
  wait_for_end();
  engine->shut_down("thenar was stopped");
}

}  // namespace

void add_view(CLI::App& app) {
  auto options = std::make_shared<ViewArguments>();
  CLI::App* command = app.add_subcommand(
      "view", "Show and move worlds, motions, digits and fits in the browser; Ctrl-C ends it");
  add_live_options(*command, options->live, -1, "Port of the page; 0 takes a free one");
  command
      ->add_option("--remote", options->remote,
                   "Port at which programs control what the page shows; 0 takes a free one")
      ->check(CLI::Range(0, 65535));
  command->add_flag("--no-open", options->closed, "Print the address, and open no browser");
  add_examples(*command, {"view", "view jaw_box", "view human:tendons --no-open",
                          "view wine_glass --port 8080", "view jaw_box --remote 8081"});
  command->callback([options] { run_view(*options); });
}

}  // namespace thenar
