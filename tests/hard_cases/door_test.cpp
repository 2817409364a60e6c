#include "ew/door/door.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ew/io/sequence.h"
#include "hard_cases/keeping_host.h"
#include "library/temporary_folder.h"

namespace ew::door::door_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::EnvironmentValue;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

json manifest() { return {{"name", "odd"}, {"version", "0.1.0"}, {"abi", sdk::kAbi}, {"library", "odd.so"}}; }

/// Puts one plugin into a folder, opens it, and gives what became of it.
PluginStatus opened(const std::string& manifestText, const std::string& library) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "odd");
  if (!manifestText.empty()) writeText(folder / "odd/plugin.json", manifestText);
  if (!library.empty()) writeText(folder / "odd/odd.so", library);
  HeadlessHost host;
  PluginList plugins({folder.path()});
  plugins.openAll(host);
  EXPECT_EQ(plugins.states().size(), 1u);
  EXPECT_TRUE(host.registered().empty());
  const PluginStatus status = plugins.states().empty() ? PluginStatus{} : plugins.states().front();
  EXPECT_TRUE(status.sentence().ends_with('.')) << status.sentence();
  return status;
}

/// Puts one plugin made of the odd library `kind` into `folder`.
void putInto(const TemporaryFolder& folder, const std::string& kind) {
  json said = manifest();
  said["title"] = "Odd one";
  writeText(folder / "odd/plugin.json", said.dump());
  fs::copy_file(std::string(EW_ODD_PLUGIN_DIR "/odd_") + kind + ".so", folder / "odd/odd.so");
}

/// One sentence that names the plugin and says why.
void expectOneSentence(const std::vector<std::string>& told, const std::string& why) {
  ASSERT_EQ(told.size(), 1u) << (told.empty() ? "nothing was told" : told.back());
  EXPECT_NE(told[0].find("'Odd one'"), std::string::npos) << told[0];
  EXPECT_NE(told[0].find(why), std::string::npos) << told[0];
  EXPECT_TRUE(told[0].ends_with('.')) << told[0];
}

TEST(HardCasesDoor, ASweepOfAlmostNothingIsNoVolumeForAPlugin) {
  const TemporaryFolder folder;
  Sequence sweep;
  sweep.width = sweep.height = 10;
  sweep.orientation = "MF";
  sweep.imageType = "BRIGHTNESS";
  for (int n = 0; n < 30; ++n) {
    SequenceFrame frame;
    frame.time_s = 0.1 * n;
    glm::dmat4 imageToReference(1.0);
    imageToReference[3].z = n;
    frame.transforms.push_back({"Image", "Reference", imageToReference, n < 2 ? PoseStatus::ok : PoseStatus::invalid});
    sweep.frames.push_back(frame);
  }
  sweep.pixels.assign(3000, 9);
  ASSERT_TRUE(writeSequence(sweep, folder / "few.igs.mha"));
  HeadlessHost host;
  EXPECT_TRUE(host.volumes().planSweep(folder / "few.igs.mha", {}, noProgress())) << "planning makes nothing";
  const auto refused = host.volumes().reconstruct(folder / "few.igs.mha", {}, noProgress());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  EXPECT_NE(refused.error().sentence().find("Only 2 of the 30 frames"), std::string::npos) << refused.error();
  EXPECT_NE(refused.error().sentence().find("reconstruct the sweep by itself"), std::string::npos) << refused.error();
}

TEST(HardCasesDoor, WhatAPluginRegisteredBeforeItFailedIsTakenBack) {
  for (const auto& [kind, why] :
       {std::pair{"late", "changed its mind"}, std::pair{"late_number", "no reason was given"}, std::pair{"late_null", "gave no reason"}}) {
    const TemporaryFolder folder;
    putInto(folder, kind);
    KeepingHost host;
    PluginList plugins({folder.path()});
    plugins.openAll(host);
    ASSERT_EQ(plugins.states().size(), 1u);
    EXPECT_EQ(plugins.states()[0].state, PluginState::failed) << kind;
    expectOneSentence({plugins.states()[0].sentence()}, why);
    EXPECT_EQ(host.panelsKept.size(), 0u) << kind << ": a panel of a plugin that is gone";
    EXPECT_EQ(host.jobsKept.size(), 0u) << kind << ": work of a plugin that is gone";
    EXPECT_EQ(host.commandsKept().size(), 0u) << kind << ": a command of a plugin that is gone";
    EXPECT_EQ(host.theWorkspaces.added.size(), 0u) << kind << ": a workspace of a plugin that is gone";
    EXPECT_EQ(host.theScan.events.all().size() + host.theScan.drivers.all().size(), 0u) << kind << ": it holds on to the scan";
    EXPECT_EQ(host.theWindow.entries.all().size() + host.theWindow.closing.all().size(), 0u) << kind << ": it holds on to the window";
    EXPECT_EQ(host.theParts.opened.all().size(), 0u) << kind;
    EXPECT_FALSE(host.theParts.schemas->knows("odd")) << kind << ": a section of a plugin that is gone";
    for (const auto& overlay : host.theOverlays.scan) EXPECT_TRUE(overlay.expired()) << kind << ": a drawing of a plugin that is gone";
    host.theCase.tell();  // its ticket is void
    EXPECT_TRUE(host.told().empty()) << kind;
  }
}

