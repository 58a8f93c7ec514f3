#include "server/web_server.h"

#include <chrono>
#include <deque>
#include <list>
#include <optional>
#include <utility>

#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "server/listener.h"
#include "server/peer_set.h"
#include "server/rpc.h"
#include "server/web_pages.h"

namespace thenar {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using tcp = asio::ip::tcp;

// Largest message [bytes]: above RpcLimits::bytes, so that the engine refuses it by a reply.
constexpr std::size_t kMaxMessageBytes = RpcLimits{}.bytes + (16UL << 20U);
constexpr std::size_t kPieceBytes = 65536;  // piece that is read or sent at a time [bytes]
// Limits of a page. Beyond those of pending requests its input is not read, beyond that of unsent
// texts its connection is closed.
constexpr std::size_t kMaxPendingPageRequests = 256;      // requests without a reply
constexpr std::size_t kMaxPendingPageBytes = 1UL << 20U;  // requests without a reply [bytes]
constexpr std::size_t kMaxUnsentTextBytes = 64UL << 20U;  // texts that are not sent [bytes]
// Limits of all pages together, of times and of connections.
constexpr std::size_t kMaxTotalUnsentReplies = 128UL << 20U;  // replies that are not sent [bytes]
constexpr std::size_t kMaxFileConnections = 64;               // HTTP connections
constexpr std::chrono::seconds kLongMessageTime{60};          // time for a long message to arrive
constexpr std::chrono::seconds kRequestTime{10};              // time for an HTTP request to arrive
constexpr std::size_t kFirstBytes = 1024;  // bytes in which an HTTP method must be found

using Request = http::request<http::string_body>;
using Response = http::response<http::span_body<const char>>;

class WebPeer;
class WebClient;
class WebConnection;

/// State that all connections of a server share. Connections share ownership of it, so that none
/// outlives the context on which it runs.
struct Web {
  Web(Engine& the_engine, ServerAccess the_access)
      : engine(the_engine), access(std::move(the_access)) {}

  Engine& engine;
  ServerAccess access;
  asio::io_context context{1};
  int port = 0;
  std::string one_time_target;  // target that replaces the token, once; empty: none or used
  PeerSet<WebPeer> peers;
  std::list<WebConnection*> files;  // connections that ask for files, the oldest first
  // Only one message of more than kMaxPendingPageBytes is read at a time.
  std::weak_ptr<WebClient> long_message;
  std::deque<std::weak_ptr<WebClient>> long_message_queue;
  std::size_t unsent_replies = 0;  // unsent replies of all pages [bytes]
};

/// Connection of a server.
class WebPeer {
 public:
  explicit WebPeer(std::shared_ptr<Web> web) : web_(std::move(web)) {}
  virtual ~WebPeer() { web_->peers.remove(this); }
  WebPeer(const WebPeer&) = delete;
  WebPeer& operator=(const WebPeer&) = delete;

  /// Closes the connection after all texts are sent.
  virtual void finish() = 0;
  /// Closes the connection at once.
  virtual void drop() = 0;
  [[nodiscard]] const std::shared_ptr<Web>& web() const { return web_; }

