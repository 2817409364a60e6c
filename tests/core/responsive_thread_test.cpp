#include "ew/core/responsive_thread.h"

#include <dlfcn.h>
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

TEST(ResponsiveThread, IsSeenByAPluginThatHasCoreInside) {
  void* const copy = ::dlopen(EW_COPY_OF_CORE, RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(copy, nullptr) << ::dlerror();
  const auto sees = reinterpret_cast<bool (*)()>(::dlsym(copy, "copySeesTheMark"));
  ASSERT_NE(sees, nullptr);
  EXPECT_FALSE(sees());
  {
    const ResponsiveThread mark;
    EXPECT_TRUE(sees());
    bool onWorker = true;
    std::thread([&] { onWorker = sees(); }).join();
    EXPECT_FALSE(onWorker);
  }
  EXPECT_FALSE(sees());
}

}  // namespace
}  // namespace ew::responsive_thread_test
