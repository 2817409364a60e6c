#include "ew/measurement/measurement_list.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "measurement/calipers.h"

namespace ew::measurement::measurement_list_test {
namespace {

using nlohmann::json;
using test::caliper;
using test::oneOfEachKind;

/// Drags one point of a caliper, as whoever draws it does.
bool moveHandle(MeasurementList& list, int number, Handle handle, glm::dvec2 to, Change change = Change::begins) {
  const Measurement* found = list.now().find(number);
  if (found == nullptr) return false;
  Caliper caliper = found->caliper;
  caliper.parts[handle.part].points[handle.point] = to;
  return list.setCaliper(number, std::move(caliper), change);
}

TEST(MeasurementList, NumbersWhatIsMeasuredAndNeverGivesANumberTwice) {
  MeasurementList list;
  EXPECT_EQ(list.add(caliper(CaliperKind::distance, {{0, 0}, {1, 0}}), "BPD", "BPD"), 1);
  EXPECT_EQ(list.add(caliper(CaliperKind::distance, {{0, 0}, {2, 0}})), 2);
  EXPECT_TRUE(list.remove(2));
  EXPECT_FALSE(list.remove(2));
  EXPECT_EQ(list.add(caliper(CaliperKind::distance, {{0, 0}, {3, 0}})), 3);
  EXPECT_TRUE(list.clear());
  EXPECT_FALSE(list.clear());
  EXPECT_EQ(list.add(caliper(CaliperKind::distance, {{0, 0}, {3, 0}})), 4);
}

TEST(MeasurementList, MovesOneHandleAndTheValueFollows) {
  MeasurementList list;
  const int number = list.add(caliper(CaliperKind::distance, {{0, 0}, {30, 0}}));
  EXPECT_TRUE(moveHandle(list, number, {0, 1}, {30, 40}));
  EXPECT_DOUBLE_EQ(measure(list.now().find(number)->caliper)->figures[0].quantity.value, 50.0);
  EXPECT_FALSE(list.setCaliper(number + 1, caliper(CaliperKind::distance, {{0, 0}, {1, 0}})));
}

TEST(MeasurementList, TakesADragBackInOneStep) {
  MeasurementList list;
  const int number = list.add(caliper(CaliperKind::distance, {{0, 0}, {30, 0}}));
  const auto before = list.kept();
  moveHandle(list, number, {0, 1}, {31, 0}, Change::begins);
  for (int n = 0; n < 20; ++n) moveHandle(list, number, {0, 1}, {31.0 + n, 0}, Change::goesOn);
  const auto after = list.kept();
  EXPECT_TRUE(list.undo());
  EXPECT_EQ(list.now(), *before);
  EXPECT_TRUE(list.redo());
  EXPECT_EQ(list.now(), *after);
  EXPECT_FALSE(list.redo());
}

TEST(MeasurementList, ForgetsWhatWasTakenBackWhenSomethingNewIsDone) {
  MeasurementList list;
  const int first = list.add(caliper(CaliperKind::distance, {{0, 0}, {1, 0}}));
  list.rename(first, "a");
  list.undo();
  list.rename(first, "b");
  EXPECT_FALSE(list.canRedo());
  EXPECT_EQ(list.now().find(first)->name, "b");
  EXPECT_TRUE(list.undo());
  EXPECT_TRUE(list.undo());
  EXPECT_TRUE(list.now().all.empty());
  EXPECT_FALSE(list.undo());
}

TEST(MeasurementList, KeepsStatesThatSomebodyShowsAsTheyAre) {
  MeasurementList list;
  const int number = list.add(caliper(CaliperKind::distance, {{0, 0}, {1, 0}}));
  const auto kept = list.kept();
  const Measurements copy = *kept;
  moveHandle(list, number, {0, 0}, {9, 9});
  list.remove(number);
  EXPECT_EQ(*kept, copy);
}

RC_GTEST_PROP(MeasurementList, GoesBackToEveryStateAndForthAgain, ()) {
  MeasurementList list;
  std::vector<std::shared_ptr<const Measurements>> states{list.kept()};
  const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 5));
  for (const int step : steps) {
    const int last = list.now().all.empty() ? 0 : list.now().all.back().number;
    const bool changed = step == 0   ? moveHandle(list, last, {0, 0}, {static_cast<double>(states.size()), 1})
                         : step == 1 ? list.rename(last, "n" + std::to_string(states.size()))
                         : step == 2 ? list.remove(last)
                                     : list.add(caliper(CaliperKind::distance, {{0, 0}, {1, 1}})) > 0;
    if (changed) states.push_back(list.kept());
  }
  for (std::size_t n = states.size(); n-- > 1;) {
    RC_ASSERT(list.now() == *states[n]);
    RC_ASSERT(list.undo());
  }
  RC_ASSERT(!list.undo());
  for (std::size_t n = 1; n < states.size(); ++n) {
    RC_ASSERT(list.redo());
    RC_ASSERT(list.now() == *states[n]);
  }
}