 private:
  std::shared_ptr<Web> web_;
};

std::string header_of(const Request& request, http::field field) {
  const beast::string_view text = request[field];
  return {text.data(), text.size()};
}

HttpRequest http_request_of(const Request& request) {
  return {{request.method_string().data(), request.method_string().size()},
          {request.target().data(), request.target().size()},
          header_of(request, http::field::host),
          header_of(request, http::field::origin),
          header_of(request, http::field::cookie)};
}

/// Connected page. Only the server's thread uses the members; functions that the engine calls post
/// to it.
class WebClient final : public EngineClient,
                        public WebPeer,
                        public std::enable_shared_from_this<WebClient> {
 public:
  WebClient(tcp::socket socket, std::shared_ptr<Web> its_web)
      : WebPeer(std::move(its_web)),
        stream_(std::move(socket)),
        long_message_timer_(web()->context) {}

  void accept(const Request& request) {
    // Set no idle timeout: a page may be idle for days. TCP keep-alive detects a lost machine.
    websocket::stream_base::timeout times{kRequestTime, websocket::stream_base::none(), false};
    stream_.set_option(times);
    stream_.read_message_max(kMaxMessageBytes);
    stream_.auto_fragment(false);
    stream_.write_buffer_bytes(kPieceBytes);
    beast::error_code ignored;
    stream_.next_layer().set_option(asio::socket_base::keep_alive(true), ignored);
    auto kept = std::make_shared<Request>(request);
    stream_.async_accept(*kept, [self = shared_from_this(), kept](beast::error_code error) {
      if (!error) self->begin();
    });
  }

  void reply(std::string text) override {
    asio::post(stream_.get_executor(), [self = shared_from_this(), text = std::move(text)] {
      self->on_answered();
      if (!text.empty()) self->queue_text({std::make_shared<const std::string>(text), text.size()});
    });
  }
  void notify(std::shared_ptr<const std::string> text) override {
    asio::post(stream_.get_executor(), [self = shared_from_this(), text = std::move(text)] {
      self->queue_text({text, 0});
    });
  }
  void send_frame(std::shared_ptr<const std::string> frame) override {
    asio::post(stream_.get_executor(), [self = shared_from_this(), frame = std::move(frame)] {
      self->frame_ = frame;
      self->write();
    });
  }
  [[nodiscard]] bool is_watching() const override { return true; }

  void finish() override {
    finishing_ = true;
    write();
  }
  void drop() override {
    beast::error_code ignored;
    stream_.next_layer().close(ignored);
    leave_engine();
  }

 private:
  void begin() {
    beast::error_code ignored;
    stream_.next_layer().set_option(tcp::no_delay(true), ignored);
    try {
      number_ = web()->engine.add_client(shared_from_this());
    } catch (const InputError& error) {
      stream_.async_close({websocket::close_code::try_again_later, error.what()},
                          [self = shared_from_this()](beast::error_code) {});
      return;
    }
    read();
  }

  /// Text in the queue. Notifications are shared by all pages, so only replies count as memory.
  struct QueuedText {
    std::shared_ptr<const std::string> text;
    std::size_t reply_bytes = 0;  // [bytes]
  };

  void read() {
    stream_.async_read_some(
        buffer_, kPieceBytes, [self = shared_from_this()](beast::error_code error, std::size_t) {
          if (error) return self->leave_engine();
          if (self->number_ < 0) return;
          if (self->stream_.is_message_done()) return self->on_message();
          if (self->buffer_.size() <= kMaxPendingPageBytes || self->claim_long_message())
            self->read();
        });
  }

  /// Claims the right to read a long message. Returns false if another page has it; this page then
  /// waits for its turn.
  bool claim_long_message() {
    const auto other = web()->long_message.lock();
    if (other != nullptr && other.get() != this) {
      web()->long_message_queue.push_back(weak_from_this());
      return false;
    }
    if (other != nullptr) return true;
    web()->long_message = weak_from_this();
    long_message_timer_.expires_after(kLongMessageTime);
    long_message_timer_.async_wait([self = shared_from_this()](beast::error_code stopped) {
      if (!stopped) self->drop();
    });
    return true;
  }

  /// Releases the right to read a long message, and passes it to the next page.
  void end_long_message() {
    if (web()->long_message.lock().get() != this) return;
    web()->long_message.reset();
    long_message_timer_.cancel();
    while (!web()->long_message_queue.empty()) {
      const auto next = web()->long_message_queue.front().lock();
      web()->long_message_queue.pop_front();
      if (next != nullptr && next->number_ > 0 && next->claim_long_message()) return next->read();
    }
  }

  void on_message() {
    long_message_timer_.cancel();
    std::string message = beast::buffers_to_string(buffer_.data());
    buffer_ = {};  // release the memory of a long message
    ++pending_;
    pending_bytes_ += message.size();
    web()->engine.receive(number_, std::move(message));
    if (pending_ < kMaxPendingPageRequests && pending_bytes_ < kMaxPendingPageBytes) return read();
    paused_ = true;
  }

  void on_answered() {
    --pending_;
    if (pending_ == 0) {
      pending_bytes_ = 0;
      end_long_message();
    }
    if (!paused_ || pending_ > kMaxPendingPageRequests / 2 ||
        pending_bytes_ >= kMaxPendingPageBytes)
      return;
    paused_ = false;
    if (number_ > 0) read();
  }

  void queue_text(QueuedText next) {
    if (number_ < 0) return;
    unsent_ += next.text->size();
    unsent_replies_ += next.reply_bytes;
    web()->unsent_replies += next.reply_bytes;
    texts_.push_back(std::move(next));
    // Close the connection of a page that does not read.
    if (unsent_ > kMaxUnsentTextBytes) return drop();
    if (web()->unsent_replies > kMaxTotalUnsentReplies) drop_slowest();
    write();
  }

  /// Closes the connection with the most unsent replies.
  void drop_slowest() {
    std::shared_ptr<WebClient> slowest;
    for (const auto& peer : web()->peers.connected())
      if (const auto client = std::dynamic_pointer_cast<WebClient>(peer))
        if (slowest == nullptr || client->unsent_replies_ > slowest->unsent_replies_)
          slowest = client;
    if (slowest != nullptr) slowest->drop();
  }

  void write() {
    if (writing_ || number_ <= 0) return;
    // Send texts first, then the newest frame, then the close.
    std::shared_ptr<const std::string> next;
    if (!texts_.empty()) {
      next = std::move(texts_.front().text);
      const std::size_t reply_bytes = texts_.front().reply_bytes;
      texts_.pop_front();
      unsent_ -= next->size();
      unsent_replies_ -= reply_bytes;
      web()->unsent_replies -= reply_bytes;
      stream_.text(true);
    } else if (frame_ != nullptr) {
      next = std::exchange(frame_, nullptr);
      stream_.binary(true);
    } else if (finishing_) {
      writing_ = true;
      stream_.async_close({websocket::close_code::going_away, "the server ends"},
                          [self = shared_from_this()](beast::error_code) {});
      return;
    } else {
      return;
    }
    writing_ = true;
    stream_.async_write(asio::buffer(*next),
                        [self = shared_from_this(), next](beast::error_code error, std::size_t) {
                          self->writing_ = false;
                          if (error) return self->leave_engine();
                          self->write();
                        });
  }

  void leave_engine() {
    if (number_ < 0) return;
    web()->engine.remove_client(number_);
    number_ = -1;
    web()->unsent_replies -= std::exchange(unsent_replies_, 0);
    texts_.clear();
    frame_.reset();
    end_long_message();
  }

  websocket::stream<tcp::socket> stream_;
  beast::flat_buffer buffer_;
  int number_ = 0;                         // number of the client in the engine; -1: closed
  asio::steady_timer long_message_timer_;  // limits the time of a long message
  std::size_t pending_ = 0, pending_bytes_ = 0, unsent_ = 0, unsent_replies_ = 0;
  bool paused_ = false, writing_ = false, finishing_ = false;
  std::deque<QueuedText> texts_;
  std::shared_ptr<const std::string> frame_;  // the latest
};

/// HTTP connection, which may become a WebSocket.
class WebConnection final : public WebPeer, public std::enable_shared_from_this<WebConnection> {
 public:
  /// Closes the oldest connection if there are too many.
  WebConnection(tcp::socket socket, std::shared_ptr<Web> its_web)
      : WebPeer(std::move(its_web)), stream_(std::move(socket)) {
    if (web()->files.size() >= kMaxFileConnections) web()->files.front()->drop();
    file_entry_ = web()->files.insert(web()->files.end(), this);
  }
  ~WebConnection() override { leave_files(); }

