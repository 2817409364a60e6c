#pragma once

#include <QDir>
#include <nlohmann/json.hpp>
#include <string>

#include "ew/library/case.h"
#include "gui/support/window_fixture.h"
#include "library/temporary_folder.h"

namespace ew::ui::testing {

inline constexpr int kOpening_ms = 300000;  ///< patience for a case that is opened

inline std::string textOf(const QString& file) { return test::textOf(file.toStdString()); }

/// A test with a window on the first of several cases, which it writes itself.
class CasesFixture : public WindowFixture {
 protected:
  QString folder_;
  int made_ = 0;

  [[nodiscard]] QString writeCaseCalled(const QString& title) {
    const QString folder = files_.writeCase(QStringLiteral("case %1").arg(++made_));
    auto manifest = nlohmann::json::parse(textOf(folder + QStringLiteral("/case.json")));
    manifest["title"] = title.toStdString();
    manifest["id"] = "case-" + std::to_string(made_);
    test::writeText((folder + QStringLiteral("/case.json")).toStdString(), manifest.dump());
    return folder;
  }
  void editTitle(const std::string& title) {
    Case changed = *document().current();
    changed.title = title;
    QVERIFY(document().edit(changed, "Change the title", "title").has_value());
  }
  [[nodiscard]] CaseDocument& document() const { return window_->document(); }
  [[nodiscard]] QString openTitle() const { return document().current() ? QString::fromStdString(document().current()->title) : QString(); }
  [[nodiscard]] bool waitForRest() const {
    return waitUntil([this] { return window_->isSettled(); }, kOpening_ms);
  }
  [[nodiscard]] bool shows(const QString& title) const { return session().subject() && session().subject()->title == title.toStdString(); }
  void showFirstCase() {
    QDir(files_.path(QStringLiteral("own cases"))).removeRecursively();
    folder_ = writeCaseCalled(QStringLiteral("first"));
    showWindowWithCase(folder_);
  }
};

}  // namespace ew::ui::testing
