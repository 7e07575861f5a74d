#include "telar/cancel.h"

#include <gtest/gtest.h>

#include <thread>

namespace telar {
namespace {

using namespace std::chrono_literals;

std::string codeOf(const CancelToken& token) {
  try {
    token.check();
    return "";
  } catch (const Error& error) {
    return error.code;
  }
}

TEST(CancelToken, AllCopiesAreCancelled) {
  const CancelToken token;
  const CancelToken copy = token;
  EXPECT_EQ(codeOf(copy), "");
  token.cancel();
  EXPECT_EQ(codeOf(copy), "X_CANCELLED");
}

TEST(CancelToken, WorkTakesTheTimeThatIsAllowed) {
  const CancelToken token(20ms);
  const CancelToken::Work work(token);
  EXPECT_EQ(codeOf(token), "");
  std::this_thread::sleep_for(30ms);
  EXPECT_EQ(codeOf(token), "X_TIMEOUT");
}

TEST(CancelToken, WaitingTakesNone) {
  const CancelToken token(60ms);
  std::this_thread::sleep_for(80ms);
  const CancelToken::Work work(token);
  EXPECT_EQ(codeOf(token), "");
}

TEST(CancelToken, WorksShareTheirTime) {
  const CancelToken token(60ms);
  for (int i = 0; i < 2; ++i) {
    const CancelToken::Work work(token);
    EXPECT_EQ(codeOf(token), "");
    std::this_thread::sleep_for(40ms);
  }
  EXPECT_EQ(codeOf(token), "") << "nobody works";
  const CancelToken::Work work(token);
  EXPECT_EQ(codeOf(token), "X_TIMEOUT");
}

TEST(CancelToken, AnyTimeIsAllowedFromThenOn) {
  const CancelToken token(1ms);
  { const CancelToken::Work loading(token); }
  token.allowAnyTime();
  const CancelToken::Work work(token);
  std::this_thread::sleep_for(5ms);
  EXPECT_EQ(codeOf(token), "");
}

TEST(CancelToken, WhatTookTooLongSaysHowLongItMight) {
  const CancelToken token(50ms);
  const CancelToken::Work work(token);
  std::this_thread::sleep_for(60ms);
  try {
    token.check();
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("50 ms"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace telar
