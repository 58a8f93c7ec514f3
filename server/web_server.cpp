#include "server/web_server.h"

#include <chrono>
#include <deque>
#include <list>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "base/error.h"
#include "server/peer_set.h"
#include "server/web_pages.h"

namespace thenar {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using tcp = asio::ip::tcp;

constexpr std::size_t kLongestMessage = 80UL << 20U;  // of a WebSocket; ours refuses less than that
constexpr std::size_t kWritePiece = 65536;            // that is sent at a time [bytes]
// Of what a page has asked without a reply so far: beyond these it is read no further. Texts that
// it does not take end its connection.
constexpr std::size_t kMostAsked = 256;                  // requests
constexpr std::size_t kMostAskedTogether = 1UL << 20U;   // [bytes]
constexpr std::size_t kMostWaiting = 64UL << 20U;        // texts that it does not take [bytes]
constexpr std::size_t kMostWaitingOfAll = 128UL << 20U;  // replies, of all pages [bytes]
constexpr std::chrono::seconds kLongMessageTime{60};     // that a longer message may take
constexpr std::size_t kMostFileConnections = 64;         // that ask for files
constexpr std::chrono::seconds kRequestTime{10};         // that a request may take to arrive
constexpr std::chrono::milliseconds kFarewell{300};      // that texts have to leave at the end
constexpr std::size_t kFirstPiece = 1024;  // that shows whether HTTP is spoken [bytes]

using Request = http::request<http::string_body>;
using Response = http::response<http::span_body<const char>>;

class WebPeer;
class WebClient;
class WebConnection;

/// State that all connections of a server share. It holds the context on which they run, so that a
/// connection that the engine still knows does not outlive the context.
struct Web {
  Web(Engine& the_engine, ServerAccess the_access)
      : engine(the_engine), access(std::move(the_access)) {}

  Engine& engine;
  ServerAccess access;
  asio::io_context context{1};
  int port = 0;
  std::string once;  // the target that shows the page without the token, once; empty: none any more
  PeerSet<WebPeer> peers;
  std::list<WebConnection*> files;  // connections that ask for files, the oldest first
  // Messages of more than kMostAskedTogether come one after the other.
  std::weak_ptr<WebClient> long_message;
  std::deque<std::weak_ptr<WebClient>> want_long_message;
  std::size_t waiting = 0;  // replies that pages do not take [bytes]
};

/// A connection, known to its server for as long as it lives.
class WebPeer {
 public:
  explicit WebPeer(std::shared_ptr<Web> web) : web_(std::move(web)) {}
  virtual ~WebPeer() { web_->peers.remove(this); }
  WebPeer(const WebPeer&) = delete;
  WebPeer& operator=(const WebPeer&) = delete;

