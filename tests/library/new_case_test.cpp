#include "ew/library/new_case.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../counted_stop.h"
#include "../even_sweep.h"
#include "ew/imaging/frame_stack.h"
#include "ew/imaging/slicing.h"
#include "ew/io/sequence.h"
#include "ew/io/volume_file.h"
#include "ew/library/checksums.h"
#include "ew/library/content_name.h"
#include "ew/library/publishing.h"
#include "ew/library/templates.h"
#include "library/bundle_world.h"

namespace ew::test::new_case_test {
namespace {

namespace fs = std::filesystem;

/// A sweep of 30 x 20 pixels of 1 mm and 25 frames a millimetre apart: grey tells the frame.
fs::path makeSweep(const TemporaryFolder& folder) {
  const Sequence sweep = evenSweep({.width = 30, .height = 20, .frames = 25, .from = "Image"}, [](int n, int) { return 20 + 8 * n; });
  const fs::path file = folder / "sweep.igs.mha";
  EXPECT_TRUE(writeSequence(sweep, file));
  return file;
}

NewCase named(const std::string& title, CaseSource source) {
  NewCase wanted;
  wanted.title = title;
  wanted.source = std::move(source);
  return wanted;
}

TEST(MakeCase, OfASweepReconstructsPlacesAndLevelsIt) {
  const TemporaryFolder folder;
  const fs::path sweep = makeSweep(folder);
  NewCase wanted = named("A sweep", SweepFile{.file = sweep, .spacing_mm = 1.0});
  wanted.region = "right upper quadrant";
  wanted.attribution = "Nobody";
  wanted.licence = "CC0";
  const auto plan = planCase(wanted);
  ASSERT_TRUE(plan) << plan.error();
  const auto made = makeCase(wanted, folder / "cases/A Sweep");
  ASSERT_TRUE(made) << made.error();
  const auto opened = loadCase(folder / "cases/A Sweep");
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_EQ(manifestOf(*opened), manifestOf(made->made));
  EXPECT_EQ(opened->id, "a-sweep");
  EXPECT_EQ(rightsOf(*opened), (RecordingRights{"Nobody", "CC0"}));
  const auto echo = loadCaseVolume(*opened, noProgress());
  ASSERT_TRUE(echo) << echo.error();
  EXPECT_EQ(echo->volume.grid.dims, plan->grid.dims);
  EXPECT_EQ(echo->volume.grid.dims, glm::ivec3(30, 20, 25));
  EXPECT_TRUE(echo->tissue) << "the level, for live echoes";
  EXPECT_EQ(echo->volume.echo[echo->volume.grid.indexOf(15, 10, 12)], 20 + 8 * 12) << "the frame's own grey";
  ASSERT_TRUE(made->frames);
  EXPECT_EQ(made->frames->used, 25u);
  ASSERT_TRUE(made->contact);
  EXPECT_GT(made->contact->faceShare, 0.5);
  const auto axes = sweepAxesOf(*opened);
  ASSERT_TRUE(axes);
  EXPECT_EQ(axes->depth, glm::dvec3(0, 1, 0)) << "down the frames";
  EXPECT_EQ(axes->lateral, glm::dvec3(1, 0, 0)) << "along their rows";
  const auto check = verifyCase(folder / "cases/A Sweep");
  ASSERT_TRUE(check);
  EXPECT_TRUE(check->problems.empty()) << check->problems.front();
  std::uint64_t bytes = 0;
  const auto files = filesOfCase(folder / "cases/A Sweep");
  for (const FileSum& each : *files) bytes += each.size_bytes;
  EXPECT_LE(bytes, plan->disk_bytes) << "what was said before";
}

TEST(MakeCase, OfAVolumeTakesItsVoxelsAndThePlaceThatIsGiven) {
  const TemporaryFolder folder;
  const Volume volume = noisyVolume({12, 10, 8}, 3);
  Volume spaced = volume;
  spaced.grid.spacing_mm = {0.5, 0.6, 0.7};
  ASSERT_TRUE(writeVolume(spaced, folder / "v.mha"));
  NewCase wanted = named("V", VolumeFile{.file = folder / "v.mha"});
  wanted.fileToWorld = Transform<frame::World, frame::File>{};
  wanted.fileToWorld->matrix[3] = glm::dvec4(1, 2, 3, 1);
  const auto made = makeCase(wanted, folder / "v");
  ASSERT_TRUE(made) << made.error();
  const auto echo = loadCaseVolume(made->made, noProgress());
  ASSERT_TRUE(echo);
  EXPECT_EQ(echo->volume.echo, volume.echo);
  EXPECT_EQ(echo->volume.grid.origin_mm, glm::dvec3(1, 2, 3));
  ASSERT_TRUE(writeVolume(volume, folder / "unspaced.mha"));
  const auto asked = makeCase(named("U", VolumeFile{.file = folder / "unspaced.mha"}), folder / "u");
  ASSERT_FALSE(asked);
  EXPECT_EQ(askedFor(asked.error()), "spacing");
  EXPECT_FALSE(fs::exists(folder / "u"));
}

TEST(MakeCase, OfARecordingBeginsWithoutTheArtefactsOfItsTemplate) {
  const TemporaryFolder folder;
  Volume volume = noisyVolume({12, 10, 8}, 3);
  volume.grid.spacing_mm = glm::dvec3(0.5);
  ASSERT_TRUE(writeVolume(volume, folder / "v.mha"));
  const auto says = [](const Message& note) { return note.english().find("Shadows and reverberation") != std::string::npos; };
  NewCase wanted = named("V", VolumeFile{.file = folder / "v.mha"});
  wanted.templateId = "thyroid-and-neck";
  const auto made = makeCase(wanted, folder / "v");
  ASSERT_TRUE(made) << made.error();
  EXPECT_FALSE(made->made.scene.attenuation);
  EXPECT_FALSE(made->made.scene.reverberation);
  EXPECT_TRUE(made->made.scene.noise) << "the rest is as the template has it";
  EXPECT_TRUE(std::any_of(made->notes.begin(), made->notes.end(), says));

  wanted.source = std::monostate{};
  const auto empty = makeCase(wanted, folder / "empty");
  ASSERT_TRUE(empty) << empty.error();
  EXPECT_TRUE(empty->made.scene.reverberation);
  const auto given = giveVolume(empty->made, VolumeFile{.file = folder / "v.mha"});
  ASSERT_TRUE(given) << given.error();
  EXPECT_FALSE(given->edited.scene.reverberation);
  EXPECT_TRUE(std::any_of(given->notes.begin(), given->notes.end(), says));
}

TEST(MakeCase, SaysBeforeWhatTheFileLeavesOpen) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeVolume(noisyVolume({12, 10, 8}, 3), folder / "unspaced.mha"));
  const auto spacing = planOfSource(VolumeFile{.file = folder / "unspaced.mha"});
  ASSERT_FALSE(spacing);
  EXPECT_EQ(askedFor(spacing.error()), "spacing") << spacing.error();
  writeText(folder / "four.nrrd",
            "NRRD0005\ntype: uint8\ndimension: 4\nsizes: 4 4 4 3\nkinds: space space space time\nspace: LPS\n"
            "space directions: (1,0,0) (0,1,0) (0,0,1.5) none\nspace origin: (0,0,0)\nencoding: raw\n\n" +
                std::string(192, 'a'));
  const auto step = planOfSource(VolumeFile{.file = folder / "four.nrrd"});
  ASSERT_FALSE(step);
  EXPECT_EQ(askedFor(step.error()), "time-step") << step.error();
  VolumeFile second{.file = folder / "four.nrrd"};
  second.answers.timeStep = 2;
  const auto plan = planOfSource(second);
  ASSERT_TRUE(plan) << plan.error();
  EXPECT_EQ(plan->grid.dims, glm::ivec3(4));
  EXPECT_TRUE(plan->asksForSide);
}

