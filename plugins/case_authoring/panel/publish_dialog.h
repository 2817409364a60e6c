#pragma once

#include <QDialog>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "ew/library/instructor_key.h"
#include "ew/library/publishing.h"
#include "ew/sdk/host.h"

class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace ew::case_authoring {

/// What the open case has and lacks before it is handed to trainees, each line a way to where it is written; and the two ways to hand it
/// on: published in the library of this workstation, or as a bundle for another one. It stays open beside the form, and follows its edits.
class PublishDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit PublishDialog(sdk::Host& host, QWidget* parent = nullptr);
  /// Looks at the case again: its files have changed, of which it hears nothing else.
  void checkSoon() { soon_.start(); }

 Q_SIGNALS:
  void fieldAsked(const QString& path);

 private:
  void check();
  void showList(const std::vector<CheckItem>& list);
  void addItem(QVBoxLayout& rows, const CheckItem& item, int number);
  void showButtons();
  /// Saves what is not saved. @return whether it is
  [[nodiscard]] bool saved();
  void publish();
  void exportCase();
  void exportExamination();
  /// Where a bundle is to be written. @param name that is proposed, without its ending
  [[nodiscard]] std::optional<std::filesystem::path> askForBundle(const QString& title, const QString& name);
  [[nodiscard]] std::optional<PublicKey> instructorsKey();
  void tell(const QString& sentence, bool isProblem);

  sdk::Host& host_;
  QLabel* summary_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  QLabel* result_ = nullptr;
  QLabel* problem_ = nullptr;
  QPushButton* publish_ = nullptr;
  QPushButton* export_ = nullptr;
  QPushButton* examination_ = nullptr;
  std::size_t missing_ = 0;
  int checking_ = 0;    ///< number of the check that is waited for; 0: none
  bool again_ = false;  ///< the case changed meanwhile
  bool working_ = false;
  std::shared_ptr<const Volume> volume_;  ///< that was checked last
  std::string volumeFile_;
  QTimer soon_;  ///< of rest: what is typed is not checked letter by letter
  sdk::Cases::Ticket ticket_;
};

}  // namespace ew::case_authoring
