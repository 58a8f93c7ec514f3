#pragma once

/// JSON-RPC over standard input and output: a program starts the server and is its only client.

#include <functional>

#include "server/engine.h"

namespace thenar {

/// Reads messages from a file descriptor, one line of at most 1 MB each, and writes replies to
/// another, until the input ends or `ended` returns true. Pending replies are written before it
/// returns if the input has ended.
/// @param input, output  file descriptors
/// @param ended          called about ten times a second
/// @throws InputError if the output cannot be written
void serve_stream(Engine& engine, int input, int output, const std::function<bool()>& ended);

}  // namespace thenar