TEST(HardCasesDoor, ExceptionsOfCommandsAreErrorsThatNameThePlugin) {
  const TemporaryFolder folder;
  putInto(folder, "callbacks");
  KeepingHost host;
  PluginList plugins({folder.path()});
  plugins.openAll(host);
  ASSERT_EQ(plugins.states()[0].state, PluginState::loaded) << plugins.states()[0].sentence();
  static_cast<void>(host.told());
  ASSERT_EQ(host.commandsKept().size(), 4u);
  const auto number = host.commandsKept()[0].run({}, noProgress());
  ASSERT_FALSE(number);
  EXPECT_EQ(number.error().code, ErrorCode::internal);
  expectOneSentence({number.error().sentence()}, "throw-number");
  const auto memory = host.commandsKept()[1].run({}, noProgress());
  ASSERT_FALSE(memory);
  EXPECT_EQ(memory.error().code, ErrorCode::tooLarge);
  expectOneSentence({memory.error().sentence()}, "not enough memory");
  const auto atTheEnd = host.commandsKept()[2].run({}, noProgress());
  ASSERT_TRUE(atTheEnd) << atTheEnd.error();
  const auto put = atTheEnd->putInPlace();
  ASSERT_FALSE(put);
  expectOneSentence({put.error().sentence()}, "throw-at-the-end");
  EXPECT_TRUE(host.told().empty()) << "the error says it, nobody else";
}

TEST(HardCasesDoor, ExceptionsOfPanelsAndOfChangesAreToldOncePerKindAndThePluginStays) {
  const TemporaryFolder folder;
  putInto(folder, "callbacks");
  KeepingHost host;
  PluginList plugins({folder.path()});
  plugins.openAll(host);
  ASSERT_EQ(plugins.states()[0].state, PluginState::loaded) << plugins.states()[0].sentence();
  expectOneSentence(host.told(), "no reason was given");  // its document was asked to tell of changes
  ASSERT_EQ(host.panelsKept.size(), 2u);

  EXPECT_EQ(host.panelsKept[0].make(nullptr), nullptr);
  expectOneSentence(host.told(), "'Odd column'");
  EXPECT_EQ(host.panelsKept[1].make(nullptr), nullptr);
  EXPECT_EQ(host.panelsKept[1].makeStage(nullptr), nullptr);
  EXPECT_TRUE(host.told().empty()) << "a kind is told once";

  host.theCase.tell();
  expectOneSentence(host.told(), "a change of the case");
  for (int n = 0; n < 100; ++n) host.theCase.tell();
  EXPECT_TRUE(host.told().empty());
  EXPECT_EQ(plugins.states()[0].state, PluginState::loaded);
  EXPECT_NE(plugins.states()[0].sentence().find("a change of the case"), std::string::npos) << "the Plugins page says it as well";
}

