#include "ew/export/outbox.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>

#include "ew/export/dicom_image.h"
#include "ew/export/measurement_report.h"
#include "ew/imaging/caption.h"
#include "ew/io/dicom.h"
#include "export_world.h"
#include "orthanc.h"
#include "store_only.h"
#include "time_limit.h"

namespace ew::outbox_test {
namespace {
using namespace test;
namespace fs = std::filesystem;

GreyImage pattern(int seed) {
  GreyImage image(160, 120);
  for (std::size_t n = 0; n < image.pixels.size(); ++n)
    image.pixels[n] = static_cast<std::uint8_t>((n * 31 + static_cast<std::size_t>(seed) * 17) % 253);
  return image;
}

GreyImage withWords(GreyImage image) {
  burnCaption(viewOf(image), kNotForDiagnosis);
  return image;
}

DicomImageOptions imageNumbered(std::uint64_t n) {
  DicomImageOptions options;
  options.instanceUid = dicomUidOf(7, n);
  options.number = static_cast<int>(n);
  options.probe.name = "Test probe";
  options.taken = someStudy().begun;
  return options;
}

fs::path writeDisplayImage(const fs::path& folder, int n) {
  const fs::path file = folder / ("picture" + std::to_string(n) + ".dcm");
  EXPECT_TRUE(succeeded(writeDicomImage({pattern(n), {}}, imageNumbered(static_cast<std::uint64_t>(n)), someStudy(), file)));
  return file;
}

fs::path writeClip(const fs::path& folder) {
  DicomClip clip;
  clip.size_px = {160, 120};
  clip.times_s = {0.0, 0.04, 0.09};
  clip.still = [](std::size_t n) -> Result<Still> { return Still{pattern(100 + static_cast<int>(n)), {}}; };
  EXPECT_TRUE(succeeded(writeDicomClip(clip, imageNumbered(50), someStudy(), folder / "clip.dcm")));
  return folder / "clip.dcm";
}

fs::path writeReport(const fs::path& folder) {
  using namespace measurement;
  Worksheet sheet;
  sheet.package = "abdomen";
  sheet.title.english = "Abdomen";
  WorksheetRow row;
  row.label = "AORTA";
  row.title.english = "Abdominal aorta, diameter";
  row.value = Quantity{2.1, 0.1, Unit::cm};
  sheet.sections.push_back({{"Aorta", "Aorta"}, {row}});
  MeasurementReportOptions options;
  options.instanceUid = dicomUidOf(7, 60);
  options.made = someStudy().begun;
  EXPECT_TRUE(succeeded(writeMeasurementReport(sheet, options, someStudy(), folder / "report.dcm")));
  return folder / "report.dcm";
}

/// As versions before the common notes left it beside each copy.
std::string earlierNote(const std::string& uid, const std::string& status, const std::string& problem) {
  return "{\n  \"format\": 1,\n  \"class\": \"1.2.840.10008.5.1.4.1.1.6.1\",\n  \"instance\": \"" + uid +
         "\",\n  \"study\": \"1.3\",\n  \"series\": \"1.4\",\n  \"status\": \"" + status + "\",\n  \"attempts\": 0,\n  \"problem\": \"" +
         problem + "\"\n}\n";
}

/// Acts when the n-th object was sent or asked for.
class AtReport final : public Progress {
 public:
  AtReport(int n, std::function<void()> act) : n_(n), act_(std::move(act)) {}
  void report(const Message&, double) override {
    if (--n_ == 0) act_();
  }
  [[nodiscard]] bool cancelRequested() const override { return false; }

