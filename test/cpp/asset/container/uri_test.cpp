#include "asset/container/uri.h"

#include <gtest/gtest.h>

#include "asset/model_builder.h"

namespace telar::asset {
namespace {

std::string outcome(std::string_view uri) {
  try {
    return relativePath(uri, "/x");
  } catch (const Error& error) {
    return error.code;
  }
}

TEST(Uri, RelativePathsAreDecodedOnce) {
  EXPECT_EQ(outcome("wool.png"), "wool.png");
  EXPECT_EQ(outcome("./a/wool%20blue.png"), "./a/wool blue.png");
  EXPECT_EQ(outcome("100%.png"), "100%.png");
  EXPECT_EQ(outcome("a%2525.png"), "a%25.png");
  EXPECT_EQ(outcome("na\xc3\xafve..bin"), "na\xc3\xafve..bin");
  EXPECT_EQ(outcome(""), "E_URI_MISSING");
}

TEST(Uri, WhatLeavesTheFolderIsDenied) {
  for (const char* uri : {"/etc/passwd",
                          "../x",
                          "a/../../x",
                          "..",
                          "%2e%2e/x",
                          "%2e%2e%2fx",
                          "%252e%252e%252fx",
                          "file:///etc/passwd",
                          "FILE:/x",
                          "http://127.0.0.1/x",
                          "gopher://h/x",
                          "javascript:alert(1)",
                          "C:/x",
                          "..\\x",
                          "a%5c..%5cx",
                          "%2fetc/passwd",
                          "a%00.png",
                          "a\nb",
                          "//host/share",
                          "$HOME/x",
                          "~root/x",
                          "blob:null/1",
                          "x-y+z.1:foo"}) {
    EXPECT_EQ(outcome(uri), "E_URI_DENIED") << uri;
  }
}

TEST(Uri, DataUris) {
  const auto text = [](std::string_view uri) {
    try {
      const auto bytes = decodeDataUri(uri, "/x");
      return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    } catch (const Error& error) {
      return error.code;
    }
  };
  EXPECT_EQ(text("data:application/octet-stream;base64,d29vbA=="), "wool");
  EXPECT_EQ(text("data:;base64,d29vbA"), "wool");
  EXPECT_EQ(text("data:application/gltf-buffer;x=1;base64,d29v"), "woo");
  EXPECT_EQ(text("data:,w%6fol"), "wool");
  EXPECT_EQ(text("data:;base64,"), "");
  for (const char* uri : {"data:application/octet-stream;base64", "data:;base64,d29v b", "data:;base64,d29-",
                          "data:;base64,d29vb", "data:;base64,d=9v", "data:;base64,====", "data:text/html,x"}) {
    EXPECT_EQ(text(uri), "E_URI_DATA") << uri;
  }
}

TEST(Uri, Base64OfEveryLengthComesBack) {
  for (std::size_t size = 0; size < 70; ++size) {
    test::Bytes data(size);
    for (std::size_t i = 0; i < size; ++i) data[i] = static_cast<std::byte>(i * 37 + size);
    EXPECT_EQ(decodeDataUri("data:;base64," + test::base64(data), "/x"), data);
  }
}

}  // namespace
}  // namespace telar::asset