TEST(HardCasesDoor, ExceptionsOfAPanelsDocumentAreTold) {
  const TemporaryFolder folder;
  putInto(folder, "callbacks");
  KeepingHost host;
  PluginList plugins({folder.path()});
  plugins.openAll(host);
  static_cast<void>(host.told());
  ASSERT_EQ(host.panelsKept.size(), 2u);
  const auto document = host.panelsKept[1].document.lock();
  ASSERT_NE(document, nullptr);
  EXPECT_EQ(document->title(), "Odd stage") << "something has to stand in the top bar";
  EXPECT_EQ(document->remark(), "");
  EXPECT_EQ(document->note(), "");
  EXPECT_EQ(document->undoText(), "");
  EXPECT_EQ(document->redoText(), "");
  EXPECT_TRUE(host.told().empty()) << "told when it was asked to tell of changes";
  document->undo();
  expectOneSentence(host.told(), "undo");
  document->redo();
  expectOneSentence(host.told(), "nothing to redo it with");
  document->save(false);
  expectOneSentence(host.told(), "the dog ate the disk");
  document->save(true);
  EXPECT_TRUE(host.told().empty());
  EXPECT_EQ(document->unsaved(), "");
  expectOneSentence(host.told(), "could not say what it still holds");
}

TEST(HardCasesDoor, ExceptionsOfWhateverFollowsTheScanOrTheWindowAreToldOncePerKind) {
  const TemporaryFolder folder;
  putInto(folder, "callbacks");
  KeepingHost host;
  PluginList plugins({folder.path()});
  plugins.openAll(host);
  static_cast<void>(host.told());
  ASSERT_EQ(host.theScan.events.all().size(), 1u);
  for (int n = 0; n < 100; ++n) host.theScan.makeFrame();
  expectOneSentence(host.told(), "follow the scan");

  ASSERT_EQ(host.theScan.drivers.all().size(), 1u);
  const auto driver = host.theScan.drivers.all().front();
  const Pose first = driver->source->poseAt(0.0);
  EXPECT_EQ(first.probeToWorld.matrix[3].x, 7.0) << "the first one it can say";
  EXPECT_EQ(driver->source->poseAt(1.0).probeToWorld.matrix[3].x, 7.0) << "where it was";
  expectOneSentence(host.told(), "could not move the probe");
  EXPECT_FALSE(driver->source->movesAfter(2.0)) << "a source that threw is not asked any more";
  driver->takenBack();
  EXPECT_TRUE(host.told().empty());

  ASSERT_EQ(host.theWindow.entries.all().size(), 1u);
  (*host.theWindow.entries.all().front())();
  expectOneSentence(host.told(), "'Odd entry'");
  ASSERT_EQ(host.theWindow.closing.all().size(), 1u);
  EXPECT_EQ((*host.theWindow.closing.all().front())(), "");
  expectOneSentence(host.told(), "before you close the window");
  ASSERT_EQ(host.theParts.opened.all().size(), 1u);
  (*host.theParts.opened.all().front())("/cases/one");
  expectOneSentence(host.told(), "a change of the case");
  EXPECT_EQ(plugins.states()[0].state, PluginState::loaded);
}

TEST(HardCasesDoor, WhatAPluginDrawsGoesWithIt) {
  const TemporaryFolder folder;
  putInto(folder, "callbacks");
  KeepingHost host;
  {
    PluginList plugins({folder.path()});
    plugins.openAll(host);
    ASSERT_EQ(host.theOverlays.scan.size(), 1u);
    const auto shown = host.theOverlays.scan.front().lock();
    ASSERT_NE(shown, nullptr);
    EXPECT_EQ(shown->latest.labels.size(), 1u);
    EXPECT_TRUE(host.theParts.schemas->knows("odd"));
    EXPECT_EQ(host.theWorkspaces.added.size(), 1u);
  }
  EXPECT_TRUE(host.theOverlays.scan.front().expired());
  EXPECT_EQ(host.theScan.drivers.all().size(), 0u) << "the probe is given back";
  EXPECT_FALSE(host.theParts.schemas->knows("odd"));
}

TEST(HardCasesDoor, ADocumentThatItsPluginHasGivenUpHasNothingToUndo) {
  const TemporaryFolder folder;
  putInto(folder, "callbacks");
  KeepingHost host;
  PluginList plugins({folder.path()});
  plugins.openAll(host);
  static_cast<void>(host.told());
  const auto document = host.panelsKept[1].document.lock();
  ASSERT_NE(document, nullptr);
  ASSERT_EQ(host.commandsKept().size(), 4u);
  ASSERT_TRUE(host.commandsKept()[3].run({}, noProgress())) << "gives its document up";
  EXPECT_EQ(document->title(), "Odd stage");
  EXPECT_EQ(document->undoText(), "");
  document->undo();
  document->save(false);
  EXPECT_TRUE(host.told().empty());
}

