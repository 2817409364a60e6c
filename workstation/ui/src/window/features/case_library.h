#pragma once

#include <QString>
#include <QTimer>

#include "window/frame/feature.h"

class QMenu;

namespace ew::ui {

/// The start page: what the library's index finds, with what is read for the cards in sight; what comes into the library and leaves it.
class CaseLibrary final : public Feature {
  Q_OBJECT

 public:
  explicit CaseLibrary(WindowParts& parts);

  void addImportAction(QMenu& file);
  void addStartActions(QMenu& file);
  void connectParts() override;

  void fill();                             ///< the page, with the cases as they are now
  void readDetails();                      ///< of the cards in sight
  void importCase(const QString& bundle);  ///< into the user's library, as a job; then the start page shows it
  void forgetImported() { imported_.clear(); }

 private:
  void chooseBundle();
  void withdraw(const QString& folder, const QString& title);  ///< takes a case out of the library, after a question

  QTimer detailsSoon_;
  QString imported_;  ///< folder of the case that was taken into the library and is to be shown there
};

}  // namespace ew::ui