  /// Ends when all is sent.
  virtual void finish() = 0;
  /// Ends now.
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

// A page that is connected. All members are used by the server's thread; what the engine calls
// hands over to it.
class WebClient final : public EngineClient,
                        public WebPeer,
                        public std::enable_shared_from_this<WebClient> {
 public:
  WebClient(tcp::socket socket, std::shared_ptr<Web> its_web)
      : WebPeer(std::move(its_web)), stream_(std::move(socket)), patience_(web()->context) {}

  void accept(const Request& request) {
    // A page may be quiet for days; the system finds out whether its machine is gone.
    websocket::stream_base::timeout times{kRequestTime, websocket::stream_base::none(), false};
    stream_.set_option(times);
    stream_.read_message_max(kLongestMessage);
    stream_.auto_fragment(false);
    stream_.write_buffer_bytes(kWritePiece);
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
      if (!text.empty()) self->put({std::make_shared<const std::string>(text), text.size()});
    });
  }
  void notify(std::shared_ptr<const std::string> text) override {
    asio::post(stream_.get_executor(), [self = shared_from_this(), text = std::move(text)] {
      self->put({text, 0});
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
    leave();
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

  /// A text that waits. What all are told is one memory, and counts as nobody's.
  struct Waiting {
    std::shared_ptr<const std::string> text;
    std::size_t own = 0;  // [bytes]
  };

  void read() {
    stream_.async_read_some(buffer_, kWritePiece,
                            [self = shared_from_this()](beast::error_code error, std::size_t) {
                              if (error) return self->leave();
                              if (self->number_ < 0) return;
                              if (self->stream_.is_message_done()) return self->on_message();
                              if (self->buffer_.size() <= kMostAskedTogether || self->may_be_long())
                                self->read();
                            });
  }

  /// Returns true if this message may exceed the common limit of all messages; otherwise the
  /// connection waits for its turn to read on.
  bool may_be_long() {
    const auto other = web()->long_message.lock();
    if (other != nullptr && other.get() != this) {
      web()->want_long_message.push_back(weak_from_this());
      return false;
    }
    if (other != nullptr) return true;
    web()->long_message = weak_from_this();
    patience_.expires_after(kLongMessageTime);
    patience_.async_wait([self = shared_from_this()](beast::error_code stopped) {
      if (!stopped) self->drop();
    });
    return true;
  }

  /// The long message has its reply, or is not wanted any more: the next one may come.
  void end_long_message() {
    if (web()->long_message.lock().get() != this) return;
    web()->long_message.reset();
    patience_.cancel();
    while (!web()->want_long_message.empty()) {
      const auto next = web()->want_long_message.front().lock();
      web()->want_long_message.pop_front();
      if (next != nullptr && next->number_ > 0 && next->may_be_long()) return next->read();
    }
  }

  void on_message() {
    patience_.cancel();
    std::string message = beast::buffers_to_string(buffer_.data());
    buffer_ = {};  // a long message does not keep its memory
    ++asked_;
    asked_bytes_ += message.size();
    web()->engine.receive(number_, std::move(message));
    if (asked_ < kMostAsked && asked_bytes_ < kMostAskedTogether) return read();
    paused_ = true;
  }

  void on_answered() {
    --asked_;
    if (asked_ == 0) {
      asked_bytes_ = 0;
      end_long_message();
    }
    if (!paused_ || asked_ > kMostAsked / 2 || asked_bytes_ >= kMostAskedTogether) return;
    paused_ = false;
    if (number_ > 0) read();
  }

  void put(Waiting next) {
    if (number_ < 0) return;
    waiting_ += next.text->size();
    own_ += next.own;
    web()->waiting += next.own;
    texts_.push_back(std::move(next));
    // Nobody reads at the other end.
    if (waiting_ > kMostWaiting) return drop();
    if (web()->waiting > kMostWaitingOfAll) drop_worst();
    write();
  }

  /// Ends the connection with the most replies that nobody takes.
  void drop_worst() {
    std::shared_ptr<WebClient> worst;
    for (const auto& peer : web()->peers.connected())
      if (const auto client = std::dynamic_pointer_cast<WebClient>(peer))
        if (worst == nullptr || client->own_ > worst->own_) worst = client;
    if (worst != nullptr) worst->drop();
  }

  void write() {
    if (writing_ || number_ <= 0) return;
    // Texts go first, then the newest frame, then the close.
    std::shared_ptr<const std::string> next;
    if (!texts_.empty()) {
      next = std::move(texts_.front().text);
      const std::size_t own = texts_.front().own;
      texts_.pop_front();
      waiting_ -= next->size();
      own_ -= own;
      web()->waiting -= own;
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
                          if (error) return self->leave();
                          self->write();
                        });
  }

  void leave() {
    if (number_ < 0) return;
    web()->engine.remove_client(number_);
    number_ = -1;
    web()->waiting -= std::exchange(own_, 0);
    texts_.clear();
    frame_.reset();
    end_long_message();
  }

  websocket::stream<tcp::socket> stream_;
  beast::flat_buffer buffer_;
  int number_ = 0;               // of the engine; -1: gone
  asio::steady_timer patience_;  // with a long message
  std::size_t asked_ = 0, asked_bytes_ = 0, waiting_ = 0, own_ = 0;
  bool paused_ = false, writing_ = false, finishing_ = false;
  std::deque<Waiting> texts_;
  std::shared_ptr<const std::string> frame_;  // the latest
};

/// A connection that asks for files, until it becomes a WebSocket.
class WebConnection final : public WebPeer, public std::enable_shared_from_this<WebConnection> {
 public:
  /// Drops the oldest connection if there are too many: it may never send a request.
  WebConnection(tcp::socket socket, std::shared_ptr<Web> its_web)
      : WebPeer(std::move(its_web)), stream_(std::move(socket)) {
    if (web()->files.size() >= kMostFileConnections) web()->files.front()->drop();
    place_ = web()->files.insert(web()->files.end(), this);
  }
  ~WebConnection() override { leave_place(); }

  void finish() override { drop(); }
  void drop() override {
    stream_.close();
    leave_place();
  }

  /// Reads until it is clear that HTTP is spoken; whoever speaks anything else is hung up on.
  void begin() {
    stream_.expires_after(kRequestTime);
    stream_.async_read_some(
        buffer_.prepare(kFirstPiece),
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
    // The browser that the program has opened shows its code once, in place of the token.
    if (!web()->once.empty() && same_token(question.target, web()->once)) {
      question.target = "/?token=" + web()->access.token;
      web()->once.clear();
    }
    const ServerAccess& access = web()->access;
    if (path_of(question) != "/ws" || !websocket::is_upgrade(request))
      return write(respond_to(access, web()->port, question,
                              [this](const std::string& id) { return web()->engine.mesh(id); }));
    if (auto refused = socket_refusal_of(access, web()->port, question))
      return write(*std::move(refused));
    stream_.expires_never();
    leave_place();
    const auto client = std::make_shared<WebClient>(stream_.release_socket(), web());
    web()->peers.add(client);
    client->accept(request);
  }

  void write(HttpResponse answer) {
    // The body is kept alive until it is written.
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
    // HEAD is told the length, and nothing else.
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

  void leave_place() {
    if (place_) web()->files.erase(*std::exchange(place_, std::nullopt));
  }

  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  std::optional<std::list<WebConnection*>::iterator> place_;
  std::optional<http::request_parser<http::string_body>> parser_;
};

}  // namespace

class WebServer::Network {
 public:
  Network(Engine& engine, const ServerAccess& access)
      : web_(std::make_shared<Web>(engine, access)),
        acceptor_(web_->context),
        pause_(web_->context) {
    try {
      const tcp::endpoint end(asio::ip::make_address(access.address),
                              static_cast<unsigned short>(access.port));
      acceptor_.open(end.protocol());
      acceptor_.set_option(asio::socket_base::reuse_address(true));
      acceptor_.bind(end);
      acceptor_.listen();
      web_->port = acceptor_.local_endpoint().port();
    } catch (const boost::system::system_error& error) {
      throw InputError(fmt::format("cannot listen at {}, port {}: {}; --port 0 takes a free one",
                                   access.address, access.port, error.code().message()));
    }
    opening_target_ = access.token.empty() ? "/" : "/?once=" + random_token();
    if (!access.token.empty()) web_->once = opening_target_;
    accept();
    thread_ = std::thread([this] { web_->context.run(); });
  }

  ~Network() {
    asio::steady_timer patience(web_->context);
    asio::post(web_->context, [&] {
      beast::error_code ignored;
      acceptor_.close(ignored);
      pause_.cancel();
      for (const auto& peer : web_->peers.connected()) peer->finish();
      // Connections that have not ended by then are cut off, and the thread has nothing left to do.
      patience.expires_after(kFarewell);
      patience.async_wait([this](beast::error_code) { drop_all(); });
    });
    thread_.join();
  }

  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  [[nodiscard]] int port() const { return web_->port; }
  [[nodiscard]] const std::string& opening_target() const { return opening_target_; }

 private:
  void drop_all() {
    for (const auto& peer : web_->peers.connected()) peer->drop();
  }

  void accept() {
    acceptor_.async_accept([this](beast::error_code error, tcp::socket socket) {
      if (!acceptor_.is_open()) return;
      if (!error) {
        const auto connection = std::make_shared<WebConnection>(std::move(socket), web_);
        web_->peers.add(connection);
        connection->begin();
      }
      if (!error) return accept();
      // No file is left for a connection: it is tried again in a while.
      pause_.expires_after(std::chrono::milliseconds(50));
      pause_.async_wait([this](beast::error_code stopped) {
        if (!stopped) accept();
      });
    });
  }

  std::shared_ptr<Web> web_;
  std::string opening_target_;
  tcp::acceptor acceptor_;
  asio::steady_timer pause_;
  std::thread thread_;
};

WebServer::WebServer(Engine& engine, const ServerAccess& access)
    : network_(std::make_unique<Network>(engine, access)) {}

WebServer::~WebServer() = default;

int WebServer::port() const { return network_->port(); }

std::string WebServer::opening_target() const { return network_->opening_target(); }

}  // namespace thenar
