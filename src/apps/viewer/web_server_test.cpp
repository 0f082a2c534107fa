#include "apps/viewer/web_server.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "apps/viewer/testing/web_client.h"

namespace ajar::viewer {
namespace {

using testing::HttpAnswer;
using testing::send_request;
using testing::WebClient;

constexpr std::array<ServedFile, 2> kFiles = {ServedFile{"index.html", "<!doctype html>"},
                                              ServedFile{"viewer.js", "let it = 1;"}};

class WebServerTest : public ::testing::Test, public WebServer::Listener {
 protected:
  WebServerTest() : server_({.token = "secret", .files = kFiles, .log = {}}, *this) {}

  void opened(PageId page) override {
    const std::lock_guard lock(mutex_);
    page_ = page;
    ++opened_;
    changed_.notify_all();
  }
  void text(PageId /*page*/, std::string_view message) override { note(message); }
  void binary(PageId /*page*/, std::string_view message) override { note(message); }
  void closed(PageId /*page*/) override {
    const std::lock_guard lock(mutex_);
    ++closed_;
    changed_.notify_all();
  }
  void note(std::string_view message) {
    const std::lock_guard lock(mutex_);
    messages_.emplace_back(message);
    changed_.notify_all();
  }
  template <typename Holds>
  bool waits_until(Holds holds) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(20), holds);
  }
  std::string origin() const { return fmt::format("http://127.0.0.1:{}", server_.port()); }
  HttpAnswer get(const std::string& target, const std::string& host = "localhost") const {
    return send_request(server_.port(),
                        fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\n\r\n", target, host));
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> messages_;
  PageId page_ = 0;
  int opened_ = 0, closed_ = 0;
  WebServer server_;
};

TEST_F(WebServerTest, GivesItsFilesAloneWithAPolicy) {
  const HttpAnswer page = get("/");
  EXPECT_EQ(page.status, 200U);
  EXPECT_NE(page.text.find("<!doctype html>"), std::string::npos);
  EXPECT_NE(page.text.find("Content-Security-Policy: default-src 'none'"), std::string::npos);
  EXPECT_EQ(get("/viewer.js").status, 200U);
  for (const char* target : {"/viewer.css", "/../../etc/passwd", "/%2e%2e/secret", "viewer.js",
                             "//viewer.js", "http://localhost/viewer.js"}) {
    EXPECT_EQ(get(target).status, 404U) << target;
  }
}

TEST_F(WebServerTest, RefusesNamesThatAreNotItsOwn) {
  EXPECT_EQ(get("/", "evil.example").status, 421U);
  EXPECT_EQ(get("/", "").status, 421U);
  EXPECT_EQ(send_request(server_.port(), "POST / HTTP/1.1\r\nHost: localhost\r\n\r\n").status,
            405U);
}

TEST_F(WebServerTest, RefusesSocketsOfOtherPages) {
  for (const char* origin : {"http://evil.example", "null", ""}) {
    EXPECT_ANY_THROW(WebClient(server_.port(), origin)) << origin;
  }
}

TEST_F(WebServerTest, ClosesSocketsWithoutTheToken) {
  for (const char* first :
       {"", "{}", "[]", "nonsense", R"({"type":"hello"})", R"({"type":"hello","token":7})",
        R"({"type":"hello","token":"secre"})", R"({"type":"pause","token":"secret"})",
        R"({"type":{"type":"hello"},"token":"secret"})"}) {
    WebClient client(server_.port(), origin());
    client.send_text(first);
    EXPECT_FALSE(client.receive()) << first;
  }
  WebClient client(server_.port(), origin());
  client.send_binary(R"({"type":"hello","token":"secret"})");
  EXPECT_FALSE(client.receive());
  EXPECT_EQ(opened_, 0);
}

TEST_F(WebServerTest, CarriesMessagesBothWays) {
  WebClient client(server_.port(), origin());
  client.send_text(R"({"type":"hello","token":"secret"})");
  ASSERT_TRUE(waits_until([this] { return opened_ == 1; }));
  client.send_text("one");
  client.send_binary("two");
  ASSERT_TRUE(waits_until([this] { return messages_.size() == 2; }));
  EXPECT_EQ(messages_, (std::vector<std::string>{"one", "two"}));
  server_.send_text(page_, "three");
  server_.send_binary(page_, "four");
  EXPECT_EQ(client.receive()->bytes, "three");
  const auto last = client.receive();
  EXPECT_EQ(last->bytes, "four");
  EXPECT_FALSE(last->is_text);
  server_.close(page_);
  EXPECT_FALSE(client.receive());
  EXPECT_TRUE(waits_until([this] { return closed_ == 1; }));
}

TEST_F(WebServerTest, DropsTextsThatAreTooLong) {
  WebClient client(server_.port(), origin());
  client.send_text(R"({"type":"hello","token":"secret"})");
  client.send_text(std::string(100'000, 'x'));
  client.send_text("short");
  ASSERT_TRUE(waits_until([this] { return !messages_.empty(); }));
  EXPECT_EQ(messages_.front(), "short");
}

TEST_F(WebServerTest, ClosesAPageThatNeverReads) {
  WebClient client(server_.port(), origin());
  client.send_text(R"({"type":"hello","token":"secret"})");
  ASSERT_TRUE(waits_until([this] { return opened_ == 1; }));
  const std::string large(1 << 20, 'x');
  for (int i = 0; i < 100; ++i) server_.send_text(page_, large, 1);
  for (int i = 0; i < 3000; ++i) server_.send_text(page_, "note");
  EXPECT_TRUE(waits_until([this] { return closed_ == 1; }));
}

TEST_F(WebServerTest, ASecondServerOfItsPortIsRefused) {
  EXPECT_THROW(WebServer({.port = server_.port(), .token = "x", .files = {}, .log = {}}, *this),
               std::exception);
}

}  // namespace
}  // namespace ajar::viewer
