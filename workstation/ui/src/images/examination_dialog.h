#pragma once

#include <QDialog>
#include <string>
#include <vector>

#include "ew/export/outbox.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace ew::ui {

class Jobs;
class ExaminationStore;
class Worksheets;

/// Stored images and worksheets of the patient who is scanned, and the archive they go to. The archive is remembered.
class ExaminationDialog final : public QDialog {
  Q_OBJECT

 public:
  ExaminationDialog(ExaminationStore& stored, Worksheets& worksheets, Jobs& jobs, QWidget* parent);

  /// As the fields have it.
  [[nodiscard]] DicomArchive archive() const;
  /// What waits in the outbox; empty: nothing.
  void setWaiting(const QString& sentence);
  /// While something is on its way nothing else is sent.
  void setSending(bool isSending);

 Q_SIGNALS:
  void saveAsked();
  void sendAsked();

 private:
  void addArchive(QVBoxLayout& rows);
  void showAll();
  void testArchive();

  ExaminationStore& stored_;
  Worksheets& worksheets_;
  Jobs& jobs_;
  QListWidget* images_ = nullptr;
  std::vector<std::string> shown_;  ///< identifiers of the images in the list
  QLabel* noImages_ = nullptr;
  QPushButton* remove_ = nullptr;
  QLabel* sheets_ = nullptr;
  QLineEdit* host_ = nullptr;
  QSpinBox* port_ = nullptr;
  QLineEdit* title_ = nullptr;
  QLineEdit* ownTitle_ = nullptr;
  QPushButton* test_ = nullptr;
  QLabel* answer_ = nullptr;
  QLabel* waiting_ = nullptr;
  QPushButton* save_ = nullptr;
  QPushButton* send_ = nullptr;
  bool isSending_ = false;
  bool hasWaiting_ = false;
};

}  // namespace ew::ui