/// Grey falls from the back to the front, as when the probe was behind the patient.
Volume fromBehind() {
  Volume volume = noisyVolume({12, 20, 8}, 3);
  volume.grid.spacing_mm = glm::dvec3(0.5);
  for (std::size_t n = 0; n < volume.echo.size(); ++n) volume.echo[n] = static_cast<std::uint8_t>(20 + 10 * ((n / 12) % 20));
  return volume;
}

TEST(MakeCase, TellsWhichSideItAssumesAndAsksBeforePublishing) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeVolume(fromBehind(), folder / "v.mha"));
  const NewCase wanted = named("V", VolumeFile{.file = folder / "v.mha"});
  const auto plan = planCase(wanted);
  ASSERT_TRUE(plan) << plan.error();
  EXPECT_TRUE(plan->asksForSide);
  ASSERT_TRUE(plan->proposedSide);
  EXPECT_EQ(volumeSideOf(plan->proposedSide->axes), VolumeSide::back);
  const auto made = makeCase(wanted, folder / "assumed");
  ASSERT_TRUE(made) << made.error();
  EXPECT_TRUE(assumesAxes(made->made));
  EXPECT_EQ(sweepAxesOf(made->made)->depth, glm::dvec3(0, -1, 0));
  EXPECT_NE(made->notes.back().english().find("Its back was taken"), std::string::npos) << made->notes.back();
  const auto warned = [&](const Case& one) {
    const auto list = publishingList(one);
    return list && std::any_of(list->begin(), list->end(), [](const CheckItem& each) {
             return each.state == CheckItem::State::warning && each.what.english().find("which side") != std::string::npos;
           });
  };
  EXPECT_TRUE(warned(made->made));
  EXPECT_FALSE(warned(withSweepAxes(made->made, SweepAxes{}))) << "somebody said it";
  EXPECT_TRUE(validateCase(folder / "assumed").empty());
  NewCase said = wanted;
  said.source = VolumeFile{.file = folder / "v.mha", .answers = {}, .probeSide = VolumeSide::left};
  EXPECT_FALSE(planCase(said)->asksForSide);
  const auto told = makeCase(said, folder / "told");
  ASSERT_TRUE(told) << told.error();
  EXPECT_FALSE(assumesAxes(told->made));
  EXPECT_EQ(sweepAxesOf(told->made)->depth, glm::dvec3(-1, 0, 0));
}

