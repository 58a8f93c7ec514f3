#include "server/line_server.h"

#include <array>
#include <chrono>
#include <deque>
#include <list>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <boost/asio.hpp>

#include "server/lines.h"
#include "server/listener.h"
#include "server/peer_set.h"
#include "server/rpc.h"

namespace thenar {
namespace {

namespace net = boost::asio;
using net::ip::tcp;

// Limits of a client. Beyond those of pending requests its input is not read, beyond that of unsent
// replies its connection is closed.
constexpr std::size_t kMaxPendingRequests = 256;         // requests without a reply
constexpr std::size_t kMaxPendingBytes = kMaxLineBytes;  // requests without a reply [bytes]
constexpr std::size_t kMaxUnsentBytes = 64UL << 20U;     // replies that are not sent [bytes]
// Limits of all clients together. Beyond them only clients without pending requests are read.
constexpr std::size_t kMaxTotalPendingBytes = 32UL << 20U;  // requests without a reply [bytes]
constexpr std::size_t kMaxTotalUnsentBytes = 128UL << 20U;  // replies that are not sent [bytes]
// Limits of strangers: connections that have not sent a valid first line.
constexpr std::size_t kMaxStrangers = 64;          // strangers, also without a token
constexpr std::size_t kMaxGreetingBytes = 4096;    // length of the first line [bytes]
constexpr std::chrono::seconds kGreetingTime{10};  // time until the token must arrive

const std::string kGreetingError = "wanted session.hello with the token first";

class LineClient;

/// State that all connections of a server share. Connections share ownership of it, so that none
/// outlives the context on which it runs.
struct LineNet {
  LineNet(Engine& the_engine, ServerAccess the_access)
      : engine(the_engine), access(std::move(the_access)) {}

  Engine& engine;
  ServerAccess access;
  net::io_context context{1};
  PeerSet<LineClient> peers;
  std::list<LineClient*> strangers;  // the oldest first; each takes itself out
  std::size_t pending = 0;           // requests of all clients without a reply [bytes]
  std::size_t unsent = 0;            // unsent replies of all clients [bytes]
};

/// Connected program. Only the server's thread uses the members; functions that the engine calls
/// post to it.
class LineClient final : public EngineClient, public std::enable_shared_from_this<LineClient> {
 public:
  LineClient(tcp::socket socket, std::shared_ptr<LineNet> shared)
      : net_(std::move(shared)), socket_(std::move(socket)), greeting_timer_(net_->context) {}
  ~LineClient() override {
    leave_strangers();
    net_->peers.remove(this);
  }
  LineClient(const LineClient&) = delete;
  LineClient& operator=(const LineClient&) = delete;

  void begin() {
    boost::system::error_code ignored;
    socket_.set_option(tcp::no_delay(true), ignored);
    socket_.set_option(net::socket_base::keep_alive(true), ignored);
    // Close the oldest stranger if there are too many.
    if (net_->strangers.size() >= kMaxStrangers) {
      const auto oldest = net_->strangers.front()->shared_from_this();
      oldest->drop();
    }
    // Read, and close the connection if the token is not sent in time.
    stranger_ = net_->strangers.insert(net_->strangers.end(), this);
    read();
    if (net_->access.token.empty()) return;
    greeting_timer_.expires_after(kGreetingTime);
    greeting_timer_.async_wait([self = shared_from_this()](boost::system::error_code stopped) {
      if (!stopped && self->stranger_) self->drop();
    });
  }

  void reply(std::string text) override {
    net::post(socket_.get_executor(), [self = shared_from_this(), text = std::move(text)] {
      self->remove_pending();
      if (!text.empty()) self->queue_reply(text);
      self->continue_or_close();
    });
  }
  void notify(std::shared_ptr<const std::string> /*text*/) override {}
  void send_frame(std::shared_ptr<const std::string> /*frame*/) override {}
  [[nodiscard]] bool is_watching() const override { return false; }

  /// Closes the connection after all replies are sent.
  void finish() {
    input_ended_ = true;
    continue_or_close();
  }
  /// Closes the connection at once.
  void drop() {
    boost::system::error_code ignored;
    socket_.close(ignored);
    leave_strangers();
    if (number_ > 0) net_->engine.remove_client(number_);
    number_ = -1;
    // Release what counts against the limits.
    while (!pending_.empty()) remove_pending();
    replies_.clear();
    count_unsent(-static_cast<std::ptrdiff_t>(unsent_));
  }
  [[nodiscard]] std::size_t unsent() const { return unsent_; }

 private:
  /// Becomes a client of the engine. @return false if there are too many clients
  bool join_engine() {
    leave_strangers();
    try {
      number_ = net_->engine.add_client(shared_from_this());
      return true;
    } catch (const InputError& error) {
      refuse(error.what());
      return false;
    }
  }
  /// Removes the connection from the strangers.
  void leave_strangers() {
    if (!stranger_) return;
    net_->strangers.erase(*std::exchange(stranger_, std::nullopt));
    greeting_timer_.cancel();
  }

  void read() {
    reading_ = true;
    socket_.async_read_some(
        net::buffer(input_),
        [self = shared_from_this()](boost::system::error_code error, std::size_t count) {
          self->reading_ = false;
          if (self->number_ < 0) return;
          if (error == net::error::eof) return self->on_end();
          if (error) return self->drop();
          self->on_bytes(count);
        });
  }

