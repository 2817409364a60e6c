#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "ew/core/frames.h"
#include "ew/trackers/paper_body.h"
#include "places.h"

namespace ew::marker_body_test {
namespace {

using nlohmann::json;

const std::filesystem::path kBodies = std::filesystem::path(EW_SOURCE_DIR) / "resources" / "marker_bodies";

PaperBody paper(const std::string& id) {
  const auto read = readPaperBody(kBodies / (id + ".json"));
  if (!read) throw std::runtime_error(read.error().sentence());
  return *read;
}

class MarkerBodyFile : public ::testing::Test {
 protected:
  void SetUp() override { folder_ = std::filesystem::path(::testing::TempDir()) / "ew_marker_body_test"; }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path write(const std::string& name, const json& document) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / name) << document;
    return folder_ / name;
  }
  static json shipped(const std::string& id) { return json::parse(std::ifstream(kBodies / (id + ".json"))); }
  std::string sentenceOf(const json& document) {
    const auto read = readPaperBody(write("body.json", document));
    return read ? "" : read.error().sentence();
  }
  std::filesystem::path folder_;
};

TEST(MarkerBodies, ShippedOnesAreReadAndShareNoMarker) {
  const auto papers = readPaperBodies({kBodies});
  ASSERT_TRUE(papers) << papers.error();
  std::set<std::string> ids;
  std::set<std::pair<std::string, int>> markers;
  for (const PaperBody& body : *papers) {
    ids.insert(body.id);
    for (const PaperPanel& panel : body.panels)
      for (const PaperMarker& marker : panel.markers)
        EXPECT_TRUE(markers.insert({body.dictionary, marker.id}).second) << body.id << marker.id;
  }
  EXPECT_EQ(ids, (std::set<std::string>{"box-40", "box-60", "calibration-board", "mannequin-board", "sleeve"}));
}

TEST(MarkerBodies, FoldedBoxIsACubeWithFiveMarkersWhoseNormalsLookOut) {
  const MarkerBody box = foldedBody(paper("box-60"));
  ASSERT_EQ(box.markers.size(), 5u);
  // From the four sides' middle the lid's lies 30 mm up; the mean of five lies a fifth of that above the cube's middle.
  const glm::dvec3 cube(0.0, -6.0, 0.0);
  std::set<std::array<int, 3>> directions;
  for (const Marker& marker : box.markers) {
    const auto& c = marker.corners_mm;
    const glm::dvec3 normal = glm::normalize(glm::cross(c[1] - c[0], c[0] - c[3]));
    const glm::dvec3 middle = 0.25 * (c[0] + c[1] + c[2] + c[3]) - cube;
    EXPECT_NEAR(glm::distance(middle, 30.0 * normal), 0.0, 1e-9) << marker.id;
    for (std::size_t n = 0; n < 4; ++n) EXPECT_NEAR(glm::distance(c[n], c[(n + 1) % 4]), 44.0, 1e-9);
    directions.insert(
        {static_cast<int>(std::round(normal.x)), static_cast<int>(std::round(normal.y)), static_cast<int>(std::round(normal.z))});
  }
  EXPECT_EQ(directions, (std::set<std::array<int, 3>>{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}}));
  EXPECT_TRUE(checkRigid(box.probeToTool));
  EXPECT_TRUE(box.faceIsExact);
  // The nose is 55 mm long below a cube whose lower side lies 36 mm below the origin.
  EXPECT_NEAR(glm::distance(glm::dvec3(box.probeToTool.matrix[3]), glm::dvec3(0.0, -91.0, 0.0)), 0.0, 0.01);
  EXPECT_NEAR(glm::distance(glm::dvec3(box.probeToTool.matrix[1]), glm::dvec3(0.0, -1.0, 0.0)), 0.0, 1e-5);
  EXPECT_NEAR(glm::distance(glm::dvec3(box.probeToTool.matrix[0]), glm::dvec3(1.0, 0.0, 0.0)), 0.0, 1e-9);
}

TEST(MarkerBodies, FoldingKeepsEveryPanelInShapeAndEveryFoldClosed) {
  for (const char* id : {"box-60", "box-40", "sleeve", "mannequin-board"}) {
    const PaperBody body = paper(id);
    for (const double folding : {0.0, 0.3, 1.0}) {
      const auto poses = panelPoses(body, folding);
      for (std::size_t n = 0; n < body.panels.size(); ++n) {
        EXPECT_TRUE(checkRigid(poses[n], 1e-9)) << id << n;
        const PaperPanel& panel = body.panels[n];
        if (panel.on < 0) continue;
        const auto parent = static_cast<std::size_t>(panel.on);
        const auto end = [&](std::size_t p, PaperEdge edge, std::size_t which) {
          return glm::dvec3(poses[p] * glm::dvec4(outlineOf(body.panels[p])[(static_cast<std::size_t>(edge) + which) % 4], 0.0, 1.0));
        };
        EXPECT_NEAR(glm::distance(end(n, panel.edge, 0), end(parent, panel.onEdge, 1)), 0.0, 1e-9) << id << panel.id;
        EXPECT_NEAR(glm::distance(end(n, panel.edge, 1), end(parent, panel.onEdge, 0)), 0.0, 1e-9) << id << panel.id;
      }
    }
    for (const glm::dmat4& pose : panelPoses(body, 0.0)) EXPECT_NEAR(pose[3].z, 0.0, 1e-12) << "the net is flat";
  }
}