TEST(MakeCase, OfWhatIsOnScreenNeedsNoFileAndKeepsItsBeams) {
  const TemporaryFolder folder;
  const auto shown = std::make_shared<const Volume>(fromBehind());
  const auto made = makeCase(named("S", VolumeAtHand{shown, SweepAxes{{0, 0, 1}, {1, 0, 0}}}), folder / "s");
  ASSERT_TRUE(made) << made.error();
  EXPECT_FALSE(assumesAxes(made->made));
  EXPECT_EQ(sweepAxesOf(made->made)->depth, glm::dvec3(0, 0, 1));
  const auto echo = loadCaseVolume(made->made, noProgress());
  ASSERT_TRUE(echo);
  EXPECT_EQ(echo->volume.echo, shown->echo);
  EXPECT_TRUE(planOfSource(VolumeAtHand{shown})->asksForSide);
}

TEST(MakeCase, SaysThatARegionHasNoUsualPlace) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeVolume(fromBehind(), folder / "v.mha"));
  NewCase wanted = named("V", VolumeFile{.file = folder / "v.mha", .answers = {}, .probeSide = VolumeSide::front});
  const auto notesFor = [&](const std::string& region) {
    wanted.region = region;
    const auto made = makeCase(wanted, folder / ("region" + std::to_string(region.size())));
    std::string all;
    if (made)
      for (const Message& each : made->notes) all += each.english() + "\n";
    return all;
  };
  EXPECT_NE(notesFor("left big toe").find("no usual place for 'left big toe'"), std::string::npos);
  EXPECT_EQ(notesFor("neck").find("no usual place"), std::string::npos);
}

TEST(MakeCase, OfAStitchedResultTakesItsVolumeAndLevel) {
  const TemporaryFolder folder;
  Volume volume = noisyVolume({12, 10, 8}, 3);
  volume.grid.spacing_mm = glm::dvec3(0.5);
  Volume level = noisyVolume({12, 10, 8}, 4);
  level.grid.spacing_mm = glm::dvec3(0.5);
  fs::create_directories(folder / "stitched");
  ASSERT_TRUE(writeVolume(volume, folder / "stitched/volume.mha"));
  ASSERT_TRUE(writeVolume(level, folder / "stitched/level.mha"));
  writeText(folder / "stitched/provenance.json", "{}");
  for (const fs::path& named_ : {folder / "stitched", folder / "stitched/volume.mha"}) {
    const auto source = sourceOf(named_);
    ASSERT_TRUE(source);
    ASSERT_TRUE(std::holds_alternative<StitchingResult>(*source)) << named_;
    const auto made = makeCase(named("S", *source), folder / ("case-" + named_.stem().string()));
    ASSERT_TRUE(made) << made.error();
    const auto echo = loadCaseVolume(made->made, noProgress());
    ASSERT_TRUE(echo);
    EXPECT_EQ(echo->volume.echo, volume.echo);
    ASSERT_TRUE(echo->tissue);
    EXPECT_EQ(echo->tissue->level, level.echo);
  }
}

