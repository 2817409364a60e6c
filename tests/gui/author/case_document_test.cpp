// Who edits a case: one document at a time, between windows and between programs; and what is left when a program is killed while it saves.
#include <QCoreApplication>
#include <QProcess>
#include <QTest>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <random>

#include "ew/library/edit_autosave.h"
#include "ew/library/folder_lease.h"
#include "ew/ui_test_door/case_document.h"
#include "library/small_case.h"
#include "library/temporary_folder.h"

namespace ew::ui {
namespace {

namespace fs = std::filesystem;

Result<void> editTitle(CaseDocument& document, const std::string& title, const std::string& mergeKey = {}) {
  Case changed = *document.current();
  changed.title = title;
  return document.edit(changed, "Change the title", mergeKey);
}

bool openIn(CaseDocument& document, const fs::path& folder) {
  auto read = readCase(folder);
  if (!read) return false;
  document.open(std::move(read->opened), read->manifest);
  return true;
}

std::string contextOf(const Error& problem, const std::string& name) {
  for (const auto& [key, value] : problem.context)
    if (key == name) return value;
  return {};
}

std::string titleOf(long number) { return "title " + std::to_string(number); }

/// What the program that is killed does: edits, keeps the edits, says so, saves, again and again.
int saveUntilKilled(const fs::path& folder, const fs::path& kept) {
  CaseDocument document;
  EditAutosave edits(kept);
  if (!openIn(document, folder)) return 1;
  const std::string before = document.current()->title;
  for (long n = std::stol(before.substr(before.find(' ') + 1)) + 1;; ++n) {
    if (!editTitle(document, titleOf(n))) return 2;
    if (!edits.keep(*document.current(), *document.asRead())) return 3;
    std::printf("%ld\n", n);
    std::fflush(stdout);
    if (!document.save()) return 4;
    edits.forget();
  }
}

}  // namespace

class CaseDocumentTest : public QObject {
  Q_OBJECT

  std::unique_ptr<test::TemporaryFolder> home_;
  [[nodiscard]] fs::path folder() const { return *home_ / "own"; }

 private Q_SLOTS:
  void init() {
    home_ = std::make_unique<test::TemporaryFolder>();
    test::makeSmallCase(folder());
  }
  void cleanup() { home_.reset(); }

  void lookingKeepsNobodyFromEditing() {
    CaseDocument looks, edits;
    QVERIFY(openIn(looks, folder()) && openIn(edits, folder()));
    QVERIFY(!FolderLease::holderOf(folder()));
    QVERIFY(editTitle(edits, "Edited").has_value());
    QVERIFY(FolderLease::holderOf(folder()).has_value());
  }

  void editsOfOneKeyAreOneStepUntilItIsSavedAndOneThatIsGivenBackIsNone() {
    CaseDocument document;
    QVERIFY(openIn(document, folder()));
    const std::string first = document.current()->title;
    for (const char* title : {"S", "Se", "Second"}) QVERIFY(editTitle(document, title, "title").has_value());
    QCOMPARE(document.history().steps(), std::size_t{1});
    QCOMPARE(document.history().undoName(), std::string("Change the title"));
    QVERIFY(document.hasUnsavedChanges() && document.save().has_value());
    QVERIFY(!document.hasUnsavedChanges());
    QVERIFY(editTitle(document, "Third", "title").has_value());
    QCOMPARE(document.history().steps(), std::size_t{2});
    QVERIFY(editTitle(document, "Second", "title").has_value());
    QCOMPARE(document.history().steps(), std::size_t{1});
    QVERIFY(!document.hasUnsavedChanges() && !document.history().canRedo());
    document.undo();
    QCOMPARE(document.current()->title, first);
    QVERIFY(document.hasUnsavedChanges());
    document.redo();
    QVERIFY(!document.hasUnsavedChanges());
    document.undo();
    QVERIFY(editTitle(document, "Fourth").has_value());
    document.undo();
    QVERIFY(document.hasUnsavedChanges());  // what was saved is no longer among the steps
    document.forgetSteps();
    QVERIFY(!document.hasUnsavedChanges() && !document.history().canUndo() && !document.history().canRedo());
    QCOMPARE(document.current()->title, first);
  }

  void whoComesSecondIsToldWhoEditsAndSinceWhen() {
    CaseDocument first, second;
    QVERIFY(openIn(first, folder()) && openIn(second, folder()));
    QVERIFY(editTitle(first, "First").has_value());
    const auto refused = editTitle(second, "Second");
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::notWritable);
    const auto holder = FolderLease::holderOf(folder());
    QVERIFY(holder.has_value());
    QCOMPARE(contextOf(refused.error(), "user"), holder->user);
    QCOMPARE(contextOf(refused.error(), "host"), holder->host);
    QVERIFY2(refused.error().sentence().find("since 20") != std::string::npos, refused.error().sentence().c_str());
    QCOMPARE(second.current()->title, std::string("Small"));
    QVERIFY(!second.hasUnsavedChanges() && !second.history().canUndo());
    QVERIFY(!second.save());  // nor is the old state saved over what the first one makes
    QVERIFY(first.save().has_value());
    first.close();
    QVERIFY(!FolderLease::holderOf(folder()));
    QVERIFY(openIn(second, folder()));
    QVERIFY(editTitle(second, "Second").has_value());
    QVERIFY(second.save().has_value());
    QCOMPARE(loadCase(folder())->title, std::string("Second"));
  }

