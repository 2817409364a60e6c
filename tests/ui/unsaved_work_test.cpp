#include "ew/ui_test_door/unsaved_work.h"

#include <gtest/gtest.h>

#include <utility>

namespace ew::ui::unsaved_work_test {
namespace {

struct Asked {
  std::vector<std::string> names;
  UnsavedWork work;
  void add(const std::string& name, std::vector<Loss> lostWith, bool isUnsaved, bool mayGo) {
    work.add({name, std::move(lostWith), [isUnsaved] { return isUnsaved; },
              [this, name, mayGo](Loss, const std::string& next) {
                names.push_back(name + ":" + next);
                return mayGo;
              }});
  }
};

TEST(UnsavedWork, AsksEveryHolderThatWouldLoseSomethingInTheirOrder) {
  Asked asked;
  asked.add("case", {Loss::opening, Loss::closing}, true, true);
  asked.add("images", {Loss::scan, Loss::opening, Loss::closing}, true, true);
  asked.add("saved", {Loss::scan, Loss::opening, Loss::closing}, false, false);
  EXPECT_TRUE(asked.work.mayLose(Loss::scan, "knee"));
  EXPECT_EQ(asked.names, std::vector<std::string>{"images:knee"});
  EXPECT_TRUE(asked.work.mayLose(Loss::opening, "hip"));
  EXPECT_EQ(asked.names, (std::vector<std::string>{"images:knee", "case:hip", "images:hip"}));
  EXPECT_EQ(asked.work.heldAgainst(Loss::closing), (std::vector<std::string>{"case", "images"}));
}

TEST(UnsavedWork, StopsAskingAtTheFirstThatStays) {
  Asked asked;
  asked.add("first", {Loss::closing}, true, false);
  asked.add("second", {Loss::closing}, true, true);
  EXPECT_FALSE(asked.work.mayLose(Loss::closing, {}));
  EXPECT_EQ(asked.names, std::vector<std::string>{"first:"});
}

TEST(UnsavedWork, LetsGoWhatNobodyHolds) {
  Asked asked;
  EXPECT_TRUE(asked.work.mayLose(Loss::closing, {}));
  asked.add("case", {Loss::opening}, true, false);
  EXPECT_TRUE(asked.work.mayLose(Loss::scan, {}));
  EXPECT_TRUE(asked.names.empty());
}

}  // namespace
}  // namespace ew::ui::unsaved_work_test
