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

constexpr int kPoll = 100;  // [ms]
constexpr std::size_t kMostUnansweredLines = 256;
constexpr std::size_t kMostUnansweredBytes = 8UL << 20U;  // of these lines

/// Writes replies from the engine's thread: whoever is at the other end is the only client, and
/// keeps nobody waiting but itself.
class StreamClient final : public EngineClient {
 public:
  explicit StreamClient(int output) : output_(output) {}

  void reply(std::string text) override {
    if (!text.empty()) write_line(text);
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--asked_ == 0) bytes_ = 0;
    answered_.notify_all();
  }
  void notify(std::shared_ptr<const std::string> /*text*/) override {}
  void send_frame(std::shared_ptr<const std::string> /*frame*/) override {}
  [[nodiscard]] bool is_watching() const override { return false; }

  void write_line(const std::string& text) {
    const std::lock_guard<std::mutex> lock(writing_);
    const std::string line = text + "\n";
    for (std::size_t done = 0; done < line.size() && error_ == 0 && !gives_up_;) {
      // As much as a pipe takes at once, so that nobody waits here who is to end.
      pollfd waits{output_, POLLOUT, 0};
      if (poll(&waits, 1, kPoll) <= 0) continue;
      const ssize_t count =
          ::write(output_, line.data() + done, std::min<std::size_t>(line.size() - done, PIPE_BUF));
      if (count >= 0) done += static_cast<std::size_t>(count);
      if (count < 0 && errno != EINTR && errno != EAGAIN) error_ = errno;
    }
  }
  /// Writes no more, whoever may wait for it.
  void give_up() { gives_up_ = true; }

  void ask(std::size_t bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++asked_;
    bytes_ += bytes;
  }
  /// Waits until fewer requests than these are without a reply, and few bytes, or `ended`.
  void wait_below(std::size_t most, const std::function<bool()>& ended) {
    std::unique_lock<std::mutex> lock(mutex_);
    while ((asked_ >= most || bytes_ >= kMostUnansweredBytes) && !ended())
      answered_.wait_for(lock, std::chrono::milliseconds(kPoll));
  }
  [[nodiscard]] int error() const { return error_; }

 private:
  int output_;
  std::mutex mutex_, writing_;
  std::condition_variable answered_;
  std::size_t asked_ = 0, bytes_ = 0;  // requests without a reply; bytes since there were none
  std::atomic<int> error_{0};          // of writing
  std::atomic<bool> gives_up_{false};
};

void take_line(Engine& engine, int number, StreamClient& client, const SplitLine& line) {
  if (line.too_long) return client.write_line(too_long_reply());
  client.ask(line.text.size());
  engine.receive(number, line.text);
}

/// Reads a piece. @returns how many bytes; 0 at the end; -1 if there was nothing yet
ssize_t read_piece(int input, char* bytes, std::size_t most) {
  pollfd waits{input, POLLIN, 0};
  if (poll(&waits, 1, kPoll) <= 0) return -1;
  const ssize_t count = ::read(input, bytes, most);
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return -1;
  return count < 0 ? 0 : count;
}

}  // namespace

void serve_stream(Engine& engine, int input, int output, const std::function<bool()>& ended) {
  const auto client = std::make_shared<StreamClient>(output);
  const int number = engine.add_client(client);
  LineSplitter lines(kMaxLineBytes);
  std::array<char, 65536> piece{};
  // Read pieces, split them into lines, and wait while too many replies are open.
  while (!ended() && client->error() == 0) {
    const ssize_t count = read_piece(input, piece.data(), piece.size());
    if (count < 0) continue;
    if (count == 0) {
      if (const auto line = lines.take_rest()) take_line(engine, number, *client, *line);
      break;
    }
    lines.add(piece.data(), static_cast<std::size_t>(count));
    while (const auto line = lines.next_line()) take_line(engine, number, *client, *line);
    client->wait_below(kMostUnansweredLines, ended);
  }
  // Send what is left before the client goes.
  client->wait_below(1, ended);
  if (ended()) client->give_up();
  engine.remove_client(number);
  const int error = client->error();
  require(error == 0, "cannot write replies: {}", std::strerror(error));
}

}  // namespace thenar