TEST(HardCasesDoor, ASectionOfACaseIsCheckedByTheSchemaOfItsPlugin) {
  const auto schemas = std::make_shared<PartSchemas>();
  const std::string schema = R"({"type": "object", "required": ["steps"], "properties": {
    "steps": {"description": "a whole number from 1 to 9", "type": "integer", "minimum": 1, "maximum": 9},
    "name": {"description": "a small word", "type": "string", "pattern": "^[a-z]+$"}}})";
  auto ticket = schemas->add("lesson", schema);
  ASSERT_TRUE(ticket) << ticket.error();
  EXPECT_EQ(schemas->add("lesson", schema).error().code, ErrorCode::badUsage) << "one owner";
  for (const char* name : {"", "Lesson", "../x", "9", "a b"})
    EXPECT_EQ(schemas->add(name, schema).error().code, ErrorCode::badUsage) << name;
  for (const char* text : {"", "{", "[]", R"({"type": 7})", R"({"$ref": "file:///etc/passwd"})"})
    EXPECT_EQ(schemas->add("other", text).error().code, ErrorCode::badHeader) << text;

  EXPECT_TRUE(schemas->problems({{"parts", {{"lesson", {{"steps", 3}}}}}}).empty());
  EXPECT_TRUE(schemas->problems({{"parts", {{"unknown", {{"steps", "x"}}}}}}).empty()) << "nobody knows it";
  EXPECT_TRUE(schemas->problems(json::object()).empty());
  EXPECT_TRUE(schemas->problems({{"parts", 3}}).empty());
  const auto wrong = schemas->problems({{"parts", {{"lesson", {{"steps", 12}, {"name", "A"}}}}}});
  ASSERT_EQ(wrong.size(), 2u);
  EXPECT_NE(wrong[0].sentence().find("'parts.lesson."), std::string::npos) << wrong[0];
  const auto missing = schemas->problems({{"parts", {{"lesson", json::object()}}}});
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_NE(missing[0].sentence().find("must be a whole number from 1 to 9"), std::string::npos) << missing[0];
  const auto nothing = schemas->problems({{"parts", {{"lesson", 3}}}});
  ASSERT_EQ(nothing.size(), 1u);
  EXPECT_NE(nothing[0].sentence().find("'parts.lesson'"), std::string::npos) << nothing[0];
  // A pattern recurses once per character.
  EXPECT_EQ(schemas->problems({{"parts", {{"lesson", {{"steps", 3}, {"name", std::string(1000000, 'a')}}}}}}).size(), 1u);

  ticket->reset();
  EXPECT_FALSE(schemas->knows("lesson"));
}

TEST(HardCasesDoor, ExceptionsOfAJobAndOfItsDoneAreTold) {
  const TemporaryFolder folder;
  putInto(folder, "callbacks");
  KeepingHost host;
  PluginList plugins({folder.path()});
  plugins.openAll(host);
  static_cast<void>(host.told());
  ASSERT_EQ(host.jobsKept.size(), 1u);
  EXPECT_EQ(host.savingJobs, 1) << "the window knows that it saves";
  const auto outcome = host.jobsKept[0].work(noProgress());
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().code, ErrorCode::internal);
  EXPECT_TRUE(host.told().empty()) << "a worker tells nobody";
  host.jobsKept[0].done(outcome);
  const auto told = host.told();
  ASSERT_EQ(told.size(), 2u);
  expectOneSentence({told[0]}, "'Odd work'");
  expectOneSentence({told[1]}, "no idea what to do with it");
}

TEST(HardCasesDoor, NothingReachesAPluginThatIsGone) {
  const TemporaryFolder folder;
  putInto(folder, "callbacks");
  KeepingHost host;
  {
    PluginList plugins({folder.path()});
    plugins.openAll(host);
    static_cast<void>(host.told());
  }
  ASSERT_EQ(host.panelsKept.size(), 2u);
  EXPECT_EQ(host.panelsKept[0].make(nullptr), nullptr);
  host.theCase.tell();
  const auto outcome = host.jobsKept[0].work(noProgress());
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().code, ErrorCode::cancelled);
  host.jobsKept[0].done(outcome);
  const auto command = host.commandsKept()[0].run({}, noProgress());
  ASSERT_FALSE(command);
  EXPECT_EQ(command.error().code, ErrorCode::notFound);
  EXPECT_TRUE(host.told().empty());
}