  void aCopyIsEditedMeanwhile() {
    CaseDocument first, second;
    QVERIFY(openIn(first, folder()) && openIn(second, folder()));
    QVERIFY(editTitle(first, "First").has_value());
    const fs::path copy = *home_ / "copy";
    QVERIFY(second.save(copy).has_value());
    QVERIFY(editTitle(second, "Second").has_value());
    QVERIFY(second.save().has_value());
    QVERIFY(first.save().has_value());
    QCOMPARE(loadCase(folder())->title, std::string("First"));
    QCOMPARE(loadCase(copy)->title, std::string("Second"));
    for (const auto& entry : fs::directory_iterator(copy))  // its own alone, none that came along
      if (isLeaseFile(entry.path())) QVERIFY(FolderLease::holderOf(copy).has_value());
  }

  void whatWasTakenOverIsSavedElsewhereAlone() {
    CaseDocument slept;
    QVERIFY(openIn(slept, folder()));
    QVERIFY(editTitle(slept, "Slept").has_value());
    QTest::qWait(20);
    auto taken = FolderLease::take(folder(), {.staleAfter = std::chrono::seconds(0)});  // as if it had slept for minutes
    QVERIFY2(taken, taken ? "" : taken.error().sentence().c_str());
    int lost = 0;
    connect(&slept, &CaseDocument::leaseLost, this, [&lost] { ++lost; });
    const auto refused = slept.save();
    QVERIFY(!refused);
    QVERIFY(!contextOf(refused.error(), "user").empty());
    QCOMPARE(lost, 1);
    QVERIFY(slept.lost().has_value() && slept.hasUnsavedChanges());
    QCOMPARE(loadCase(folder())->title, std::string("Small"));
    QVERIFY(editTitle(slept, "Slept well").has_value());  // what is under way may be finished
    const fs::path copy = *home_ / "copy";
    QVERIFY(slept.save(copy).has_value());
    QVERIFY(!slept.lost());
    QCOMPARE(loadCase(copy)->title, std::string("Slept well"));
    QVERIFY(editTitle(slept, "On").has_value() && slept.save().has_value());
    QVERIFY(taken->refresh().has_value());  // theirs was left alone
  }

  void aFolderThatCannotBeWrittenIsLookedAtAndSavedElsewhere() {
    CaseDocument document;
    QVERIFY(openIn(document, folder()));
    fs::permissions(folder(), fs::perms::owner_read | fs::perms::owner_exec);
    std::FILE* written = std::fopen((folder() / "probe").c_str(), "w");
    if (written != nullptr) {
      std::fclose(written);
      QSKIP("whoever runs this may write everywhere");
    }
    QVERIFY(editTitle(document, "Edited").has_value());
    QVERIFY(!document.save());
    QVERIFY(document.save(*home_ / "copy").has_value());
  }

  void aProgramThatIsKilledWhileItSavesLosesNothing() {
    auto manifest = nlohmann::json::parse(test::textOf(folder() / "case.json"));
    manifest["title"] = titleOf(0);
    manifest["history"] = std::string(400'000, 'x');  // so that saving takes a while
    test::writeText(folder() / "case.json", manifest.dump());
    const fs::path kept = *home_ / "kept";
    std::mt19937 random(7);
    int before = 0, after = 0, offered = 0;
    long saved = 0;
    for (int round = 0; round < 50; ++round) {
      QProcess program;
      program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
      program.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("--save"), QString::fromStdString(folder().string()), QString::fromStdString(kept.string())});
      QVERIFY(program.waitForStarted());
      QVERIFY(program.waitForReadyRead(60000));
      QTest::qSleep(static_cast<int>(random() % 25));
      program.kill();
      QVERIFY(program.waitForFinished());
      QCOMPARE(program.exitStatus(), QProcess::CrashExit);
      const QList<QByteArray> lines = program.readAllStandardOutput().split('\n');
      const long said = lines.at(lines.size() - 2).toLong();  // the last whole line: that edit was kept, and its saving begun
      QVERIFY(said > saved);
      const auto opened = loadCase(folder());
      QVERIFY2(opened, opened ? "" : opened.error().sentence().c_str());
      const bool isNew = opened->title == titleOf(said);
      QVERIFY2(isNew || opened->title == titleOf(said - 1), opened->title.c_str());
      (isNew ? after : before) += 1;
      const auto left = EditAutosave(kept).left();
      if (!isNew) {
        QCOMPARE(left.size(), std::size_t(1));
        QCOMPARE(left.front().manifest["title"].get<std::string>(), titleOf(said));
        QCOMPARE(left.front().caseFolder, folder());
      }
      for (const auto& each : left) {
        ++offered;
        CaseDocument document;
        QVERIFY(openIn(document, folder()));
        const auto restored = document.restore(*caseFromManifest(each.manifest, each.caseFolder), "Take over", each.asRead);
        QVERIFY2(restored, restored ? "" : restored.error().sentence().c_str());
        document.close();
        EditAutosave::remove(each);
      }
      saved = isNew ? said : said - 1;
    }
    qInfo("of 50 kills %d left the last saved case, %d the new one; edits offered after %d", before, after, offered);
    QVERIFY2(before > 0 && offered > 0, qPrintable(QStringLiteral("%1 before, %2 after, %3 offered").arg(before).arg(after).arg(offered)));
  }
};

}  // namespace ew::ui

int main(int argc, char** argv) {
  QCoreApplication app(argc, argv);
  if (argc == 4 && std::string(argv[1]) == "--save") return ew::ui::saveUntilKilled(argv[2], argv[3]);
  ew::ui::CaseDocumentTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "case_document_test.moc"
