#include "ew/core/responsive_thread.h"

#include <gtest/gtest.h>

#include <thread>

namespace ew::responsive_thread_test {
namespace {

TEST(ResponsiveThread, IsTheOneThatIsMarkedAsLongAsTheMarkLives) {
  EXPECT_FALSE(isResponsiveThread());
  {
    const ResponsiveThread mark;
    EXPECT_TRUE(isResponsiveThread());
    {
      const ResponsiveThread another;
      EXPECT_TRUE(isResponsiveThread());
    }
    EXPECT_TRUE(isResponsiveThread()) << "marks nest";
    bool isWorkerMarked = true;
    std::thread([&] { isWorkerMarked = isResponsiveThread(); }).join();
    EXPECT_FALSE(isWorkerMarked);
  }
  EXPECT_FALSE(isResponsiveThread());
}

}  // namespace
}  // namespace ew::responsive_thread_test