TEST(MarkerBodies, ABodyPrintedTooSmallIsSmallerInEveryLength) {
  const MarkerBody exact = foldedBody(paper("box-60")), small = scaled(exact, 0.98);
  for (std::size_t n = 0; n < exact.markers.size(); ++n)
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_NEAR(glm::distance(small.markers[n].corners_mm[c], 0.98 * exact.markers[n].corners_mm[c]), 0.0, 1e-12);
  EXPECT_NEAR(small.probeToTool.matrix[3].y, 0.98 * exact.probeToTool.matrix[3].y, 1e-12);
  EXPECT_TRUE(checkRigid(small.probeToTool));
  const CalibrationBoard board = printedBoard(paper("calibration-board"), 0.98);
  EXPECT_DOUBLE_EQ(board.square_mm, 32.0 * 0.98);
  EXPECT_DOUBLE_EQ(board.marker_mm, 24.0 * 0.98);
}

TEST(MarkerBodies, ASleevesFaceIsSaidToBeAGuess) { EXPECT_FALSE(foldedBody(paper("sleeve")).faceIsExact); }

TEST_F(MarkerBodyFile, SaysWhatCannotBeFoldedSeenOrRead) {
  EXPECT_EQ(readPaperBody(folder_ / "no-such.json").error().code, ErrorCode::notFound);
  json body = shipped("box-60");
  body["panels"][5]["fold_deg"] = 30.0;
  EXPECT_NE(sentenceOf(body).find("lie "), std::string::npos) << "a fold that does not close: " << sentenceOf(body);
  body = shipped("box-60");
  body["panels"][1]["markers"][0]["id"] = 0;
  EXPECT_NE(sentenceOf(body).find("one panel only"), std::string::npos) << sentenceOf(body);
  body = shipped("box-60");
  body["panels"][1]["markers"][0]["side_mm"] = 58.0;
  EXPECT_NE(sentenceOf(body).find("white paper"), std::string::npos) << sentenceOf(body);
  body = shipped("box-60");
  body["panels"][1]["markers"][0]["id"] = 587;
  EXPECT_NE(sentenceOf(body).find("587"), std::string::npos) << sentenceOf(body);
  body = shipped("box-60");
  body["dictionary"] = "aruco_9x9";
  EXPECT_NE(sentenceOf(body).find("apriltag_36h11"), std::string::npos) << sentenceOf(body);
  body = shipped("box-60");
  body["panels"][2]["on"] = "front";
  body.erase("seams");
  EXPECT_NE(sentenceOf(body).find("overlap"), std::string::npos) << sentenceOf(body);
  body = shipped("box-60");
  body["format"] = 2;
  EXPECT_EQ(readPaperBody(write("newer.json", body)).error().code, ErrorCode::newerFormat);
  body = shipped("box-60");
  for (const auto& item : body.items()) {
    json part = body;
    part.erase(item.key());
    if (item.key() == "seams") continue;  // a flat body has none
    EXPECT_NE(sentenceOf(part), "") << item.key();
  }
}

TEST_F(MarkerBodyFile, ASchoolsBodyReplacesOursAndMustNotTakeAnothersMarkers) {
  json own = shipped("box-60");
  own["version"] = 7;
  write("box-60.json", own);
  const auto papers = readPaperBodies({kBodies, folder_});
  ASSERT_TRUE(papers) << papers.error();
  EXPECT_EQ(papers->size(), 5u);
  write("box-61.json", own);
  const auto clash = readPaperBodies({kBodies, folder_});
  ASSERT_FALSE(clash);
  EXPECT_NE(clash.error().sentence().find("box-61"), std::string::npos) << clash.error();
}

TEST_F(MarkerBodyFile, TheSchemaAcceptsWhatIsReadAndRefusesWhatIsNot) {
  const json text = json::parse(std::ifstream(kBodies.parent_path() / "schemas" / "marker-body.schema.json"));
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema);
  const auto accepts = [&](const json& body) {
    return valijson::Validator().validate(schema, valijson::adapters::NlohmannJsonAdapter(body), nullptr);
  };
  for (const char* id : {"box-60", "box-40", "sleeve", "mannequin-board", "calibration-board"}) {
    const json whole = shipped(id);
    EXPECT_TRUE(accepts(whole)) << id;
    for (const auto& item : whole.items()) {
      json part = whole;
      part.erase(item.key());
      EXPECT_EQ(accepts(part), sentenceOf(part).empty()) << id << " without " << item.key();
      json odd = whole;
      odd[item.key()] = json::object({{"strange", 1}});
      EXPECT_FALSE(accepts(odd)) << id << " " << item.key();
      EXPECT_FALSE(sentenceOf(odd).empty()) << id << " " << item.key();
    }
    json more = whole;
    more["strange"] = 1;
    EXPECT_FALSE(accepts(more));
    EXPECT_FALSE(sentenceOf(more).empty());
  }
}

}  // namespace
}  // namespace ew::marker_body_test