 private:
  int n_;
  std::function<void()> act_;
};

/// Every object is in the archive once, with its pixels.
void expectAllThere(const Orthanc& archive, int images) {
  std::vector<std::vector<std::uint8_t>> stills;
  std::size_t clips = 0, reports = 0;
  for (const fs::path& file : archive.kept()) {
    CineOptions whole;
    whole.region = 0;
    whole.pixel_mm = glm::dvec2(1.0);
    whole.keepText = true;  // the words of the simulation are burnt in, and the object says so
    const auto cine = readDicomCine(file, whole);
    if (!cine) {
      ++reports;
      continue;
    }
    if (cine->sequence.frames.size() == 3) {
      ++clips;
      std::vector<std::uint8_t> all;
      for (int n = 0; n < 3; ++n) {
        const GreyImage frame = withWords(pattern(100 + n));
        all.insert(all.end(), frame.pixels.begin(), frame.pixels.end());
      }
      EXPECT_EQ(cine->sequence.pixels, all);
    } else {
      stills.push_back(cine->sequence.pixels);
    }
  }
  std::vector<std::vector<std::uint8_t>> expected;
  for (int n = 1; n <= images; ++n) expected.push_back(withWords(pattern(n)).pixels);
  std::sort(stills.begin(), stills.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(stills.size(), expected.size());
  EXPECT_TRUE(stills == expected);
  EXPECT_EQ(clips, 1u);
  EXPECT_EQ(reports, 1u);
}

TEST(Outbox, KeepsACopyOfEachObjectOnceUntilItIsVerified) {
  const TemporaryFolder folder;
  const fs::path first = writeDisplayImage(folder.path(), 1), second = writeDisplayImage(folder.path(), 2);
  {
    auto outbox = DicomOutbox::open(folder / "outbox");
    ASSERT_TRUE(succeeded(outbox));
    EXPECT_EQ(outbox->add(first).value(), true);
    EXPECT_EQ(outbox->add(first).value(), false);
    EXPECT_EQ(outbox->add(second).value(), true);
    EXPECT_EQ(textOf(outbox->copyOf(outbox->entries().front())), textOf(first));
    OutboxEntry sent = outbox->entries().front();
    sent.status = OutboxStatus::verified;
    ASSERT_TRUE(succeeded(outbox->keep(sent)));
    EXPECT_FALSE(fs::exists(outbox->copyOf(sent)));
  }
  auto again = DicomOutbox::open(folder / "outbox");
  ASSERT_TRUE(succeeded(again));
  EXPECT_EQ(again->count(OutboxStatus::verified), 1u);
  EXPECT_EQ(again->count(OutboxStatus::waiting), 1u);
  EXPECT_EQ(again->add(first).value(), false) << "sent already";
}

TEST(Outbox, FindsACopyWhoseNoteWasNotWrittenAndRemovesOneThatIsDone) {
  const TemporaryFolder folder;
  const fs::path first = writeDisplayImage(folder.path(), 1);
  OutboxEntry entry;
  fs::path copy;
  const fs::path notes = folder / "outbox/notes";
  {
    auto outbox = DicomOutbox::open(folder / "outbox");
    ASSERT_TRUE(succeeded(outbox));
    ASSERT_TRUE(outbox->add(first).value());
    entry = outbox->entries().front();
    copy = outbox->copyOf(entry);
  }
  ASSERT_TRUE(fs::remove(notes));
  {
    auto outbox = DicomOutbox::open(folder / "outbox");
    ASSERT_TRUE(succeeded(outbox));
    ASSERT_EQ(outbox->entries().size(), 1u);
    EXPECT_EQ(outbox->entries().front(), entry);
    OutboxEntry done = entry;
    done.status = OutboxStatus::verified;
    ASSERT_TRUE(succeeded(outbox->keep(done)));
  }
  fs::copy_file(first, copy);  // as if it had stopped between the note and the removal
  auto outbox = DicomOutbox::open(folder / "outbox");
  ASSERT_TRUE(succeeded(outbox));
  EXPECT_FALSE(fs::exists(copy));
  EXPECT_EQ(outbox->count(OutboxStatus::verified), 1u);
}

TEST(Outbox, BelongsToOneProgramAtATimeAndTakesDicomAlone) {
  const TemporaryFolder folder;
  auto outbox = DicomOutbox::open(folder / "outbox");
  ASSERT_TRUE(succeeded(outbox));
  const auto second = DicomOutbox::open(folder / "outbox");
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().sentence().find("Another program"), std::string::npos);
  writeText(folder / "a.txt", "no image");
  EXPECT_FALSE(outbox->add(folder / "a.txt"));
  EXPECT_FALSE(outbox->add(folder / "missing.dcm"));
  EXPECT_TRUE(outbox->entries().empty());
}

TEST(Outbox, WhatCannotBeReadIsNamedAndHoldsNothingUp) {
  const TemporaryFolder folder;
  const fs::path first = writeDisplayImage(folder.path(), 1), second = writeDisplayImage(folder.path(), 2);
  fs::path note;
  {
    auto outbox = DicomOutbox::open(folder / "outbox");
    ASSERT_TRUE(outbox->add(first).value());
    ASSERT_TRUE(outbox->add(second).value());
    note = outbox->copyOf(outbox->entries().front()).replace_extension(".json");
  }
  const std::string good = earlierNote(note.stem().string(), "waiting", "");
  writeText(folder / "outbox/9.9.9.dcm", "");
  std::string deep;
  for (int n = 0; n < 100'000; ++n) deep += "{\"problem\":";
  for (const std::string& bad : {std::string(R"({"format":"x"})"), std::string("[]"), std::string(R"({"format": 1.5})"),
                                 std::string(R"({"format": 99})"), deep, std::string()}) {
    writeText(note, bad);
    auto outbox = DicomOutbox::open(folder / "outbox");
    ASSERT_TRUE(succeeded(outbox)) << bad.substr(0, 30);
    EXPECT_EQ(outbox->entries().size(), 1u);
    const auto unreadable = outbox->unreadable();
    ASSERT_EQ(unreadable.size(), 2u);
    EXPECT_NE((unreadable[0].sentence() + unreadable[1].sentence()).find(note.filename().string()), std::string::npos);
    EXPECT_NE((unreadable[0].sentence() + unreadable[1].sentence()).find("9.9.9.dcm"), std::string::npos);
    EXPECT_FALSE(outbox->add(first)) << "whether it was sent before is not known";
    EXPECT_EQ(textOf(note), bad) << "left as it is";
    DicomArchive archive;
    archive.host = "127.0.0.1";
    archive.port = freePort();
    archive.aeTitle = "NOBODY";
    RetryOptions options;
    options.mostRounds = 1;
    const auto sent = sendOutbox(*outbox, archive, options);
    ASSERT_TRUE(succeeded(sent));
    EXPECT_EQ(sent->left, 3u);
    EXPECT_NE(sent->problem.english().find("9.9.9.dcm"), std::string::npos) << sent->problem;
  }
  std::string odd = good;
  odd.replace(odd.find("\"attempts\": 0"), 13, "\"attempts\": 99999999999999");
  writeText(note, odd);
  EXPECT_EQ(DicomOutbox::open(folder / "outbox")->entries().size(), 2u);
}

TEST(Outbox, OfAnEarlierVersionGoesOnWhereItStood) {
  const TemporaryFolder folder;
  const auto uid = [](std::uint64_t n) { return dicomUidOf(7, n); };
  fs::create_directory(folder / "outbox");
  for (int n = 1; n <= 4; ++n)
    fs::copy_file(writeDisplayImage(folder.path(), n), folder / ("outbox/" + uid(static_cast<std::uint64_t>(n)) + ".dcm"));
  writeText(folder / ("outbox/" + uid(1) + ".json"), earlierNote(uid(1), "refused", "no room"));
  writeText(folder / ("outbox/" + uid(2) + ".json"), earlierNote(uid(2), "stored", ""));
  writeText(folder / ("outbox/" + uid(3) + ".json"), earlierNote(uid(3), "verified", ""));  // stopped before the removal
  for (int opened = 0; opened < 2; ++opened) {
    auto outbox = DicomOutbox::open(folder / "outbox");
    ASSERT_TRUE(succeeded(outbox));
    ASSERT_EQ(outbox->entries().size(), 4u);
    const OutboxEntry& refused = *outbox->find(uid(1));
    EXPECT_EQ(refused.status, OutboxStatus::refused);
    EXPECT_EQ(refused.problem, "no room");
    EXPECT_EQ(refused.attempts, 0);
    EXPECT_EQ(aboutOf(refused, kObjectClass), "1.2.840.10008.5.1.4.1.1.6.1");
    EXPECT_EQ(aboutOf(refused, kObjectStudy), "1.3");
    EXPECT_EQ(aboutOf(refused, kObjectSeries), "1.4");
    EXPECT_EQ(outbox->find(uid(2))->status, OutboxStatus::stored);
    EXPECT_EQ(outbox->find(uid(3))->status, OutboxStatus::verified);
    EXPECT_EQ(outbox->find(uid(4))->status, OutboxStatus::waiting);
    EXPECT_EQ(outbox->add(folder / "picture3.dcm").value(), false) << "sent already";
    EXPECT_EQ(namesIn(folder / "outbox"), (std::set<std::string>{".lock", "notes", uid(1) + ".dcm", uid(2) + ".dcm", uid(4) + ".dcm"}));
  }
}

TEST(Outbox, IsForItsOwnerAlone) {
  const TemporaryFolder folder;
  auto outbox = DicomOutbox::open(folder / "outbox");
  ASSERT_TRUE(outbox->add(writeDisplayImage(folder.path(), 1)).value());
  EXPECT_EQ(fs::status(folder / "outbox").permissions(), fs::perms::owner_all);
  for (const auto& each : fs::directory_iterator(folder / "outbox"))
    EXPECT_EQ(each.status().permissions(), fs::perms::owner_read | fs::perms::owner_write) << each.path();
  outbox = Result<DicomOutbox>(tl::unexpected(Error{}));
  writeText(folder / "outbox/.ew-private-Abc123", "half");
  outbox = DicomOutbox::open(folder / "outbox");
  EXPECT_FALSE(fs::exists(folder / "outbox/.ew-private-Abc123")) << "left by a program that was ended";
}

TEST(Outbox, OfAnEarlierVersionIsClosedToOthersAndWhatElseLiesThereIsNot) {
  const TemporaryFolder folder;
  const auto loose = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read | fs::perms::others_read;
  const auto closed = fs::perms::owner_read | fs::perms::owner_write;
  const auto modeOf = [](const fs::path& file) { return fs::status(file).permissions(); };
  std::vector<fs::path> own = {folder / "outbox/.lock", folder / "outbox/9.9.9.dcm", folder / "outbox/9.9.9.json"};
  {
    auto outbox = DicomOutbox::open(folder / "outbox");
    ASSERT_TRUE(succeeded(outbox));
    ASSERT_TRUE(outbox->add(writeDisplayImage(folder.path(), 1)).value());
    own.push_back(outbox->copyOf(outbox->entries().front()));
    own.push_back(fs::path(own.back()).replace_extension(".json"));
    writeText(own.back(), earlierNote(own.back().stem().string(), "waiting", ""));
    own.push_back(folder / "outbox/notes");
  }
  writeText(folder / "outbox/9.9.9.dcm", "cannot be read");
  writeText(folder / "outbox/9.9.9.json", "nor can its note");
  const std::vector<fs::path> others = {folder / "outbox/holiday.dcm", folder / "outbox/settings.json", folder / "outbox/1.2.3.txt",
                                        folder / "elsewhere.dcm"};
  for (const fs::path& file : others) writeText(file, "of somebody else");
  fs::create_symlink(folder / "elsewhere.dcm", folder / "outbox/1.2.3.dcm");
  for (const fs::path& file : own) fs::permissions(file, loose);
  for (const fs::path& file : others) fs::permissions(file, loose);
  fs::permissions(folder / "outbox", fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec);
  const auto outbox = DicomOutbox::open(folder / "outbox");
  ASSERT_TRUE(succeeded(outbox));
  EXPECT_EQ(outbox->entries().size(), 1u);
  const fs::path takenOver = own[own.size() - 2];
  EXPECT_FALSE(fs::exists(takenOver)) << "its note is among the others now";
  std::erase(own, takenOver);
  for (const fs::path& file : own) EXPECT_EQ(modeOf(file), closed) << file;
  for (const fs::path& file : others) EXPECT_EQ(modeOf(file), loose) << file;
}

TEST(Sending, WithoutAnArchiveWaitsLongerEachTimeAndLosesNothing) {
  const TemporaryFolder folder;
  auto outbox = DicomOutbox::open(folder / "outbox");
  ASSERT_TRUE(succeeded(outbox));
  ASSERT_TRUE(outbox->add(writeDisplayImage(folder.path(), 1)).value());
  DicomArchive archive;
  archive.host = "127.0.0.1";
  archive.port = freePort();
  archive.aeTitle = "NOBODY";
  std::vector<double> waits;
  RetryOptions options;
  options.mostRounds = 5;
  options.longestWait_s = 3.0;
  options.wait = [&](double seconds) {
    waits.push_back(seconds);
    return true;
  };
  const auto result = sendOutbox(*outbox, archive, options);
  ASSERT_TRUE(succeeded(result));
  EXPECT_EQ(waits, (std::vector<double>{1.0, 2.0, 3.0, 3.0}));
  EXPECT_EQ(result->rounds, 5);
  EXPECT_EQ(result->left, 1u);
  EXPECT_FALSE(result->problem.empty());
  archive.aeTitle = "A TITLE WITH BLANKS";
  EXPECT_FALSE(sendOutbox(*outbox, archive, options));
}

/// A port where connections are taken and nobody ever says a word.
class SilentPort {
 public:
  SilentPort() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0);
    EXPECT_EQ(::listen(socket_, 8), 0);
    EXPECT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    number_ = ntohs(address.sin_port);
  }
  ~SilentPort() { ::close(socket_); }
  SilentPort(const SilentPort&) = delete;
  SilentPort& operator=(const SilentPort&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int socket_;
  int number_ = 0;
};

/// Lets the work go on until it has asked so often.
class StopsAfter final : public Progress {
 public:
  explicit StopsAfter(int asked) : left_(asked) {}
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return --left_ < 0; }

