#include "ew/ui_test_door/case_preparation.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <chrono>
#include <thread>

#include "library/small_case.h"
#include "library/temporary_folder.h"
#include "time_limit.h"

namespace ew::ui::case_preparation_test {
namespace {

using test::EnvironmentValue;
using test::TemporaryFolder;

class PreparationInTheBackground : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"one", "two"}) {
      test::makeSmallCase(folder_ / name);
      auto manifest = nlohmann::json::parse(test::textOf(folder_ / name / "case.json"));
      manifest["id"] = name;
      test::writeText(folder_ / name / "case.json", manifest.dump());
    }
    // Another patient: otherwise the second case is ready with the first.
    auto sweep = nlohmann::json::parse(test::textOf(folder_ / "two/sweeps/upper.json"));
    sweep["frames"] = 14;
    test::writeText(folder_ / "two/sweeps/upper.json", sweep.dump());
    cases_ = listCases(folder_.path()).cases;
    ASSERT_EQ(cases_.size(), 2u);
  }
  template <class Condition>
  static bool waitUntil(const Condition& condition) {
    QElapsedTimer clock;
    clock.start();
    while (!condition()) {
      if (static_cast<double>(clock.elapsed()) > test::kPatience_ms) return false;
      QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }
  [[nodiscard]] const Case& named(const std::string& id) const { return cases_[0].id == id ? cases_[0] : cases_[1]; }

  TemporaryFolder folder_;
  EnvironmentValue cache_{"ECHOWEAVE_CACHE", folder_ / "cache"};
  std::vector<Case> cases_;

 private:
  int argc_ = 1;
  char name_[5] = "prep";
  char* argv_[2] = {name_, nullptr};
  QCoreApplication application_{argc_, argv_};
};

TEST_F(PreparationInTheBackground, MakesOneCaseAfterTheOtherTheQuickerOneFirst) {
  Jobs jobs;
  CasePreparation preparation(jobs, nullptr, 0);  // whatever else runs on the machine of the test
  std::vector<std::string> order;
  QObject::connect(&preparation, &CasePreparation::prepared, [&](const QString& id) { order.push_back(id.toStdString()); });
  preparation.start(cases_);
  EXPECT_FALSE(jobs.isRunning()) << "nobody waits for it";
  EXPECT_EQ(jobs.seen().size(), 1u) << "one at a time";
  EXPECT_EQ(preparation.seen(named("one")).state, CasePreparation::State::running);
  EXPECT_EQ(preparation.seen(named("two")).state, CasePreparation::State::waiting);
  EXPECT_GT(preparation.seen(named("two")).estimate_s, 0.0);
  ASSERT_TRUE(waitUntil([&] { return preparation.isIdle(); }));
  EXPECT_EQ(order, (std::vector<std::string>{"one", "two"}));
  for (const Case& each : cases_) EXPECT_EQ(preparation.seen(each).state, CasePreparation::State::ready);
}

TEST_F(PreparationInTheBackground, CancelMeansNotNowForAllThatNobodyAskedFor) {
  Jobs jobs;
  CasePreparation preparation(jobs, nullptr, 0);  // whatever else runs on the machine of the test
  preparation.start(cases_);
  jobs.cancel(jobs.seen().front().id);
  ASSERT_TRUE(waitUntil([&] { return preparation.isIdle(); }));
  for (const char* each : {"one", "two"}) EXPECT_EQ(preparation.seen(named(each)).state, CasePreparation::State::stopped) << each;
  preparation.start(cases_);
  EXPECT_TRUE(preparation.isIdle()) << "stopped is stopped";
  preparation.ask(named("two"));
  ASSERT_TRUE(waitUntil([&] { return preparation.isIdle(); }));
  EXPECT_EQ(preparation.seen(named("two")).state, CasePreparation::State::ready) << "until somebody wants it";
  EXPECT_EQ(preparation.seen(named("one")).state, CasePreparation::State::stopped);
}