TEST(HardCasesDoor, APluginThatThrowsWhenItIsDestroyedIsASentence) {
  const TemporaryFolder folder;
  putInto(folder, "end");
  KeepingHost host;
  {
    PluginList plugins({folder.path()});
    plugins.openAll(host);
    ASSERT_EQ(plugins.states()[0].state, PluginState::loaded) << plugins.states()[0].sentence();
  }
  expectOneSentence(host.told(), "did not end in order");
}

TEST(HardCasesDoor, AFolderWithoutAManifestIsASentence) {
  const auto status = opened("", "x");
  EXPECT_EQ(status.state, PluginState::badManifest);
  EXPECT_NE(status.sentence().find("plugin.json"), std::string::npos);
  EXPECT_EQ(status.title(), "odd");
}

TEST(HardCasesDoor, ABrokenManifestIsASentenceThatNamesThePlace) {
  for (const char* text : {"{", "[]", "null", "{\"name\": \"odd\"", "\xff\xfe"})
    EXPECT_EQ(opened(text, "x").state, PluginState::badManifest) << text;
  for (const auto& [field, value] : std::vector<std::pair<std::string, json>>{{"name", 3},
                                                                              {"name", "../x"},
                                                                              {"abi", "new"},
                                                                              {"abi", -1},
                                                                              {"abi", 4294967296},
                                                                              {"version", json()},
                                                                              {"library", "../odd.so"},
                                                                              {"library", "/lib/x86_64-linux-gnu/libc.so.6"},
                                                                              {"capabilities", "panel"}}) {
    json wrong = manifest();
    wrong[field] = value;
    const auto status = opened(wrong.dump(), "x");
    EXPECT_EQ(status.state, PluginState::badManifest) << wrong;
    EXPECT_NE(status.sentence().find("'" + field + "'"), std::string::npos) << status.sentence();
  }
}

TEST(HardCasesDoor, AManifestWhoseLibraryIsMissingIsASentence) {
  const auto status = opened(manifest().dump(), "");
  EXPECT_EQ(status.state, PluginState::badManifest);
  EXPECT_NE(status.sentence().find("odd.so"), std::string::npos);
}

TEST(HardCasesDoor, AnotherAbiIsRefusedWithBothNumbersBeforeAnyCodeIsLoaded) {
  json other = manifest();
  other["abi"] = 65537;
  const auto status = opened(other.dump(), "not even a library");
  EXPECT_EQ(status.state, PluginState::otherAbi);
  EXPECT_NE(status.sentence().find("65537"), std::string::npos);
  EXPECT_NE(status.sentence().find(std::to_string(sdk::kAbi)), std::string::npos);
}

TEST(HardCasesDoor, AFileThatIsNoLibraryOrAForeignOneIsASentence) {
  // An ELF header of another machine, a text, half a header, a library of Windows.
  std::string foreign =
      "\x7f"
      "ELF\x02\x01\x01";
  foreign.resize(64, '\0');
  foreign[16] = 3;
  foreign[18] = static_cast<char>(0xb7);  // AArch64
  for (const std::string& library : {foreign, std::string("hello"),
                                     std::string("\x7f"
                                                 "ELF"),
                                     std::string("MZ\x90\0\x03", 5)}) {
    const auto status = opened(manifest().dump(), library);
    EXPECT_EQ(status.state, PluginState::notLoadable) << status.sentence();
  }
}

TEST(HardCasesDoor, APluginCutOffInTheMiddleIsASentence) {
  // Cut inside the headers: a loader that maps less than the file promises could die of SIGBUS instead of saying so.
  const std::string whole = textOf(EW_ODD_PLUGIN_DIR "/odd_throws.so");
  ASSERT_GT(whole.size(), 4096u);
  for (const std::size_t length :
       {std::size_t{64}, std::size_t{200}, std::size_t{1000}, std::size_t{4096}, whole.size() / 2, whole.size() - 100}) {
    const auto status = opened(manifest().dump(), whole.substr(0, length));
    EXPECT_EQ(status.state, PluginState::notLoadable) << length << ": " << status.sentence();
  }
}

TEST(HardCasesDoor, ALibraryWithoutTheThreeFunctionsIsASentence) {
  const auto status = opened(manifest().dump(), textOf(EW_ODD_PLUGIN_DIR "/odd_empty.so"));
  EXPECT_EQ(status.state, PluginState::notLoadable);
  EXPECT_NE(status.sentence().find("ewPluginAbi"), std::string::npos) << status.sentence();
}

