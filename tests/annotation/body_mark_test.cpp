#include "ew/annotation/body_mark.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "ew/phantom/body_shape.h"
#include "places.h"

namespace ew::annotation::body_mark_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Placed = Transform<frame::World, frame::Probe>;

const fs::path kResources = fs::path(EW_SOURCE_DIR) / "resources";
const fs::path kFolder = kResources / "body_marks";
constexpr double kQuarter = std::numbers::pi / 2.0;
constexpr glm::dvec3 kLeft(1.0, 0.0, 0.0), kRight(-1.0, 0.0, 0.0), kFront(0.0, -1.0, 0.0), kBack(0.0, 1.0, 0.0), kHead(0.0, 0.0, 1.0);

const std::vector<BodyMark>& shipped() {
  static const std::vector<BodyMark> marks = [] {
    auto read = readBodyMarks(kFolder);
    EXPECT_TRUE(read) << read.error();
    return read ? std::move(*read) : std::vector<BodyMark>{};
  }();
  return marks;
}

/// A probe whose marked end and beam point where these say.
Placed probeAt(glm::dvec3 at_mm, glm::dvec3 marker, glm::dvec3 beam) {
  return {{glm::dvec4(marker, 0.0), glm::dvec4(beam, 0.0), glm::dvec4(glm::cross(marker, beam), 0.0), glm::dvec4(at_mm, 1.0)}};
}
/// The same, turned in place about an axis of its own.
Placed turned(const Placed& probe, double angle_rad, glm::dvec3 axis) { return {glm::rotate(probe.matrix, angle_rad, axis)}; }

std::string wordOf(MarkView view) {
  switch (view) {
    case MarkView::front:
      return "front";
    case MarkView::back:
      return "back";
    case MarkView::right:
      return "right";
    case MarkView::left:
      return "left";
  }
  return {};
}

BodyMark mark(MarkView view, double side_mm = 400.0) {
  BodyMark made;
  made.id = wordOf(view) + std::to_string(static_cast<int>(side_mm));
  made.view = view;
  made.centre_mm = {10.0, 0.0, -100.0};
  made.side_mm = side_mm;
  return made;
}

void expectGlyph(const std::optional<ProbeGlyph>& glyph, glm::dvec2 place, double angle_rad) {
  ASSERT_TRUE(glyph);
  EXPECT_NEAR(glyph->place.x, place.x, 1e-12);
  EXPECT_NEAR(glyph->place.y, place.y, 1e-12);
  EXPECT_NEAR(std::remainder(glyph->angle_rad - angle_rad, 4.0 * kQuarter), 0.0, 1e-9);
}

TEST(GlyphFor, ShowsThePatientsRightAtTheLeftOfTheDrawingOfTheFront) {
  const BodyMark front = mark(MarkView::front);
  // A quarter of the drawing to the patient's right of its middle and a quarter towards the feet.
  expectGlyph(glyphFor(front, probeAt({-90.0, -90.0, -200.0}, kRight, kBack)), {0.25, 0.75}, 2.0 * kQuarter);
  expectGlyph(glyphFor(front, probeAt({10.0, -90.0, -100.0}, kHead, kBack)), {0.5, 0.5}, -kQuarter);
  expectGlyph(glyphFor(front, probeAt({10.0, -90.0, -100.0}, kLeft, kBack)), {0.5, 0.5}, 0.0);
}

TEST(GlyphFor, SeesTheOtherSidesAsAPersonDoesWhoStandsThere) {
  // From the patient's right the front is at the right of the drawing, from the left at the left.
  expectGlyph(glyphFor(mark(MarkView::right), probeAt({-140.0, -100.0, -100.0}, kFront, kLeft)), {0.75, 0.5}, 0.0);
  expectGlyph(glyphFor(mark(MarkView::right), probeAt({-140.0, 0.0, 0.0}, kHead, kLeft)), {0.5, 0.25}, -kQuarter);
  expectGlyph(glyphFor(mark(MarkView::left), probeAt({140.0, -100.0, -100.0}, kFront, kRight)), {0.25, 0.5}, 2.0 * kQuarter);
  expectGlyph(glyphFor(mark(MarkView::back), probeAt({110.0, 100.0, -100.0}, kLeft, kFront)), {0.25, 0.5}, 2.0 * kQuarter);
}