TEST(MakeCase, OfNothingWaitsForAVolumeAndTakesOne) {
  const TemporaryFolder folder;
  NewCase wanted = named("Later", {});
  wanted.region = "neck";
  const auto made = makeCase(wanted, folder / "later");
  ASSERT_TRUE(made) << made.error();
  EXPECT_TRUE(hasNoVolume(made->made));
  EXPECT_TRUE(validateCase(folder / "later").empty());
  EXPECT_FALSE(caseNeedsPreparation(made->made));
  const auto loaded = loadCaseVolume(made->made, noProgress());
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().code, ErrorCode::emptyVolume);

  const std::string before = textOf(folder / "later/case.json");
  const auto given = giveVolume(made->made, SweepFile{.file = makeSweep(folder), .spacing_mm = 1.0});
  ASSERT_TRUE(given) << given.error();
  EXPECT_EQ(textOf(folder / "later/case.json"), before) << "whoever edits the case saves it";
  EXPECT_NE(given->edited.volume.fileToWorld, (Transform<frame::World, frame::File>{})) << "at the neck";
  ASSERT_TRUE(saveCase(given->edited, folder / "later"));
  EXPECT_TRUE(loadCaseVolume(given->edited, noProgress()));

  Case edited = given->edited;
  edited.targets.push_back({.kind = CaseTarget::Kind::point, .name = "p", .at_mm = glm::dvec3(1, 2, 3), .tolerance_mm = 5.0});
  edited.otherFields["echoes"] = nlohmann::json::object();  // of the volume before
  Volume other = noisyVolume({12, 10, 8}, 3);
  other.grid.spacing_mm = glm::dvec3(0.5);
  ASSERT_TRUE(writeVolume(other, folder / "other.mha"));
  const auto replaced = giveVolume(edited, VolumeFile{.file = folder / "other.mha"});
  ASSERT_TRUE(replaced) << replaced.error();
  EXPECT_EQ(replaced->edited.volume.fileToWorld, edited.volume.fileToWorld) << "the placement stays";
  EXPECT_EQ(replaced->edited.targets.size(), 1u);
  EXPECT_FALSE(replaced->edited.otherFields.contains("echoes"));
  EXPECT_TRUE(fs::exists(folder / "later" / edited.volume.file)) << "undo needs it";
  EXPECT_FALSE(fs::exists(folder / "later/.stitching"));
  EXPECT_FALSE(giveVolume(edited, std::monostate{}));
}

TEST(MakeCase, KeepsRecordedImagesBesideTheVolumeAndSlicesThem) {
  const TemporaryFolder folder;
  const auto made = makeCase(named("Images", SweepFile{.file = makeSweep(folder), .spacing_mm = 1.0, .framesEvery = 2}), folder / "images");
  ASSERT_TRUE(made) << made.error();
  const auto opened = loadCase(folder / "images");
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_TRUE(isContentNamed(opened->volume.frames)) << opened->volume.frames;
  EXPECT_TRUE(verifyCase(folder / "images"));
  EXPECT_EQ(manifestOf(*opened), manifestOf(made->made));
  const auto echo = loadCaseVolume(*opened, noProgress());
  ASSERT_TRUE(echo) << echo.error();
  ASSERT_TRUE(echo->frames);
  EXPECT_EQ(echo->frames->size(), 13u) << "of 25";
  // Among the voxels: voxel (15, 10, 12) is on the thirteenth image, whose grey it has.
  std::uint8_t grey = 0;
  echo->frames->sampleRow(Quality::linear, {15.0, 10.0, 12.0}, {0.0, 0.0, 0.0}, {0, 1}, &grey);
  EXPECT_EQ(grey, echo->volume.echo[echo->volume.grid.indexOf(15, 10, 12)]);

  Case without = *opened;
  without.volume.frames = "volumes/0123456789abcdef.igs.mha";
  const auto missing = loadCaseVolume(without, noProgress());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::notFound);
  without.volume.frames = opened->volume.file;
  EXPECT_FALSE(loadCaseVolume(without, noProgress())) << "a volume is no recording";
  nlohmann::json alone = manifestOf(*opened);
  alone["volume"].erase("file");
  EXPECT_FALSE(checkManifest(alone, {}).empty()) << "images without the volume made of them";
}

