#include "apps/live/live_options.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "api/named/files.h"
#include "api/named/things.h"
#include "apps/options.h"
#include "apps/terminal.h"
#include "base/file_io.h"
#include "base/interrupt.h"
#include "server/methods/method_table.h"

namespace thenar {
namespace {

constexpr std::chrono::milliseconds kSignalPollInterval{
    20};  // time between two checks for a signal [ms]

/// Method that opens a kind of file, and the name of its parameter.
struct FileOpener {
  const char* kind;
  const char* method;
  const char* param;
};

constexpr std::array<FileOpener, 10> kFileOpeners{{{"world", "world.load", "world"},
                                                   {"robot", "world.add_hand", "hand"},
                                                   {"object", "world.add_object", "object"},
                                                   {"mesh", "world.add_object", "object"},
                                                   {"scene", "motion.open", "scene"},
                                                   {"subject", "tendons.open", "subject"},
                                                   {"scene run", "motion.record", "file"},
                                                   {"motion", "motion.record", "file"},
                                                   {"fit", "fit.open", "file"},
                                                   {"posterior", "fit.open", "file"}}};

}  // namespace

CLI::Option* add_live_options(CLI::App& command, LiveArguments& arguments, int count,
                              const std::string& port) {
  command
      .add_option(
          "file", arguments.files,
          "World, hand, object, mesh, scene, subject, run, fit or posterior, by file or name")
      ->type_name("FILE")
      ->expected(0, count);
  CLI::Option* option = command.add_option("--port", arguments.access.port, port);
  option->check(CLI::Range(0, 65535));
  command.add_option("--bind", arguments.access.address,
                     "Address to listen on; other machines need --token");
  CLI::Option* token = command.add_option(
      "--token", arguments.access.token,
      "Access token for clients; `auto` generates and prints one. Default: generated");
  command
      .add_flag("--no-token", arguments.no_token, "Allow all users of this machine without a token")
      ->excludes(token);
  command.add_option("--log", arguments.log,
                     "File that every request is written to; `serve --replay` repeats them");
  add_data_option(command, arguments.data);
  return option;
}

OpeningRequest opening_request(const std::string& name, const std::string& data) {
  // Versions of human hands are no files: "human:tendons".
  if ((name == "human" || name.rfind("human:", 0) == 0) && !is_file(name))
    return {"world.add_hand", {{"hand", name}}};
  // Anything else is a file, whose contents decide how it is opened.
  const std::string path = named_thing(name, data);
  const std::string kind = contents_of(path).kind;
  const auto* const found =
      std::find_if(kFileOpeners.begin(), kFileOpeners.end(),
                   [&](const FileOpener& opening) { return kind == opening.kind; });
  require(found != kFileOpeners.end(),
          "{}: wanted a world, hand, object, mesh, scene, subject, run, fit or posterior{}", path,
          kind.empty() ? "" : ", got " + kind);
  return {found->method, {{found->param, path}}};
}

ServerAccess checked_access(const LiveArguments& arguments) {
  ServerAccess access = arguments.access;
  const bool here = is_loopback(access.address);
  if (access.token == "auto" || (access.token.empty() && here && !arguments.no_token))
    access.token = random_token();
  require_safe(access);
  return access;
}

std::unique_ptr<TokenFile> keep_token(const ServerAccess& access, int port) {
  if (access.token.empty()) return nullptr;
  try {
    return std::make_unique<TokenFile>(port, access.token);
  } catch (const InputError& error) {
    print_warnings({error.what()});
    return nullptr;
  }
}

std::unique_ptr<Engine> open_engine(const LiveArguments& arguments, const Progress& progress) {
  EngineOptions options;
  options.log = arguments.log;
  options.on_error = [](const std::string& text) { print_warnings({text}); };
  SessionFolders places;
  places.data = arguments.data;
  // Begin with an empty world if nothing is named; otherwise open the files one after the other.
  MethodTable table = method_table();
  const bool begins_empty = arguments.files.empty() && table.has_method("world.new");
  auto engine = std::make_unique<Engine>(std::move(table), std::move(places), std::move(options));
  if (begins_empty) (void)engine->call("world.new", Json::object());
  for (const std::string& file : arguments.files) {
    const OpeningRequest request = opening_request(file, arguments.data);
    const OrderedJson result = engine->call(request.method, request.params, progress);
    if (!result.is_object() || !result.contains("warnings")) continue;
    print_warnings(result["warnings"].get<std::vector<std::string>>());
  }
  return engine;
}

void wait_for_end(const std::function<bool()>& ended) {
  while (!interrupted() && !(ended && ended())) std::this_thread::sleep_for(kSignalPollInterval);
}

}  // namespace thenar
