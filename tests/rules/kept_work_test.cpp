#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>

#include "rules/source_tree.h"

// Nothing is replaced and nothing is thrown away unasked: where to save is asked in one place, which asks about what is there; what is
// scanned is replaced in one place, which asks every holder of unsaved work; and "saved" is what was written, not a flag.
namespace ew::rules::kept_work_test {
namespace {

/// Whether a source is worth looking through: an expression over the whole tree takes seconds.
bool has(const Source& source, std::initializer_list<const char*> any) {
  return std::any_of(any.begin(), any.end(), [&](const char* word) { return source.text.find(word) != std::string::npos; });
}

std::vector<Offence> ownSaveQuestion(const Source& source) {
  if (!has(source, {"getSaveFile", "AcceptSave"})) return {};
  return matchesOf(source, "getSaveFileName|getSaveFileUrl|AcceptSave");
}

std::vector<Offence> ownReplacing(const Source& source) {
  if (!has(source, {"session.show(", "session_.show(", "session.clear(", "session_.clear(", "ession->show(", "ession_->show(",
                    "session().show(", "session().clear("}))
    return {};
  return matchesOf(source, "\\b(session|session_|session\\(\\))(\\.|->)(show|clear)\\(");
}

std::vector<Offence> ownAsking(const Source& source) {
  if (!has(source, {"mayLose"})) return {};
  return matchesOf(source, "\\bmayLose\\(");
}

std::vector<Offence> savedByFlag(const Source& source) {
  if (!has(source, {"setSaved(", "aved_ =", "aved =", "odified_ =", "odified ="})) return {};
  return matchesOf(source,
                   "\\bsetSaved\\(\\s*\\)|\\b(is)?(unsaved|Unsaved|saved|Saved|modified|Modified|hasUnsaved)_?\\s*=\\s*(true|false)\\b");
}

TEST(KeptWork, IsAskedWhereToInOnePlace) {
  const std::vector<Exception> exceptions = {{"workstation/widgets/src/save_file.cpp", "The one place."}};
  EXPECT_EQ(
      brokenBy(
          ownSaveQuestion, exceptions,
          "ask with askSaveFile() of the window, a plugin with sdk::Window::askSaveFile(): the name is completed before the question."),
      "");
}

TEST(KeptWork, IsAskedAboutByTheOnePlaceThatReplacesTheScan) {
  const std::vector<Exception> exceptions = {
      {"workstation/ui/src/import/opener.cpp", "The one place."},
      {"workstation/ui/src/import/opener_scan.cpp", "The same, for what it has opened."},
      {"workstation/ui/src/images/image_tile.cpp", "An image beside the scan, which is emptied when that was replaced."},
  };
  EXPECT_EQ(brokenBy(ownReplacing, exceptions, "let the Opener show it, which asks every holder of unsaved work."), "");
}

TEST(KeptWork, IsHeldInOneList) {
  const std::vector<Exception> exceptions = {
      {"workstation/ui/src/window/features/opening.cpp", "The one place that opens."},
      {"workstation/ui/src/window/main_window.cpp", "The one place that closes."},
      {"workstation/ui/src/window/frame/unsaved_work.h", "The list itself."},
      {"workstation/ui/src/window/frame/unsaved_work.cpp", "The list itself."},
  };
  EXPECT_EQ(brokenBy(ownAsking, exceptions, "ask with Opening::mayReplaceShown(), mayReplaceScan() or MainWindow::mayClose()."), "");
}

TEST(KeptWork, CountsAsSavedByWhatWasWritten) {
  EXPECT_EQ(
      brokenBy(savedByFlag, {}, "keep the revision, or the value, that the job which saves began with: what came since is not saved."), "");
}

TEST(KeptWork, IsFoundWhenARuleIsBroken) {
  EXPECT_EQ(ownSaveQuestion({"a.cpp", "file = QFileDialog::getSaveFileName(this, tr(\"Save\"));"}).size(), 1U);
  EXPECT_EQ(ownSaveQuestion({"a.cpp", "dialog.setAcceptMode(QFileDialog::AcceptSave);"}).size(), 1U);
  EXPECT_EQ(ownReplacing({"a.cpp", "parts_->session.show(std::move(subject));\nsession_.clear();"}).size(), 2U);
  EXPECT_TRUE(ownReplacing({"a.cpp", "session_.showLabels({});"}).empty());
  EXPECT_EQ(ownAsking({"a.cpp", "if (p.unsaved.mayLose(Loss::scan, {})) go();"}).size(), 1U);
  EXPECT_EQ(savedByFlag({"a.cpp", "stored.setSaved();"}).size(), 1U);
  EXPECT_EQ(savedByFlag({"a.cpp", "unsaved_ = false;"}).size(), 1U);
  EXPECT_TRUE(savedByFlag({"a.cpp", "stored.setSaved(revision);"}).empty());
}

}  // namespace
}  // namespace ew::rules::kept_work_test