 private:
  mutable int left_;
};

TEST(Sending, StopsAtOnceWhenToldWhileTheArchiveIsSilent) {
  const TemporaryFolder folder;
  auto outbox = DicomOutbox::open(folder / "outbox");
  ASSERT_TRUE(succeeded(outbox));
  ASSERT_TRUE(outbox->add(writeDisplayImage(folder.path(), 1)).value());
  const SilentPort port;
  DicomArchive archive;
  archive.host = "127.0.0.1";
  archive.port = port.number();
  archive.aeTitle = "SILENT";
  archive.timeout_s = 3600.0;  // what a wait that is not stopped would take
  StopsAfter sending(10), asking(10);
  const auto sent = sendOutbox(*outbox, archive, {}, sending);
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().code, ErrorCode::cancelled);
  EXPECT_EQ(outbox->count(OutboxStatus::waiting), 1u);
  const auto asked = askArchive(archive, asking);
  ASSERT_FALSE(asked);
  EXPECT_EQ(asked.error().code, ErrorCode::cancelled);
}

TEST(Sending, GivesUpASilentArchiveAfterItsTimeout) {
  const SilentPort port;
  DicomArchive archive;
  archive.host = "127.0.0.1";
  archive.port = port.number();
  archive.aeTitle = "SILENT";
  archive.timeout_s = 1.0;
  const auto asked = askArchive(archive);
  ASSERT_FALSE(asked);
  EXPECT_EQ(asked.error().code, ErrorCode::notReadable);
}