TEST(GlyphFor, KeepsTheAngleOfAFaceThatIsTiltedOrRocked) {
  const BodyMark front = mark(MarkView::front);
  for (const double angle : {-1.2, -0.4, 0.3, 1.1}) {
    const Placed across = probeAt({10.0, -90.0, -100.0}, kRight, kBack), lengthwise = probeAt({10.0, -90.0, -100.0}, kHead, kBack);
    // Tilted about its face's long axis, and rocked about the axis across it.
    expectGlyph(glyphFor(front, turned(across, angle, {1.0, 0.0, 0.0})), {0.5, 0.5}, 2.0 * kQuarter);
    expectGlyph(glyphFor(front, turned(lengthwise, angle, {1.0, 0.0, 0.0})), {0.5, 0.5}, -kQuarter);
    expectGlyph(glyphFor(front, turned(across, angle, {0.0, 0.0, 1.0})), {0.5, 0.5}, 2.0 * kQuarter);
    expectGlyph(glyphFor(front, turned(lengthwise, angle, {0.0, 0.0, 1.0})), {0.5, 0.5}, -kQuarter);
  }
}

TEST(GlyphFor, FollowsTheRotationOfTheProbeAboutItsBeam) {
  // Seen in the direction of the beam, from +x over +y is clockwise where the drawing's y points down.
  const Placed across = probeAt({10.0, -90.0, -100.0}, kRight, kBack);
  for (const double angle : {0.1, 0.7, -0.5}) {
    const auto glyph = glyphFor(mark(MarkView::front), turned(across, angle, {0.0, 1.0, 0.0}));
    ASSERT_TRUE(glyph);
    const glm::dvec3 marker = turned(across, angle, {0.0, 1.0, 0.0}).matrix[0];
    EXPECT_NEAR(std::cos(glyph->angle_rad), marker.x, 1e-12);
    EXPECT_NEAR(std::sin(glyph->angle_rad), -marker.z, 1e-12);
  }
}

TEST(GlyphFor, UnrollsTheFlankOntoTheFront) {
  // Across on the right flank, the marker to the front: rolled to the front it points to the patient's left.
  const BodyMark front = mark(MarkView::front);
  expectGlyph(glyphFor(front, probeAt({-140.0, 0.0, -100.0}, kFront, kLeft)), {0.125, 0.5}, 0.0);
  expectGlyph(glyphFor(front, probeAt({-140.0, 0.0, -100.0}, kHead, kLeft)), {0.125, 0.5}, -kQuarter);
}

TEST(GlyphFor, ShowsNothingBesideTheDrawingNorOnTheFarSide) {
  const BodyMark front = mark(MarkView::front);
  EXPECT_FALSE(glyphFor(front, probeAt({-191.0, -90.0, -100.0}, kRight, kBack)));
  EXPECT_TRUE(glyphFor(front, probeAt({-189.0, -90.0, -100.0}, kRight, kBack)));
  EXPECT_FALSE(glyphFor(front, probeAt({10.0, -90.0, 101.0}, kRight, kBack)));
  EXPECT_FALSE(glyphFor(front, probeAt({10.0, 90.0, -100.0}, kRight, kFront))) << "on the back";
  const double justBehind = std::asin(-kFarSide);
  const Placed flank = probeAt({-140.0, 0.0, -100.0}, kHead, kLeft);
  EXPECT_TRUE(glyphFor(front, turned(flank, 0.01 - justBehind, {1.0, 0.0, 0.0})));
  EXPECT_FALSE(glyphFor(front, turned(flank, -0.01 - justBehind, {1.0, 0.0, 0.0})));
  Placed lost = flank;
  lost.matrix[3].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(glyphFor(front, lost));
}

TEST(MarkFor, TakesTheSideThatTheProbeFacesAndStaysThereOnTheOutline) {
  const std::vector<BodyMark> all{mark(MarkView::front), mark(MarkView::front, 800.0), mark(MarkView::right)};
  const auto offered = marksFor(all, {});
  ASSERT_EQ(offered.size(), 3u);
  const auto at = [](double angle) {  // around the trunk, from the front to the right
    return probeAt({-150.0 * std::sin(angle), -100.0 * std::cos(angle), -100.0}, kHead, {std::sin(angle), std::cos(angle), 0.0});
  };
  EXPECT_EQ(markFor(offered, at(0.1))->id, "front400") << "of two from the same side the one that shows less of the body";
  EXPECT_EQ(markFor(offered, at(1.4))->id, "right400");
  EXPECT_EQ(markFor(offered, at(0.82))->id, "right400");
  EXPECT_EQ(markFor(offered, at(0.82), "front400")->id, "front400") << "not clearly better";
  EXPECT_EQ(markFor(offered, at(1.0), "front400")->id, "right400");
  EXPECT_EQ(markFor(offered, at(0.75), "right400")->id, "right400");
  // Only the large one reaches there.
  EXPECT_EQ(markFor(offered, probeAt({10.0, -90.0, 150.0}, kHead, kBack))->id, "front800");
  // Nowhere to be seen: what is shown stays.
  const Placed behind = probeAt({0.0, 100.0, -100.0}, kHead, kFront);
  EXPECT_EQ(markFor(offered, behind)->id, "right400") << "on the outline";
  const std::vector<const BodyMark*> fronts{&all[0], &all[1]};
  EXPECT_EQ(markFor(fronts, behind, "front800")->id, "front800");
  EXPECT_EQ(markFor(fronts, behind)->id, "front400");
  EXPECT_EQ(markFor({}, behind), nullptr);
}

