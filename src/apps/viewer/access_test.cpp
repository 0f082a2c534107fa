#include "apps/viewer/access.h"

#include <gtest/gtest.h>

namespace ajar::viewer {
namespace {

TEST(ViewerAccess, TokensAreLongAndNeverTheSame) {
  const std::string token = make_token();
  EXPECT_EQ(token.size(), 32U);
  EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(token, make_token());
}

TEST(ViewerAccess, OnlyTheTokenItselfOpens) {
  const std::string token = make_token();
  EXPECT_TRUE(is_token(token, token));
  EXPECT_FALSE(is_token(token, ""));
  EXPECT_FALSE(is_token(token, token + "0"));
  for (std::size_t i = 0; i < token.size(); ++i) {
    std::string other = token;
    other[i] = other[i] == '0' ? '1' : '0';
    EXPECT_FALSE(is_token(token, other)) << i;
  }
}

TEST(ViewerAccess, NamesOfOthersAreRefused) {
  for (const char* host :
       {"localhost", "localhost:8000", "127.0.0.1:1", "[::1]:9000", "10.0.0.7"}) {
    EXPECT_TRUE(is_own_host(host, "")) << host;
  }
  for (const char* host : {"", "evil.example", "localhost.evil.example:80",
                           "127.0.0.1.evil.example", "studio:80", "[evil]:80", "[", ":80"}) {
    EXPECT_FALSE(is_own_host(host, "")) << host;
  }
  EXPECT_TRUE(is_own_host("studio:80", "studio"));
}

TEST(ViewerAccess, OnlyTheOwnPageOpensSockets) {
  EXPECT_TRUE(is_own_origin("http://localhost:8000", "localhost:8000"));
  for (const char* origin : {"", "null", "http://localhost", "http://localhost:8001",
                             "http://evil.example", "localhost:8000", "file://localhost:8000"}) {
    EXPECT_FALSE(is_own_origin(origin, "localhost:8000")) << origin;
  }
}

}  // namespace
}  // namespace ajar::viewer
