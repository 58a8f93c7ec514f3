#pragma once

/// Common options of `thenar view` and `thenar serve`, and the requests that open files.

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/progress.h"
#include "report/json.h"
#include "server/access.h"
#include "server/engine.h"
#include "server/token_file.h"

namespace thenar {

/// Options of both commands.
struct LiveArguments {
  std::vector<std::string> files;  // files or names
  ServerAccess access;
  bool no_token = false;  // clients need no token
  std::string log;        // file; empty: none
  std::string data;       // folder with worlds/ ..; empty: the usual ones
};

/// Adds FILE, --port, --bind, --token, --no-token, --log and --data. @returns --port
/// @param count  largest number of files; -1: any;  @param port  help text of --port
CLI::Option* add_live_options(CLI::App& command, LiveArguments& arguments, int count,
                              const std::string& port);

/// Request made by the program itself.
struct OpeningRequest {
  std::string method;
  Json params;
};

/// Returns the request by which a client would open a file or a name: a world, hand, object, scene,
/// subject, run, fit or posterior.
/// @param data  folder with worlds/ ..; empty: the usual ones
/// @throws InputError if it is none of these, or not found.
[[nodiscard]] OpeningRequest opening_request(const std::string& name, const std::string& data);

/// Generates a token if none is given, and checks that other machines need one.
/// @throws InputError as require_safe()
[[nodiscard]] ServerAccess checked_access(const LiveArguments& arguments);

/// Stores the token of a server where programs of this user find it. Returns null, after a warning,
/// if it cannot be stored; also null if no token is used.
[[nodiscard]] std::unique_ptr<TokenFile> keep_token(const ServerAccess& access, int port);

/// Returns an engine that has opened all named files.
/// @throws InputError with the refused request, Stopped
[[nodiscard]] std::unique_ptr<Engine> open_engine(const LiveArguments& arguments,
                                                  const Progress& progress);

/// Waits until Ctrl-C is pressed, SIGTERM arrives, or `ended` returns true.
void wait_for_end(const std::function<bool()>& ended = {});

}  // namespace thenar
