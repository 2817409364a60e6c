#pragma once

#include <QPointer>
#include <QString>
#include <string>

#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew {
struct DicomStudy;
}

namespace ew::ui {

class ExaminationDialog;

inline const auto kStoringTopic = QStringLiteral("storing");  ///< of messages

/// Images kept of an examination, and how they leave: as DICOM files and to an archive.
class Storing final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void addActions(QMenu& file);
  void connectParts() override;
  void refresh() override;
  void holdUnsavedWork(UnsavedWork& list) override;

  [[nodiscard]] DicomStudy studyNow() const;  ///< of the patient who is scanned
  void followPatient();                       ///< whose stored images are shown

 private:
  void store();
  void showExamination();
  bool save();  ///< asks for a folder and begins to save. @return false: nothing is saved
  void send();
  [[nodiscard]] bool mayLeave(const QString& next);

  QPointer<ExaminationDialog> dialog_;
  QAction* store_ = nullptr;
  std::string storesFor_;  ///< who stored the images of the examination, as they call themselves
  bool isSending_ = false;
  bool patientSoon_ = false;  ///< another patient is about to be scanned
};

}  // namespace ew::ui