TEST(Sending, BringsImagesClipAndReportToARealArchiveOnceEach) {
  EW_NEEDS_PROGRAM("Orthanc");
  const TemporaryFolder folder;
  Orthanc archive(folder / "orthanc");
  ASSERT_TRUE(archive.start()) << archive.said();
  auto outbox = DicomOutbox::open(folder / "outbox");
  ASSERT_TRUE(succeeded(outbox));
  for (const fs::path& file :
       {writeDisplayImage(folder.path(), 1), writeDisplayImage(folder.path(), 2), writeClip(folder.path()), writeReport(folder.path())})
    ASSERT_TRUE(outbox->add(file).value());
  RetryOptions once;
  once.mostRounds = 1;
  const auto result = sendOutbox(*outbox, archive.address(), once);
  ASSERT_TRUE(succeeded(result));
  EXPECT_EQ(result->verified, 4u) << result->problem;
  EXPECT_EQ(result->left, 0u);
  EXPECT_EQ(outbox->count(OutboxStatus::verified), 4u);
  expectAllThere(archive, 2);
}

TEST(Sending, GoesOnWhenTheArchiveIsKilledInTheMiddleAndComesBack) {
  EW_NEEDS_PROGRAM("Orthanc");
  const TemporaryFolder folder;
  for (const int killedAt : {1, 3, 6}) {  // between the first objects, in the middle, while it is asked
    const fs::path own = folder / std::to_string(killedAt);
    fs::create_directories(own);
    Orthanc archive(own / "orthanc");
    ASSERT_TRUE(archive.start()) << archive.said();
    auto outbox = DicomOutbox::open(own / "outbox");
    ASSERT_TRUE(succeeded(outbox));
    for (const fs::path& file :
         {writeDisplayImage(own, 1), writeDisplayImage(own, 2), writeDisplayImage(own, 3), writeClip(own), writeReport(own)})
      ASSERT_TRUE(outbox->add(file).value());
    AtReport progress(killedAt, [&] { archive.kill(); });
    RetryOptions options;
    options.wait = [&](double) {
      EXPECT_TRUE(archive.start()) << archive.said();
      return true;
    };
    const auto result = sendOutbox(*outbox, archive.address(), options, progress);
    ASSERT_TRUE(succeeded(result));
    EXPECT_GE(result->rounds, 2);
    EXPECT_EQ(result->left, 0u) << result->problem;
    EXPECT_EQ(outbox->count(OutboxStatus::verified), 5u);
    expectAllThere(archive, 3);
  }
}

