#pragma once

/// JSON-RPC through standard input and output: a program starts the server and is its only client.

#include <functional>

#include "server/engine.h"

namespace thenar {

/// Reads messages from a file descriptor, a line each of at most 1 MB, and writes replies to
/// another, until the input ends or `ended` says so; replies that are due are written before it
/// returns.
/// @param ended  asked ten times a second
/// @throws InputError if the output cannot be written.
void serve_stream(Engine& engine, int input, int output, const std::function<bool()>& ended);

}  // namespace thenar