TEST(MakeCase, IsCompleteOrAbsentWhenItIsStoppedAnywhere) {
  const TemporaryFolder folder;
  const NewCase wanted = named("Stopped", SweepFile{.file = makeSweep(folder), .spacing_mm = 1.0});
  bool wasMade = false;
  for (long question = 1; question < 5000 && !wasMade; question = question * 3 / 2 + 1) {
    CountedStop stop = CountedStop::atQuestion(question);
    const auto made = makeCase(wanted, folder / "cases/stopped", stop);
    wasMade = made.has_value();
    if (wasMade) break;
    EXPECT_EQ(made.error().code, ErrorCode::cancelled) << made.error();
    EXPECT_FALSE(fs::exists(folder / "cases")) << question;
  }
  EXPECT_TRUE(wasMade);
  EXPECT_TRUE(loadCase(folder / "cases/stopped"));
}

TEST(MakeCase, RefusesAndLeavesEverythingAsItWas) {
  const TemporaryFolder folder;
  writeText(folder / "there/mine.txt", "mine");
  const auto taken = makeCase(named("T", {}), folder / "there");
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().code, ErrorCode::notWritable);
  EXPECT_EQ(makeCase(named("", {}), folder / "new").error().code, ErrorCode::badField);
  NewCase unknown = named("T", {});
  unknown.templateId = "nothing";
  const auto refused = makeCase(unknown, folder / "new");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("upper-abdomen"), std::string::npos) << refused.error();
  EXPECT_FALSE(makeCase(named("T", SweepFile{.file = folder / "nowhere.igs.mha"}), folder / "new"));
  writeText(folder / "broken.mha", "ObjectType = Image\nNDims = 3\nDimSize = 2 2");
  EXPECT_FALSE(makeCase(named("T", VolumeFile{.file = folder / "broken.mha"}), folder / "new"));
  EXPECT_FALSE(fs::exists(folder / "new"));
  EXPECT_EQ(treeOf(folder / "there").size(), 2u);
}

TEST(Templates, AreCompleteAndMakeCasesThatOpen) {
  const TemporaryFolder folder;
  const TemplateList list = listTemplates();
  for (const Error& each : list.problems) ADD_FAILURE() << each;
  ASSERT_GE(list.templates.size(), 11u);
  for (const CaseTemplate& each : list.templates) {
    EXPECT_FALSE(each.text.german.empty());
    EXPECT_FALSE(each.indications.empty());
    EXPECT_FALSE(each.targets.empty());
    ASSERT_FALSE(each.lessons.empty());
    EXPECT_FALSE(each.lessons.front().sources.empty());
    NewCase wanted = named(each.title.english, {});
    wanted.templateId = each.id;
    const auto made = makeCase(wanted, folder / each.id);
    ASSERT_TRUE(made) << each.id << ": " << made.error();
    EXPECT_TRUE(validateCase(folder / each.id).empty()) << each.id;
    EXPECT_EQ(made->made.region, each.prefilled.region);
    EXPECT_FALSE(made->made.probes.empty());
    const auto lessons = lessonsOf(made->made);
    ASSERT_TRUE(lessons);
    EXPECT_EQ(*lessons, each.lessons);
    const auto known = landmarksOf(made->made.mannequin);
    ASSERT_TRUE(known);
    EXPECT_NE(made->made.region.find(siteFor(*known, made->made.region)->region), std::string::npos) << "no site for " << made->made.region;
    const auto preset = resourceFolder();
    EXPECT_TRUE(fs::exists(*preset / "presets" / (each.preset + ".json"))) << each.preset;
  }
}

TEST(Templates, AreThereForHeartChestPelvisLimbAndBreast) {
  for (const auto& [id, region, probe] :
       {std::tuple("heart", "heart", "phased-2.5"), std::tuple("lung", "chest", "microconvex-6"),
        std::tuple("pelvis", "pelvis", "convex-3.5"), std::tuple("limb-tendon", "limb, knee", "linear-12"),
        std::tuple("breast", "breast", "linear-12")}) {
    const auto read = readTemplate(id);
    ASSERT_TRUE(read) << id << ": " << read.error();
    EXPECT_EQ(read->prefilled.region, region);
    EXPECT_EQ(read->prefilled.probes.front(), probe) << id;
    EXPECT_TRUE(read->preset.ends_with(probe)) << id << ": the preset is of another probe";
    for (const Words& each : read->targets) EXPECT_FALSE(each.german.empty()) << id;
    const auto known = landmarksOf(read->prefilled.mannequin);
    ASSERT_TRUE(known) << known.error();
    EXPECT_TRUE(knowsRegion(*known, region)) << id;
  }
}

