#pragma once

#include <QDialog>
#include <functional>
#include <optional>
#include <vector>

#include "ew/library/case_contents.h"
#include "ew/sdk/host.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace ew::case_authoring {

/// The files in the folder of the open case: how large they are, what uses each, and those that nothing uses to be taken out, so that they
/// are not handed on. What was taken out lies aside and can be put back.
class FilesDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit FilesDialog(sdk::Host& host, QWidget* parent = nullptr);

 Q_SIGNALS:
  void filesChanged();

 private:
  struct Found {
    std::vector<CaseFileUse> uses;
    std::vector<WithdrawnFiles> withdrawn;
  };
  /// Reads anew what is there, in a job, and shows it. @param said what went wrong before, which stays to be read
  void look(const std::optional<Error>& said = {});
  void showFiles(const Found& found, const std::optional<Error>& problem);
  void moveFiles(const QString& title, std::function<Result<void>()> work);  ///< in a job, then looks
  void showChosen();
  void takeOut();
  void putBackLatest();
  void fail(const Error& problem);

  sdk::Host& host_;
  QTreeWidget* list_ = nullptr;
  QLabel* aside_ = nullptr;
  QLabel* problem_ = nullptr;
  QPushButton* takeOut_ = nullptr;
  QPushButton* putBack_ = nullptr;
  std::vector<WithdrawnFiles> withdrawn_;  ///< the latest first
  int looks_ = 0;                          ///< so far: what an earlier one found is not shown
  bool isMoving_ = false;                  ///< one job at a time moves files
  sdk::Cases::Ticket ticket_;
};

}  // namespace ew::case_authoring