TEST(Sending, TakesTheWordOfAnArchiveThatCannotBeAsked) {
  EW_NEEDS_PROGRAM("storescp");
  const TemporaryFolder folder;
  // The second takes the default transfer syntax alone.
  for (const char* option : {static_cast<const char*>(nullptr), "+xi"}) {
    const fs::path own = folder / (option == nullptr ? "any" : "implicit");
    fs::create_directories(own);
    const Storescp gateway(own / "kept", option);
    auto outbox = DicomOutbox::open(own / "outbox");
    ASSERT_TRUE(succeeded(outbox));
    for (const fs::path& file : {writeDisplayImage(own, 1), writeClip(own), writeReport(own)}) ASSERT_TRUE(outbox->add(file).value());
    RetryOptions options;
    options.wait = [](double) {
      ADD_FAILURE() << "there is nothing to wait for";
      return false;
    };
    const auto result = sendOutbox(*outbox, gateway.address(), options);
    ASSERT_TRUE(succeeded(result));
    EXPECT_EQ(result->accepted, 3u) << result->problem;
    EXPECT_EQ(result->verified, 0u);
    EXPECT_EQ(result->refused, 0u);
    EXPECT_EQ(result->left, 0u);
    EXPECT_EQ(result->rounds, 1);
    EXPECT_TRUE(result->problem.empty()) << result->problem;
    EXPECT_EQ(gateway.kept().size(), 3u);
    EXPECT_EQ(outbox->count(OutboxStatus::accepted), 3u);
    for (const OutboxEntry& entry : outbox->entries()) EXPECT_FALSE(fs::exists(outbox->copyOf(entry)));
    // Pixels arrive as they are, whatever they were packed in.
    int images = 0;
    for (const fs::path& file : gateway.kept()) {
      CineOptions whole;
      whole.region = 0;
      whole.pixel_mm = glm::dvec2(1.0);
      whole.keepText = true;  // the words of the simulation are burnt in, and the object says so
      const auto cine = readDicomCine(file, whole);
      if (!cine || cine->sequence.frames.size() != 1) continue;
      ++images;
      EXPECT_EQ(cine->sequence.pixels, withWords(pattern(1)).pixels);
    }
    EXPECT_EQ(images, 1);
  }
}

