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
  bool no_token = false;  // nobody is asked for one
  std::string log;        // file; empty: none
  std::string data;       // folder with worlds/ ..; empty: the usual ones
};

/// FILE, --port, --bind, --token, --no-token, --log, --data. @returns --port
/// @param count  how many files there may be; -1: any number;  @param port  what --port is for
CLI::Option* add_live_options(CLI::App& command, LiveArguments& arguments, int count,
                              const std::string& port);

/// A request in the name of the program.
struct OpeningRequest {
  std::string method;
  Json params;
};

/// Returns the request by which a client would open a file or a name: a world, hand, object, scene,
/// subject, run, fit or posterior.
/// @param data  folder with worlds/ ..; empty: the usual ones
/// @throws InputError if it is none of these, or not to be found.
[[nodiscard]] OpeningRequest opening_request(const std::string& name, const std::string& data);

/// Makes a token where none is given, and checks that no other machine comes in without.
/// @throws InputError as require_safe()
[[nodiscard]] ServerAccess checked_access(const LiveArguments& arguments);

/// Keeps the token of a server where programs of this user find it. A warning is printed, and null
/// comes back, where it can be kept nowhere; null also where no token is wanted.
[[nodiscard]] std::unique_ptr<TokenFile> keep_token(const ServerAccess& access, int port);

/// Returns an engine that has opened all that was named.
/// @throws InputError with what was refused, Stopped
[[nodiscard]] std::unique_ptr<Engine> open_engine(const LiveArguments& arguments,
                                                  const Progress& progress);

/// Returns when Ctrl-C is pressed or SIGTERM comes, or `ended` says so.
void wait_for_end(const std::function<bool()>& ended = {});

}  // namespace thenar
