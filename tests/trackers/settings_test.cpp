#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "ew/trackers/tracker_settings.h"
#include "places.h"

namespace ew::settings_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TrackerList every() {
  TrackerList list;
  CameraSource camera;
  camera.camera.device = "/dev/video2";
  camera.camera.width = 1920;
  camera.camera.height = 1080;
  camera.camera.frames_hz = 60.0;
  camera.camera.model = assumedCamera(1920, 1080);
  camera.camera.tracking.corners = CornerMethod::subPix;
  camera.camera.tracking.readout_s = 0.02;
  camera.camera.filmLoops = true;
  camera.probeBody = "sleeve";
  camera.boardBody = "";
  HandControllerSettings controller{.kind = HandControllerKind::gameController, .hand = gameControllerOptions(RateMode::springBack)};
  controller.hand.deadZone = 0.2;
  controller.hand.axes[2] = {.axis = 7, .reversed = true, .full = 3.5};
  const TrackedProbeOptions probe{.tool = "ProbeToTracker",
                                  .reference = "BodyToTracker",
                                  .filter = FilterKind::oneEuro,
                                  .predict = false,
                                  .staleAfter_s = 0.75,
                                  .wellMeasured_mm = 4.0};
  list.trackers = {
      {"plus", "PLUS", IgtlSettings{.host = "tracker.local", .port = 18945, .checksSums = false, .speaksVersion3 = true}, probe},
      {"kamera-1", "Kamera über dem Tisch", camera, {}},
      {"tape", "A recording", SequenceSettings{"/tmp/sweep.igs.mha", 0.5, false}, {}},
      {"mouse", "SpaceMouse", HandControllerSettings{}, {}},
      {"pad", "Game controller", controller, {}}};
  list.chosen = "tape";
  list.startsOn = list.soundsLost = list.serves = list.servesNetwork = true;
  list.servePort = 20000;
  return list;
}

Result<TrackerList> read(const json& document) { return trackersFromJson(document, verbatim("t.json")); }

}  // namespace

TEST(TrackerSettings, ComeBackAsTheyWereWritten) {
  for (const TrackerList& list : {every(), usualTrackers(), TrackerList{}}) {
    const auto back = read(toJson(list));
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(*back, list);
  }
  const fs::path file = fs::path(::testing::TempDir()) / "ew_trackers.json";
  ASSERT_TRUE(writeTrackers(every(), file));
  const auto again = readTrackers(file);
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(*again, every());
  fs::remove(file);
  EXPECT_EQ(readTrackers(file).error().code, ErrorCode::notFound);
}

TEST(TrackerSettings, AreNeverMoreThanCanBeReadAgain) {
  TrackerList list;
  for (std::size_t n = 0; n <= TrackerList::kMost; ++n)
    list.trackers.push_back({"t" + std::to_string(n), "Tracker", HandControllerSettings{}, {}});
  const fs::path file = fs::path(::testing::TempDir()) / "ew_trackers_many.json";
  const auto refused = writeTrackers(list, file);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().sentence(), "A list of trackers holds at most 50; remove those that are not used any more.");
  EXPECT_FALSE(fs::exists(file));
  list.trackers.pop_back();
  ASSERT_TRUE(writeTrackers(list, file));
  const auto again = readTrackers(file);
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(*again, list);
  fs::remove(file);
}

TEST(TrackerSettings, WorkWithNothingButWhatTheyCannotBeWithout) {
  const auto read = settings_test::read({{"format", 1}, {"trackers", {{{"id", "a"}, {"name", "A"}, {"source", "openigtlink"}}}}});
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->trackers[0].source, (decltype(TrackerSettings::source)(IgtlSettings{})));
  EXPECT_EQ(read->trackers[0].probe, TrackedProbeOptions{});
  const auto usual = usualTrackers();
  EXPECT_EQ(std::get<IgtlSettings>(usual.trackers[0].source).host, "localhost");
  EXPECT_EQ(std::get<IgtlSettings>(usual.trackers[0].source).port, 18944);
}