TEST(BodyMarks, OfTheProgramAreAllReadWithTheirDrawings) {
  for (const BodyMark& each : shipped()) {
    EXPECT_TRUE(fs::is_regular_file(each.drawing)) << each.id;
    for (const MarkVariant& variant : each.variants) EXPECT_EQ(each.drawingOf(variant.id), variant.drawing);
    EXPECT_EQ(each.drawingOf(""), each.drawing);
    EXPECT_EQ(each.drawingOf("no such variant"), each.drawing);
  }
  for (const char* id : {"abdomen", "aorta", "flank-left", "flank-right", "neck-front", "neck-left", "neck-right", "trunk", "womb"})
    EXPECT_NE(bodyMarkOf(shipped(), id), nullptr) << id;
  const BodyMark* womb = bodyMarkOf(shipped(), "womb");
  ASSERT_NE(womb, nullptr);
  std::vector<std::string> lies;
  for (const MarkVariant& variant : womb->variants) lies.push_back(variant.id);
  EXPECT_EQ(lies, (std::vector<std::string>{"cephalic", "breech", "transverse-head-right", "transverse-head-left"}));
}

struct ShippedCase {
  std::string id, region, mannequin;
  Placed start, expert;
};

std::vector<ShippedCase> cases() {
  std::vector<ShippedCase> all;
  for (const auto& entry : fs::directory_iterator(fs::path(EW_SOURCE_DIR) / "cases")) {
    if (!entry.is_directory()) continue;  // the course over all of them
    const json manifest = json::parse(std::ifstream(entry.path() / "case.json"));
    const auto pose = [&](const char* key) { return Placed{matrixFromRows(manifest[key].get<std::array<double, 16>>())}; };
    all.push_back(
        {manifest["id"], manifest["region"], fs::path(std::string(manifest["mannequin"])).stem(), pose("start_pose"), pose("expert_pose")});
  }
  return all;
}

TEST(BodyMarks, ShowStartAndExpertOfEveryShippedCase) {
  const std::map<std::string, std::pair<std::string, std::string>> expected{
      {"abdominal-aorta-aneurysm", {"abdomen", "abdomen"}}, {"fetal-biometry", {"womb", "womb"}},
      {"focused-trauma", {"trunk", "flank-right"}},         {"neck-carotid-thyroid", {"neck-front", "neck-front"}},
      {"upper-abdomen-gall-stone", {"abdomen", "abdomen"}}, {"liver-sweep-recorded", {"abdomen", "abdomen"}},
      {"upper-abdomen-normal", {"abdomen", "abdomen"}}};
  int seen = 0;
  for (const ShippedCase& each : cases()) {
    const auto offered = marksFor(shipped(), {each.region, each.mannequin});
    ASSERT_TRUE(expected.contains(each.id)) << each.id;
    const auto& [start, expert] = expected.at(each.id);
    EXPECT_EQ(markFor(offered, each.start)->id, start) << each.id;
    EXPECT_EQ(markFor(offered, each.expert)->id, expert) << each.id;
    // Start poses lie across on the middle of the body, the marker to the patient's right; where a recording was made, beside it.
    const auto glyph = glyphFor(*markFor(offered, each.start), each.start);
    ASSERT_TRUE(glyph) << each.id;
    const bool isRecorded = each.id == "liver-sweep-recorded";
    EXPECT_NEAR(glyph->place.x, isRecorded ? 0.37 : 0.5, 0.02) << each.id;
    EXPECT_NEAR(std::abs(glyph->angle_rad), std::numbers::pi, isRecorded ? 0.5 : 1e-9) << each.id;
    EXPECT_TRUE(glyphFor(*markFor(offered, each.expert), each.expert)) << each.id;
    ++seen;
  }
  EXPECT_EQ(seen, 7);
}

