#pragma once

#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QTimer>
#include <functional>
#include <map>
#include <utility>

namespace ew::ui::testing {

/// Answers dialogs by their names as they come, each once, and remembers which came.
class Answers final : public QObject {
 public:
  using Answer = std::function<void(QWidget&)>;

  explicit Answers(std::map<QString, Answer> known) : known_(std::move(known)) {
    connect(&poll_, &QTimer::timeout, this, [this] {
      QWidget* modal = QApplication::activeModalWidget();
      if (modal == nullptr || modal == answered_ || modal->objectName() == QLatin1String("importDialog") ||
          modal->objectName() == QLatin1String("screenDialog"))
        return;
      const QString name = qobject_cast<QFileDialog*>(modal) != nullptr ? QStringLiteral("fileDialog") : modal->objectName();
      asked << name;
      texts << (qobject_cast<QMessageBox*>(modal) != nullptr ? qobject_cast<QMessageBox*>(modal)->text() : QString());
      answered_ = modal;
      const auto found = known_.find(name);
      if (found != known_.end()) {
        found->second(*modal);
      } else {
        qobject_cast<QDialog*>(modal)->reject();
      }
    });
    poll_.start(10);
  }

  QStringList asked, texts;

 private:
  QTimer poll_;
  QPointer<QWidget> answered_;
  std::map<QString, Answer> known_;
};

inline Answers::Answer press(QMessageBox::StandardButton which) {
  return [which](QWidget& dialog) { qobject_cast<QMessageBox*>(&dialog)->button(which)->click(); };
}

inline Answers::Answer press(const char* name) {
  return [name = QString::fromLatin1(name)](QWidget& dialog) { dialog.findChild<QPushButton*>(name)->click(); };
}

/// Types a name into a file dialog as a user does.
inline Answers::Answer type(const QString& file) {
  return [file](QWidget& dialog) {
    dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(file);
    QMetaObject::invokeMethod(&dialog, "accept");
  };
}

}  // namespace ew::ui::testing
