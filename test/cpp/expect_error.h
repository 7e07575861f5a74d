#pragma once
#include <gtest/gtest.h>

#include <string>

#include "telar/error.h"

namespace telar::test {

/// The code of the Error that a call ends with; what no Error has as its code when it ends without one.
template <class Call>
std::string codeThrown(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.code;
  }
  return "no Error";
}

}  // namespace telar::test

/// That a statement throws an Error of this code. EXPECT_THROW would take any: one thrown for another reason as well.
#define EXPECT_ERROR(statement, wanted) \
  EXPECT_EQ(::telar::test::codeThrown([&] { static_cast<void>(statement); }), wanted)