  void on_bytes(std::size_t count) {
    if (!is_json_) {
      const StreamStart start = stream_start({input_.data(), count});
      if (start == StreamStart::kOther) return drop();
      is_json_ = start == StreamStart::kRequest;
    }
    lines_.add(input_.data(), count);
    while (const auto line = lines_.next_line())
      if (!handle_line(*line)) return;
    if (stranger_ && !net_->access.token.empty() && lines_.pending_bytes() > kMaxGreetingBytes)
      return refuse(kGreetingError);
    continue_or_close();
  }

  /// Handles the end of the input; the client may still wait for replies.
  void on_end() {
    if (const auto line = lines_.take_rest())
      if (!handle_line(*line)) return;
    input_ended_ = true;
    continue_or_close();
  }

  /// Handles a line of the input. @return false if the connection is refused
  bool handle_line(const SplitLine& line) {
    const std::string& token = net_->access.token;
    if (stranger_ && !token.empty() && !is_hello_with_token(line.text, token)) {
      refuse(kGreetingError);
      return false;
    }
    if (stranger_ && !join_engine()) return false;
    pending_.push_back(line.text.size());
    pending_bytes_ += line.text.size();
    net_->pending += line.text.size();
    if (line.too_long)
      reply(too_long_reply());
    else
      net_->engine.receive(number_, line.text);
    return true;
  }

  /// Removes the oldest pending request, which has its reply.
  void remove_pending() {
    if (pending_.empty()) return;
    pending_bytes_ -= pending_.front();
    net_->pending -= pending_.front();
    pending_.pop_front();
  }

  /// Sends the reason of a refusal, and closes the connection.
  void refuse(const std::string& why) {
    queue_reply(json_text(rpc_reply(nullptr, {{}, RpcFailure{RpcCode::kRefused, why}}), -1));
    finish();
  }

  /// Reads further input if the limits allow it; closes the connection if nothing is left to do.
  void continue_or_close() {
    if (number_ < 0) return;
    if (!input_ended_ && !reading_ && can_read()) return read();
    if (input_ended_ && pending_.empty() && replies_.empty() && !writing_) drop();
  }

  /// Returns true if the limits of pending requests and unsent replies allow to read more.
  [[nodiscard]] bool can_read() const {
    if (unsent_ >= kMaxPendingBytes) return false;
    return pending_.empty() ||
           (pending_.size() < kMaxPendingRequests && pending_bytes_ < kMaxPendingBytes &&
            net_->pending < kMaxTotalPendingBytes);
  }

  void queue_reply(const std::string& text) {
    if (number_ < 0) return;
    replies_.push_back(text + "\n");
    count_unsent(static_cast<std::ptrdiff_t>(replies_.back().size()));
    if (unsent_ > kMaxUnsentBytes) return drop();
    if (net_->unsent > kMaxTotalUnsentBytes) drop_slowest();
    write();
  }

  void count_unsent(std::ptrdiff_t bytes) {
    unsent_ += static_cast<std::size_t>(bytes);
    net_->unsent += static_cast<std::size_t>(bytes);
  }

  /// Closes the connection with the most unsent replies.
  void drop_slowest() {
    std::shared_ptr<LineClient> slowest;
    for (const auto& client : net_->peers.connected())
      if (slowest == nullptr || client->unsent() > slowest->unsent()) slowest = client;
    if (slowest != nullptr) slowest->drop();
  }

  void write() {
    if (writing_ || replies_.empty() || number_ < 0) return;
    writing_ = true;
    // Send short replies together.
    auto out = std::make_shared<std::string>();
    while (!replies_.empty() && (out->empty() || out->size() + replies_.front().size() < 65536)) {
      *out += replies_.front();
      replies_.pop_front();
    }
    net::async_write(
        socket_, net::buffer(*out),
        [self = shared_from_this(), out](boost::system::error_code error, std::size_t) {
          self->writing_ = false;
          if (self->number_ < 0) return;
          if (error) return self->drop();
          self->count_unsent(-static_cast<std::ptrdiff_t>(out->size()));
          self->write();
          self->continue_or_close();
        });
  }

  std::shared_ptr<LineNet> net_;
  tcp::socket socket_;
  net::steady_timer greeting_timer_;
  std::array<char, 65536> input_{};
  LineSplitter lines_{kMaxLineBytes};
  int number_ = 0;                              // number of the client in the engine; -1: closed
  std::deque<std::size_t> pending_;             // length of each request without a reply [bytes]
  std::size_t pending_bytes_ = 0, unsent_ = 0;  // [bytes]
  std::optional<std::list<LineClient*>::iterator>
      stranger_;  // entry of the strangers, if it is one
  bool is_json_ = false, input_ended_ = false, reading_ = false, writing_ = false;
  std::deque<std::string> replies_;
};

}  // namespace

bool is_hello_with_token(const std::string& line, const std::string& token) {
  const auto request = short_request(line, "session.hello");
  if (!request || request->failure) return false;
  const auto shown = request->params.find("token");
  return shown != request->params.end() && shown->is_string() &&
         same_token(shown->get<std::string>(), token);
}

std::string too_long_reply() {
  const RpcFailure failure{RpcCode::kTooLarge,
                           fmt::format("a line of more than {} bytes", kMaxLineBytes)};
  return json_text(rpc_reply(nullptr, {{}, failure}), -1);
}

class LineServer::Network : public ConnectionListener<LineNet, LineClient> {
 public:
  Network(Engine& engine, const ServerAccess& access)
      : ConnectionListener(std::make_shared<LineNet>(engine, access), access, "port 0") {
    start();
  }
};

LineServer::LineServer(Engine& engine, const ServerAccess& access)
    : network_(std::make_unique<Network>(engine, access)) {}

LineServer::~LineServer() = default;

int LineServer::port() const { return network_->port(); }

}  // namespace thenar