TEST(TrackerSettings, SayWhatIsWrongAndWhereInOneSentence) {
  const auto problem = [](const std::function<void(json&)>& change) {
    json document = toJson(every());
    change(document);
    const auto read = settings_test::read(document);
    EXPECT_FALSE(read);
    return read ? std::string() : read.error().sentence();
  };
  EXPECT_EQ(problem([](json& d) { d["trackers"][0]["settings"]["port"] = 70000; }),
            "'trackers[0].settings.port' in t.json is 70000; it must be a whole number from 1 to 65535.");
  EXPECT_NE(problem([](json& d) { d["trackers"][1]["id"] = "plus"; }).find("one that no other tracker of the list has"), std::string::npos);
  EXPECT_NE(problem([](json& d) { d["trackers"][1]["id"] = "Über"; }).find("lower-case"), std::string::npos);
  EXPECT_NE(problem([](json& d) { d["chosen"] = "nobody"; }).find("the id of one of the trackers"), std::string::npos);
  EXPECT_NE(problem([](json& d) { d["trackers"][0]["settings"]["hots"] = "x"; }).find("hots"), std::string::npos);
  EXPECT_NE(problem([](json& d) { d["trackers"][4]["settings"]["axes"][0]["full"] = "fast"; }).find("axes[0].full"), std::string::npos);
  EXPECT_NE(problem([](json& d) { d["trackers"][1]["settings"]["model"]["fx"] = "long"; }).find("fx"), std::string::npos);
  EXPECT_NE(problem([](json& d) { d["trackers"][0]["source"] = "telepathy"; }).find("\"openigtlink\""), std::string::npos);
  json newer = toJson(every());
  newer["format"] = TrackerList::kFormat + 1;
  EXPECT_EQ(read(newer).error().code, ErrorCode::newerFormat);
}

TEST(TrackerSettings, MakeTheDeviceAndTheWayItIsFollowed) {
  const TrackerList list = every();
  const std::vector<MarkerBody> none;
  EXPECT_TRUE(makeDevice(list.trackers[0], none));
  const auto camera = makeDevice(list.trackers[1], none);
  ASSERT_FALSE(camera);
  EXPECT_EQ(camera.error().code, ErrorCode::notFound);
  EXPECT_NE(camera.error().sentence().find("'sleeve'"), std::string::npos);
  MarkerBody sleeve;
  sleeve.id = "sleeve";
  EXPECT_TRUE(makeDevice(list.trackers[1], std::vector<MarkerBody>{sleeve}));
  EXPECT_TRUE(makeDevice(list.trackers[2], none)) << "a file that is not there is the device's to say";
  EXPECT_EQ(makeDevice(list.trackers[3], none).error().code, ErrorCode::badUsage);
  EXPECT_EQ(probeOptionsOf(list.trackers[0]).tool, "ProbeToTracker");
  EXPECT_EQ(probeOptionsOf(list.trackers[1]).tool, "sleeve");
  EXPECT_EQ(probeOptionsOf(list.trackers[1]).reference, "");
}

TEST(TrackerSettings, GiveANewTrackerAnIdOfItsOwn) {
  EXPECT_EQ(newTrackerId(usualTrackers(), "PLUS"), "plus-2");
  EXPECT_EQ(newTrackerId(usualTrackers(), "Kamera über dem Tisch!"), "kamera-ber-dem-tisch");
  EXPECT_EQ(newTrackerId({}, "…"), "tracker");
  TrackerList list;
  list.trackers.push_back({"tape", "Not chosen yet", SequenceSettings{}, {}});
  for (int n = 0; n < 5; ++n) list.trackers.push_back({newTrackerId(list, "Camera"), "Camera", CameraSource{}, {}});
  const auto read = settings_test::read(toJson(list));
  EXPECT_TRUE(read) << read.error();
}

TEST(TrackerSettings, AreDescribedByTheirSchema) {
  const json schema = json::parse(std::ifstream(fs::path(EW_SOURCE_DIR) / "resources" / "schemas" / "trackers.schema.json"));
  const json document = toJson(every());
  for (const auto& [key, unused] : document.items()) EXPECT_TRUE(schema["properties"].contains(key)) << key;
  EXPECT_EQ(schema["properties"].size(), document.size() + 1);  // and "note"
  const json& tracker = schema["properties"]["trackers"]["items"]["properties"];
  for (const json& each : document["trackers"]) {
    for (const auto& [key, unused] : each.items()) EXPECT_TRUE(tracker.contains(key)) << key;
    const std::string source = each["source"];
    const std::string name = source == "space_mouse" || source == "game_controller" ? "hand_controller" : source;
    ASSERT_TRUE(schema["definitions"].contains(name)) << name;
    const json& settings = schema["definitions"][name]["properties"];
    for (const auto& [key, unused] : each["settings"].items()) EXPECT_TRUE(settings.contains(key)) << name << " " << key;
    for (const auto& [key, unused] : each["probe"].items()) EXPECT_TRUE(tracker["probe"]["properties"].contains(key)) << key;
  }
}

}  // namespace ew::settings_test