TEST(HardCasesDoor, CodeWithAnotherAbiIsRefusedAlthoughItsManifestSaysOtherwise) {
  const auto status = opened(manifest().dump(), textOf(EW_ODD_PLUGIN_DIR "/odd_abi.so"));
  EXPECT_EQ(status.state, PluginState::otherAbi) << status.sentence();
}

TEST(HardCasesDoor, APluginThatThrowsOrGivesNothingIsASentence) {
  const auto throws = opened(manifest().dump(), textOf(EW_ODD_PLUGIN_DIR "/odd_throws.so"));
  EXPECT_EQ(throws.state, PluginState::failed);
  EXPECT_NE(throws.sentence().find("no licence for the moon"), std::string::npos) << throws.sentence();
  EXPECT_EQ(opened(manifest().dump(), textOf(EW_ODD_PLUGIN_DIR "/odd_number.so")).state, PluginState::failed);
  EXPECT_EQ(opened(manifest().dump(), textOf(EW_ODD_PLUGIN_DIR "/odd_null.so")).state, PluginState::failed);
}

TEST(HardCasesDoor, APluginThatCannotBeUsedDoesNotHideAGoodOneOfTheSameName) {
  const TemporaryFolder folder;
  json good = manifest();
  good["name"] = "twin";
  good["library"] = "good.so";
  json old = good;
  old["abi"] = 65536;
  writeText(folder / "a/plugin.json", old.dump());
  fs::copy_file(EW_ODD_PLUGIN_DIR "/odd_good.so", folder / "a/good.so");
  writeText(folder / "b/plugin.json", good.dump());
  fs::copy_file(EW_ODD_PLUGIN_DIR "/odd_good.so", folder / "b/good.so");
  HeadlessHost host;
  PluginList plugins({folder.path()});
  plugins.openAll(host);
  ASSERT_EQ(plugins.states().size(), 2u);
  EXPECT_EQ(plugins.states()[0].state, PluginState::otherAbi);
  EXPECT_EQ(plugins.states()[1].state, PluginState::loaded) << plugins.states()[1].sentence();
}

TEST(HardCasesDoor, OneBrokenPluginDoesNotStopTheNext) {
  const TemporaryFolder folder;
  writeText(folder / "a/plugin.json", "{");
  json good = manifest();
  good["name"] = "good";
  good["library"] = "good.so";
  writeText(folder / "b/plugin.json", good.dump());
  fs::copy_file(EW_ODD_PLUGIN_DIR "/odd_good.so", folder / "b/good.so");
  writeText(folder / "c/plugin.json", good.dump());
  fs::copy_file(EW_ODD_PLUGIN_DIR "/odd_good.so", folder / "c/good.so");
  HeadlessHost host;
  PluginList plugins({folder.path(), folder / "nowhere"});
  plugins.openAll(host);
  plugins.openAll(host);  // a second time opens nothing twice
  ASSERT_EQ(plugins.states().size(), 3u);
  EXPECT_EQ(plugins.states()[0].state, PluginState::badManifest);
  EXPECT_EQ(plugins.states()[1].state, PluginState::loaded);
  EXPECT_EQ(plugins.states()[2].state, PluginState::replaced) << "the same name twice: the first one wins";
  ASSERT_EQ(host.registered().size(), 1u);
  const auto thrown = host.registered().front().run({}, noProgress());
  ASSERT_FALSE(thrown) << "an exception of a command becomes an error at the door";
  EXPECT_EQ(thrown.error().code, ErrorCode::internal);
}

TEST(HardCasesDoor, TheFoldersSearchedComeFromTheEnvironmentFirstAndEachOnce) {
  const TemporaryFolder one;
  const TemporaryFolder two;
  const EnvironmentValue searched("ECHOWEAVE_PLUGINS",
                                  one.path().string() + ":" + two.path().string() + "::/no/where:" + one.path().string());
  const auto folders = pluginFolders();
  ASSERT_GE(folders.size(), 2u);
  EXPECT_EQ(folders[0], fs::weakly_canonical(one.path()));
  EXPECT_EQ(folders[1], fs::weakly_canonical(two.path()));
  EXPECT_EQ(std::count(folders.begin(), folders.end(), fs::weakly_canonical(one.path())), 1);
}

}  // namespace
}  // namespace ew::door::door_test