TEST(BodyMarkReader, SaysWhatIsWrong) {
  const json whole = json::parse(std::ifstream(kFolder / "womb.json"));
  const auto sentence = [&](const json::json_pointer& at, const json& value) {
    json changed = whole;
    changed[at] = value;
    const auto read = bodyMarkFromJson(changed, "womb", kFolder, verbatim("womb.json"));
    return read ? std::string("taken") : read.error().sentence();
  };
  EXPECT_EQ(sentence("/format"_json_pointer, 2), "womb.json has format 2, this program reads up to 1; update EchoWeave.");
  EXPECT_EQ(sentence("/view"_json_pointer, "above"),
            "'view' in womb.json is \"above\"; it must be \"front\", \"back\", \"right\" or \"left\".");
  EXPECT_EQ(sentence("/drawing"_json_pointer, "../icons/undo.svg"),
            "'drawing' in womb.json is \"../icons/undo.svg\"; it must be the name of an SVG file in the folder of the mark.");
  EXPECT_EQ(sentence("/variants/1/drawing"_json_pointer, "nowhere.svg"),
            "'variants[1].drawing' in womb.json is \"nowhere.svg\"; it must be the name of an SVG file in the folder of the mark.");
  EXPECT_EQ(sentence("/variants/1/id"_json_pointer, "cephalic"),
            "'variants[1].id' in womb.json is \"cephalic\"; it must be an id that no other variant has.");
  EXPECT_EQ(sentence("/side_mm"_json_pointer, 0), "'side_mm' in womb.json is 0; it must be a number from 20 to 3000.");
}

/// The body of a mannequin, seen from the side of a mark: whether anything of it lies behind a place of the drawing.
class Silhouette {
 public:
  Silhouette(const BodyMark& mark, const std::string& mannequin) : mark_(mark) {
    auto shape = readBodyShape(kResources / "mannequin" / (mannequin + ".json"));
    EXPECT_TRUE(shape) << shape.error();
    if (shape) shape_ = std::move(*shape);
  }
  [[nodiscard]] bool covers(glm::dvec2 place) const {
    const bool isAcross = mark_.view == MarkView::front || mark_.view == MarkView::back;
    const double along = (place.x - 0.5) * mark_.side_mm, z = mark_.centre_mm.z - (place.y - 0.5) * mark_.side_mm;
    for (double depth_mm = -200.0; depth_mm <= 200.0; depth_mm += 8.0) {
      glm::dvec3 p(0.0, 0.0, z);
      if (isAcross)
        p = {mark_.centre_mm.x + (mark_.view == MarkView::front ? along : -along), depth_mm, z};
      else
        p = {depth_mm, mark_.centre_mm.y + (mark_.view == MarkView::right ? -along : along), z};
      if (shape_->signedDistance_mm(p) < 0.0) return true;
    }
    return false;
  }

 private:
  const BodyMark& mark_;
  std::unique_ptr<BodyShape> shape_;
};

TEST(BodyMarks, PutTheProbeOnTheBodyWhereverItTouchesTheSkin) {
  // Points of the skin around the trunk at several heights: seen from a side, they lie on the body that is seen there.
  const BodyMark& abdomen = *bodyMarkOf(shipped(), "abdomen");
  const Silhouette silhouette(abdomen, "adult");
  auto shape = readBodyShape(kResources / "mannequin" / "adult.json");
  ASSERT_TRUE(shape) << shape.error();
  int seen = 0;
  for (const double z : {0.0, -100.0, -200.0, -300.0})
    for (double angle = -1.5; angle <= 1.5; angle += 0.25) {
      // From the outside inwards, up to the skin.
      double radius_mm = 200.0;
      const glm::dvec3 outward(std::sin(angle), -std::cos(angle), 0.0);
      while (radius_mm > 0.0 && (*shape)->signedDistance_mm(radius_mm * outward + glm::dvec3(0.0, 0.0, z)) > 0.0) radius_mm -= 0.5;
      const glm::dvec3 skin = radius_mm * outward + glm::dvec3(0.0, 0.0, z);
      const auto glyph = glyphFor(abdomen, probeAt(skin, kHead, -outward));
      ASSERT_TRUE(glyph) << z << " " << angle;
      EXPECT_TRUE(silhouette.covers({0.5 + 0.97 * (glyph->place.x - 0.5), glyph->place.y})) << z << " " << angle;
      EXPECT_NEAR(std::remainder(glyph->angle_rad + kQuarter, 4.0 * kQuarter), 0.0, 1e-9) << "lengthwise stays lengthwise";
      ++seen;
    }
  EXPECT_EQ(seen, 4 * 13);
}

}  // namespace
}  // namespace ew::annotation::body_mark_test