TEST(Templates, FillOnlyWhatIsOpen) {
  const auto from = readTemplate("thyroid-and-neck");
  ASSERT_TRUE(from);
  Case edited;
  edited.region = "elbow";
  edited.probes = {"phased-2.5"};
  const Case filled = withTemplate(edited, *from);
  EXPECT_EQ(filled.region, "elbow");
  EXPECT_EQ(filled.probes, edited.probes);
  EXPECT_EQ(filled.mannequin, from->prefilled.mannequin);
  EXPECT_EQ(filled.difficulty, from->prefilled.difficulty);
}

std::vector<std::string> fieldsOf(const std::vector<CheckItem>& list, CheckItem::State state) {
  std::vector<std::string> fields;
  for (const CheckItem& each : list)
    if (each.state == state) fields.push_back(each.field);
  return fields;
}

TEST(Publishing, ListsWhatIsMissingAndRefusesUntilNothingIs) {
  const TemporaryFolder folder;
  const auto made = makeCase(named("P", {}), folder / "p");
  ASSERT_TRUE(made);
  const auto list = publishingList(made->made);
  ASSERT_TRUE(list);
  using State = CheckItem::State;
  const std::vector<std::string> expected = {"title_for_trainees", "region", "indication", "diagnosis", "volume.file", "start_pose"};
  EXPECT_EQ(fieldsOf(*list, State::missing), expected);
  const auto refused = publishCase(folder / "p", folder / "library");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("6 things"), std::string::npos) << refused.error();
  EXPECT_NE(refused.error().sentence().find("title for trainees"), std::string::npos) << refused.error();
  EXPECT_FALSE(fs::exists(folder / "library"));

  makeVolumeCase(folder / "knee", "knee");
  const auto knee = loadCase(folder / "knee");
  ASSERT_TRUE(knee);
  const auto ready = publishingList(*knee);
  ASSERT_TRUE(ready);
  EXPECT_EQ(countOf(*ready, State::missing), 0u);
  EXPECT_TRUE(publishCase(folder / "knee", folder / "library"));
  Case away = *knee;
  away.startPose->probeToWorld.matrix[3] = glm::dvec4(0, 140, 0, 1);
  EXPECT_EQ(missingForPublishing(away).front().field, "start_pose") << "it looks away from the volume";
}

TEST(Publishing, WarnsOfTargetsFilesAndTextsThatDoNotFit) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "knee", "knee");
  auto knee = loadCase(folder / "knee");
  ASSERT_TRUE(knee);
  writeText(folder / "knee/media/left-over.png", "no image");
  knee->history = "Seen by Dr. Weber.";
  knee->expertPose = knee->startPose;
  knee->targets = {{.kind = CaseTarget::Kind::point, .name = "far", .at_mm = glm::dvec3(500, 0, 0), .tolerance_mm = 5.0}};
  const auto list = publishingList(*knee);
  ASSERT_TRUE(list);
  const auto warned = fieldsOf(*list, CheckItem::State::warning);
  const auto has = [&](const std::string& field) { return std::find(warned.begin(), warned.end(), field) != warned.end(); };
  EXPECT_TRUE(has("targets[0]"));
  EXPECT_TRUE(has("history"));
  EXPECT_TRUE(has("start_pose")) << "the expert's pose gives the finding away";
  EXPECT_TRUE(has("files")) << "nothing names media/left-over.png";
  EXPECT_TRUE(has("volume.file_to_world")) << "a noise block in the middle of the body";
}

TEST(Publishing, TellsWhatALessonStillNeeds) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "knee", "knee");
  auto knee = loadCase(folder / "knee");
  ASSERT_TRUE(knee);
  Lesson lesson;
  lesson.id = "l";
  lesson.title = "First";
  LessonStep step;
  step.id = "watch";
  step.title = "Watch";
  step.task = WatchTask{};
  lesson.steps = {step};
  knee->otherFields["parts"]["lessons"] = jsonOf(std::vector{lesson});
  const auto missing = missingForPublishing(*knee);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing.front().field, "parts.lessons.lessons[0]");
  EXPECT_NE(missing.front().what.english().find("not recorded"), std::string::npos) << missing.front().what;
}

TEST(Publishing, FindsTheShippedCasesReady) {
  const auto folder = shippedCasesFolder();
  ASSERT_TRUE(folder);
  for (const Case& each : listCases(*folder).cases)
    for (const CheckItem& item : missingForPublishing(each)) ADD_FAILURE() << each.id << ": " << item.what;
}

}  // namespace
}  // namespace ew::test::new_case_test
