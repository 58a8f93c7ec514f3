#include "server/stdio_server.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <condition_variable>
#include <cstring>
#include <memory>
#include <mutex>
#include <string>

#include <poll.h>
#include <unistd.h>

#include "base/error.h"
#include "server/line_server.h"
#include "server/lines.h"

namespace thenar {
namespace {

constexpr int kPollTime = 100;                            // longest wait for input or output [ms]
constexpr std::size_t kMaxPendingLines = 256;             // requests without a reply
constexpr std::size_t kMaxPendingLineBytes = 8UL << 20U;  // requests without a reply [bytes]

/// The only client of the engine. It writes replies on the engine's thread, since it can block no
/// other client.
class StreamClient final : public EngineClient {
 public:
  explicit StreamClient(int output) : output_(output) {}

  void reply(std::string text) override {
    if (!text.empty()) write_line(text);
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--pending_ == 0) bytes_ = 0;
    answered_.notify_all();
  }
  void notify(std::shared_ptr<const std::string> /*text*/) override {}
  void send_frame(std::shared_ptr<const std::string> /*frame*/) override {}
  [[nodiscard]] bool is_watching() const override { return false; }

  void write_line(const std::string& text) {
    const std::lock_guard<std::mutex> lock(writing_);
    const std::string line = text + "\n";
    for (std::size_t done = 0; done < line.size() && error_ == 0 && !gave_up_;) {
      // Write no more than a pipe takes at once, so that the write does not block.
      pollfd waits{output_, POLLOUT, 0};
      if (poll(&waits, 1, kPollTime) <= 0) continue;
      const ssize_t count =
          ::write(output_, line.data() + done, std::min<std::size_t>(line.size() - done, PIPE_BUF));
      if (count >= 0) done += static_cast<std::size_t>(count);
      if (count < 0 && errno != EINTR && errno != EAGAIN) error_ = errno;
    }
  }
  /// Stops writing.
  void give_up() { gave_up_ = true; }

  void add_pending(std::size_t bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++pending_;
    bytes_ += bytes;
  }
  /// Waits until fewer than `limit` requests, and few bytes, are pending, or `ended` returns true.
  void wait_below(std::size_t limit, const std::function<bool()>& ended) {
    std::unique_lock<std::mutex> lock(mutex_);
    while ((pending_ >= limit || bytes_ >= kMaxPendingLineBytes) && !ended())
      answered_.wait_for(lock, std::chrono::milliseconds(kPollTime));
  }
  [[nodiscard]] int error() const { return error_; }

 private:
  int output_;
  std::mutex mutex_, writing_;
  std::condition_variable answered_;
  std::size_t pending_ = 0, bytes_ = 0;  // requests without a reply; bytes since there were none
  std::atomic<int> error_{0};            // errno of a failed write; 0: none
  std::atomic<bool> gave_up_{false};
};

void take_line(Engine& engine, int number, StreamClient& client, const SplitLine& line) {
  if (line.too_long) return client.write_line(too_long_reply());
  client.add_pending(line.text.size());
  engine.receive(number, line.text);
}

/// Reads bytes. @return number of bytes; 0 at the end; -1 if there are none yet
ssize_t read_piece(int input, char* bytes, std::size_t size) {
  pollfd waits{input, POLLIN, 0};
  if (poll(&waits, 1, kPollTime) <= 0) return -1;
  const ssize_t count = ::read(input, bytes, size);
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return -1;
  return count < 0 ? 0 : count;
}

}  // namespace

void serve_stream(Engine& engine, int input, int output, const std::function<bool()>& ended) {
  const auto client = std::make_shared<StreamClient>(output);
  const int number = engine.add_client(client);
  LineSplitter lines(kMaxLineBytes);
  std::array<char, 65536> piece{};
  // Read bytes, split them into lines, and wait while too many requests are pending.
  while (!ended() && client->error() == 0) {
    const ssize_t count = read_piece(input, piece.data(), piece.size());
    if (count < 0) continue;
    if (count == 0) {
      if (const auto line = lines.take_rest()) take_line(engine, number, *client, *line);
      break;
    }
    lines.add(piece.data(), static_cast<std::size_t>(count));
    while (const auto line = lines.next_line()) take_line(engine, number, *client, *line);
    client->wait_below(kMaxPendingLines, ended);
  }
  // Wait for all replies, unless the server ends.
  client->wait_below(1, ended);
  if (ended()) client->give_up();
  engine.remove_client(number);
  const int error = client->error();
  require(error == 0, "cannot write replies: {}", std::strerror(error));
}

}  // namespace thenar