TEST_F(PreparationInTheBackground, WhatIsAskedForGoesFirstAndThrowsNothingAway) {
  Jobs jobs;
  CasePreparation preparation(jobs, nullptr, 0);  // whatever else runs on the machine of the test
  std::vector<std::string> order;
  QObject::connect(&preparation, &CasePreparation::prepared, [&](const QString& id) { order.push_back(id.toStdString()); });
  preparation.start(cases_);  // "one" is at work
  preparation.ask(named("two"));
  EXPECT_TRUE(preparation.isAskedFor("two"));
  ASSERT_TRUE(waitUntil([&] { return preparation.isIdle(); }));
  EXPECT_EQ(order, (std::vector<std::string>{"two", "one"}));
}

TEST_F(PreparationInTheBackground, ASecondWishWaitsForTheFirst) {
  Jobs jobs;
  CasePreparation preparation(jobs, nullptr, 0);  // whatever else runs on the machine of the test
  std::vector<std::string> order;
  QObject::connect(&preparation, &CasePreparation::prepared, [&](const QString& id) { order.push_back(id.toStdString()); });
  preparation.ask(named("two"));
  preparation.ask(named("one"));
  EXPECT_EQ(preparation.seen(named("two")).state, CasePreparation::State::running);
  ASSERT_TRUE(waitUntil([&] { return preparation.isIdle(); }));
  EXPECT_EQ(order, (std::vector<std::string>{"two", "one"}));
}

TEST_F(PreparationInTheBackground, TheOneWhoseDraftIsOnShowGoesFirst) {
  Jobs jobs;
  CasePreparation preparation(jobs, nullptr, 0);  // whatever else runs on the machine of the test
  std::vector<std::string> order;
  QObject::connect(&preparation, &CasePreparation::prepared, [&](const QString& id) { order.push_back(id.toStdString()); });
  preparation.ask(named("one"));
  EXPECT_EQ(preparation.seen(named("one")).state, CasePreparation::State::running);
  preparation.askForShown(named("two"));
  ASSERT_TRUE(waitUntil([&] { return preparation.isIdle(); }));
  EXPECT_EQ(order, (std::vector<std::string>{"two", "one"})) << "and what was under way goes on behind it";
}

TEST_F(PreparationInTheBackground, IsHeldBesideAnAuthorsWorkUnlessSomebodyWantsACase) {
  Jobs jobs;
  CasePreparation preparation(jobs, nullptr, 0);  // whatever else runs on the machine of the test
  preparation.hold(true);
  preparation.start(cases_);
  EXPECT_TRUE(jobs.seen().empty());
  EXPECT_EQ(preparation.seen(named("one")).state, CasePreparation::State::waiting);
  preparation.ask(named("one"));
  ASSERT_TRUE(waitUntil([&] { return jobs.seen().empty(); }));
  EXPECT_EQ(preparation.seen(named("one")).state, CasePreparation::State::ready);
  EXPECT_EQ(preparation.seen(named("two")).state, CasePreparation::State::waiting);
  preparation.hold(false);
  ASSERT_TRUE(waitUntil([&] { return preparation.isIdle(); }));
  EXPECT_EQ(preparation.seen(named("two")).state, CasePreparation::State::ready);
}

TEST(AboutMinutes, TellsAPersonNoMoreThanCanBeKnown) {
  EXPECT_EQ(aboutMinutes(3.0), "less than a minute");
  EXPECT_EQ(aboutMinutes(182.0), "about 4 minutes");
  EXPECT_EQ(aboutMinutes(1431.0), "about 25 minutes");
}

TEST_F(PreparationInTheBackground, GivesTheMachineAwayAndGoesOnAfterwards) {
  Jobs jobs;
  CasePreparation preparation(jobs, nullptr, 0);  // whatever else runs on the machine of the test
  preparation.start(cases_);
  preparation.pause();
  ASSERT_TRUE(waitUntil([&] { return jobs.seen().empty(); }));
  EXPECT_EQ(preparation.seen(named("one")).state, CasePreparation::State::waiting);
  preparation.resume();
  ASSERT_TRUE(waitUntil([&] { return preparation.isIdle(); }));
  for (const Case& each : cases_) EXPECT_EQ(preparation.seen(each).state, CasePreparation::State::ready);
}

}  // namespace
}  // namespace ew::ui::case_preparation_test