  void finish() override { drop(); }
  void drop() override {
    stream_.close();
    leave_files();
  }

  /// Reads until the bytes begin with an HTTP method; closes the connection for other protocols.
  void begin() {
    stream_.expires_after(kRequestTime);
    stream_.async_read_some(
        buffer_.prepare(kFirstBytes),
        [self = shared_from_this()](beast::error_code error, std::size_t count) {
          if (error) return;
          self->buffer_.commit(count);
          const HttpStart start = http_start(beast::buffers_to_string(self->buffer_.data()));
          if (start == HttpStart::kOther) return self->drop();
          if (start == HttpStart::kOpen) return self->begin();
          self->read();
        });
  }

 private:
  void read() {
    parser_.emplace();
    parser_->body_limit(1024);
    stream_.expires_after(kRequestTime);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) {
                       if (!error) self->on_request();
                     });
  }

  void on_request() {
    const Request& request = parser_->get();
    if (request.method() == http::verb::unknown) return drop();
    HttpRequest question = http_request_of(request);
    // Replace the one-time target of the browser that the program opened by the token.
    if (!web()->one_time_target.empty() && same_token(question.target, web()->one_time_target)) {
      question.target = "/?token=" + web()->access.token;
      web()->one_time_target.clear();
    }
    // Respond to requests other than a WebSocket, and refuse a foreign one.
    const ServerAccess& access = web()->access;
    if (path_of(question) != "/ws" || !websocket::is_upgrade(request))
      return write(respond_to(access, web()->port, question,
                              [this](const std::string& id) { return web()->engine.mesh(id); }));
    if (auto refused = socket_refusal_of(access, web()->port, question))
      return write(*std::move(refused));
    // Become a WebSocket.
    stream_.expires_never();
    leave_files();
    const auto client = std::make_shared<WebClient>(stream_.release_socket(), web());
    web()->peers.add(client);
    client->accept(request);
  }

  void write(HttpResponse answer) {
    // Build the response; `body` and `kept` keep it alive until it is written.
    const Request& request = parser_->get();
    Response response(static_cast<http::status>(answer.status), 11);
    for (const auto& [name, value] : answer.headers) response.set(name, value);
    response.set(http::field::server, "thenar");
    const auto body = answer.mesh != nullptr
                          ? answer.mesh
                          : std::make_shared<const std::string>(std::move(answer.body));
    response.body() = {body->data(), body->size()};
    response.keep_alive(request.keep_alive());
    response.prepare_payload();
    // A response to HEAD has no body.
    if (request.method() == http::verb::head) response.body() = {};
    auto kept = std::make_shared<Response>(std::move(response));
    stream_.expires_after(kRequestTime);
    http::async_write(
        stream_, *kept,
        [self = shared_from_this(), kept, body](beast::error_code error, std::size_t) {
          if (error) return;
          if (kept->keep_alive()) return self->read();
          self->stream_.socket().shutdown(tcp::socket::shutdown_send, error);
        });
  }

  void leave_files() {
    if (file_entry_) web()->files.erase(*std::exchange(file_entry_, std::nullopt));
  }

  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  std::optional<std::list<WebConnection*>::iterator> file_entry_;
  std::optional<http::request_parser<http::string_body>> parser_;
};

}  // namespace

class WebServer::Network {
 public:
  Network(Engine& engine, const ServerAccess& access)
      : web_(std::make_shared<Web>(engine, access)), listener_(web_, access, "--port 0") {
    web_->port = listener_.port();
    opening_target_ = access.token.empty() ? "/" : "/?once=" + random_token();
    if (!access.token.empty()) web_->one_time_target = opening_target_;
    listener_.start();
  }

  [[nodiscard]] int port() const { return web_->port; }
  [[nodiscard]] const std::string& opening_target() const { return opening_target_; }

 private:
  std::shared_ptr<Web> web_;
  std::string opening_target_;
  ConnectionListener<Web, WebConnection> listener_;
};

WebServer::WebServer(Engine& engine, const ServerAccess& access)
    : network_(std::make_unique<Network>(engine, access)) {}

WebServer::~WebServer() = default;

int WebServer::port() const { return network_->port(); }

std::string WebServer::opening_target() const { return network_->opening_target(); }

}  // namespace thenar
