#include "server/http/admission.hpp"

#include <gtest/gtest.h>

namespace pentapost::server {
namespace {

TEST(Admission, GivesTicketsUpToTheBoundAndTakesThemBack) {
  Admission admission{1, 1};
  auto first = admission.enter();
  {
    const auto second = admission.enter();
    EXPECT_TRUE(first && second);
    EXPECT_FALSE(admission.enter());
  }
  EXPECT_TRUE(admission.enter());
}

TEST(Admission, DoesNotGiveAMovedTicketBackTwice) {
  Admission admission{1, 0};
  {
    auto ticket = admission.enter();
    const auto moved = std::move(*ticket);
  }
  const auto ticket = admission.enter();
  EXPECT_TRUE(ticket);
  EXPECT_FALSE(admission.enter());
}

}  // namespace
}  // namespace pentapost::server
