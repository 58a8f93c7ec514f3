// thenar serve [FILE] --port N | --stdio | --replay LOG | --methods markdown
//
// The live side for programs: JSON-RPC 2.0, a line a message.

#include <cstdio>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "apps/commands.h"
#include "apps/live/live_options.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/interrupt.h"
#include "server/line_server.h"
#include "server/methods/method_table.h"
#include "server/remote_docs.h"
#include "server/replay.h"
#include "server/stdio_server.h"

namespace thenar {
namespace {

struct ServeArguments {
  LiveArguments live;
  CLI::Option* port = nullptr;
  bool stdio = false;
  std::string replay;         // a log; empty: none
  std::string replay_writes;  // folder that its requests may write to; empty: they write nothing
  std::string methods;        // form in which they are printed; empty: not at all
};

/// Repeats a log. A different reply means that something that it depends on has changed.
void run_replay(const ServeArguments& options) {
  // Requests that write files are left out unless a folder is given for them.
  SessionFolders places;
  places.data = options.live.data;
  if (!options.replay_writes.empty()) places.folder = options.replay_writes;
  Session session(std::move(places));
  if (!options.live.log.empty()) session.log().open(options.live.log);
  const ReplayWrites writes =
      options.replay_writes.empty() ? ReplayWrites::kSkipped : ReplayWrites::kDone;
  const ReplayResult result =
      replay(read_log(options.replay), method_table(), session, writes, terminal_progress());
  const std::string skipped =
      result.skipped == 0 ? ""
                          : fmt::format(
                                "; {} that write files were skipped (--replay-writes FOLDER "
                                "lets them write there)",
                                result.skipped);
  // A reply that differs ends the replay, since all later ones depend on it.
  if (!result.first_difference) {
    print_answer(fmt::format("{} requests repeated, all replies are as they were{}\n",
                             result.requests, skipped));
    return;
  }
  print_answer(fmt::format("{} requests repeated, the last reply differs: {}:{}{}\n",
                           result.requests, options.replay, *result.first_difference, skipped));
  throw CLI::RuntimeError(1);
}

void run_stdio(const ServeArguments& options) {
  const auto engine = open_engine(options.live, terminal_progress());
  serve_stream(*engine, STDIN_FILENO, STDOUT_FILENO, interrupted);
}

void run_port(const ServeArguments& options) {
  const ServerAccess access = checked_access(options.live);
  const auto engine = open_engine(options.live, terminal_progress());
  const LineServer server(*engine, access);
  const auto kept = keep_token(access, server.port());
  print_answer(fmt::format("listening at {}:{}\n", access.address, server.port()));
  if (access.token != options.live.access.token) print_answer("token " + access.token + "\n");
  std::fflush(stdout);
  wait_for_end();
  engine->shut_down("thenar was stopped");
}

void run_serve(const ServeArguments& options) {
  const int ways = (options.stdio ? 1 : 0) + (options.port->count() > 0 ? 1 : 0) +
                   (options.replay.empty() ? 0 : 1) + (options.methods.empty() ? 0 : 1);
  require(ways == 1, "wanted one of --port N, --stdio, --replay LOG and --methods");
  if (!options.methods.empty()) return print_answer(methods_markdown(method_table()));
  if (!options.replay.empty()) return run_replay(options);
  require(!options.stdio || options.live.access.token.empty(),
          "--stdio has one client, which started it: wanted no --token, or --port");
  if (options.stdio) return run_stdio(options);
  run_port(options);
}

}  // namespace

void add_serve(CLI::App& app) {
  auto options = std::make_shared<ServeArguments>();
  CLI::App* command = app.add_subcommand(
      "serve", "Let programs control worlds, motions, digits and fits: JSON-RPC 2.0, line by line");
  options->port = add_live_options(*command, options->live, 1, "TCP port; 0 selects a free one");
  command->add_flag("--stdio", options->stdio,
                    "Take requests from standard input, and write replies to standard output");
  CLI::Option* replay = command->add_option("--replay", options->replay,
                                            "Replay the requests of a log, except those that write "
                                            "files, up to the first different reply");
  command
      ->add_option("--replay-writes", options->replay_writes,
                   "Folder in which requests of the log may write files")
      ->check(CLI::ExistingDirectory)
      ->needs(replay);
  command->add_option("--methods", options->methods, "Print all methods")
      ->check(CLI::IsMember({"markdown"}));
  add_examples(*command, {"serve jaw_box --port 8081", "serve --stdio --log session.jsonl",
                          "serve --replay session.jsonl", "serve --methods markdown"});
  command->callback([options] { run_serve(*options); });
}

}  // namespace thenar