TEST(MeasurementList, FindsTheHandleUnderThePointer) {
  MeasurementList list;
  list.add(caliper(CaliperKind::distance, {{0, 0}, {10, 0}}));
  list.add({CaliperKind::ratio, {{0, {{0, 5}, {5, 5}}}, {1, {{0.2, 0}, {5, 9}}}}});
  const auto found = handleNear(list.now(), 0, {9.5, 0.5}, 2.0);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->number, 1);
  EXPECT_EQ(found->handle, (Handle{0, 1}));
  EXPECT_FALSE(handleNear(list.now(), 0, {7, 0}, 2.0));
  EXPECT_EQ(handleNear(list.now(), 1, {0, 0}, 2.0)->handle, (Handle{1, 0}));
}

Measurements everyKind(std::uint64_t seed) {
  MeasurementList list;
  for (Caliper& each : oneOfEachKind(seed)) list.add(std::move(each), "name", "ITEM", "left");
  list.rename(1, "");
  list.assign(2, "");
  return list.now();
}

RC_GTEST_PROP(MeasurementJson, GivesBackEveryMeasurementToTheLastBit, ()) {
  const Measurements measurements = everyKind(*rc::gen::arbitrary<std::uint64_t>());
  const auto again = measurementsFromJson(json::parse(toJson(measurements).dump()), verbatim("m.json"));
  RC_ASSERT(again.has_value());
  RC_ASSERT(*again == measurements);
}

TEST(MeasurementJson, RefusesEachBadFieldInItsSentence) {
  const json good = toJson(everyKind(1));
  const auto sentence = [&](const std::string& patch) {
    const auto read = measurementsFromJson(good.patch(json::parse(patch)), verbatim("m.json"));
    return read ? std::string("read") : read.error().sentence();
  };
  EXPECT_EQ(sentence("[]"), "read");
  EXPECT_EQ(sentence(R"([{"op": "replace", "path": "/format", "value": 2}])"),
            "m.json has format 2, this program reads up to 1; update EchoWeave.");
  EXPECT_EQ(sentence(R"([{"op": "remove", "path": "/format"}])"),
            "'format' in m.json is missing; it must be a whole number from 1 to 1000000.");
  EXPECT_EQ(sentence(R"([{"op": "replace", "path": "/measurements/0/number", "value": 2}])"),
            "'measurements[1].number' in m.json is 2; it must be a number that no other measurement has.");
  EXPECT_EQ(sentence(R"([{"op": "replace", "path": "/measurements/0/number", "value": 99}])"),
            "'measurements[0].number' in m.json is 99; it must be a whole number from 1 to below next_number.");
  EXPECT_EQ(sentence(R"([{"op": "replace", "path": "/measurements/0/parts/0/points/1", "value": [1]}])"),
            "'measurements[0].parts[0].points[1]' in m.json is [1]; it must be two numbers, a point.");
  EXPECT_EQ(sentence(R"([{"op": "remove", "path": "/measurements/0/parts/0/points/1"}])"),
            "'measurements[0].parts[0].points' in m.json is a list of 1; it must be a list of 2 to 2 points.");
  EXPECT_TRUE(sentence(R"([{"op": "replace", "path": "/measurements/0/kind", "value": "guess"}])")
                  .starts_with("'measurements[0].kind' in m.json is \"guess\"; it must be a kind of caliper: distance, "));
  EXPECT_EQ(sentence(R"([{"op": "replace", "path": "/measurements/0/side", "value": "top"}])"),
            "'measurements[0].side' in m.json is \"top\"; it must be \"\", \"right\" or \"left\".");
  EXPECT_EQ(sentence(R"([{"op": "add", "path": "/measurements/0/colour", "value": 1}])"),
            "'measurements[0].colour' in m.json is not known here; it must be one of number, name, item, side, kind, cycles, parts.");
  EXPECT_EQ(sentence(R"([{"op": "add", "path": "/measurements/0/cycles", "value": 21}])"),
            "'measurements[0].cycles' in m.json is 21; it must be a whole number from 1 to 20.");
}

}  // namespace
}  // namespace ew::measurement::measurement_list_test