TEST(Sending, WhatWaitsToBeAskedForLeavesTheOutboxOfAnArchiveThatCannotBeAsked) {
  EW_NEEDS_PROGRAM("storescp");
  const TemporaryFolder folder;
  const Storescp gateway(folder / "kept");
  {
    auto outbox = DicomOutbox::open(folder / "outbox");
    ASSERT_TRUE(succeeded(outbox));
    ASSERT_TRUE(outbox->add(writeDisplayImage(folder.path(), 1)).value());
    OutboxEntry entry = outbox->entries().front();
    entry.status = OutboxStatus::stored;  // as an earlier connection left it
    ASSERT_TRUE(succeeded(outbox->keep(entry)));
  }
  {
    auto outbox = DicomOutbox::open(folder / "outbox");
    ASSERT_TRUE(succeeded(outbox));
    RetryOptions once;
    once.mostRounds = 1;
    const auto result = sendOutbox(*outbox, gateway.address(), once);
    ASSERT_TRUE(succeeded(result));
    EXPECT_EQ(result->accepted, 1u) << result->problem;
    EXPECT_TRUE(result->problem.empty()) << result->problem;
  }
  const auto later = DicomOutbox::open(folder / "outbox");
  ASSERT_TRUE(succeeded(later));
  EXPECT_EQ(later->count(OutboxStatus::accepted), 1u) << "its note is read again";
}

TEST(Sending, EndsWithAnArchiveThatRefusesQuestions) {
  const TemporaryFolder folder;
  for (const auto how : {RefusesQuestions::How::says, RefusesQuestions::How::hangsUp}) {
    const fs::path own = folder / (how == RefusesQuestions::How::says ? "says" : "hangsUp");
    fs::create_directories(own);
    const RefusesQuestions archive(how);
    auto outbox = DicomOutbox::open(own / "outbox");
    ASSERT_TRUE(succeeded(outbox));
    for (const fs::path& file : {writeDisplayImage(own, 1), writeDisplayImage(own, 2), writeReport(own)})
      ASSERT_TRUE(outbox->add(file).value());
    RetryOptions options;
    options.wait = [](double) { return true; };
    const auto result = sendOutbox(*outbox, archive.address(), options);
    ASSERT_TRUE(succeeded(result));
    EXPECT_EQ(archive.stored(), 3);
    EXPECT_EQ(result->accepted, 3u) << result->problem;
    EXPECT_EQ(result->left, 0u);
    EXPECT_LE(result->rounds, 3);
    EXPECT_TRUE(result->problem.empty()) << result->problem;
  }
}

}  // namespace
}  // namespace ew::outbox_test
