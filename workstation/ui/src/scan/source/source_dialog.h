#pragma once

#include <QDialog>
#include <QImage>
#include <memory>
#include <optional>

#include "ew/library/voxel_source.h"
#include "jobs/jobs.h"

class QLabel;
class QPushButton;

namespace ew::ui {

class SourceImage;

/// The frame of a recording that a voxel came from, with a cross where it was, and the frames beside it. The recording is read in a job
/// when the first frame is asked for and kept until the dialog closes.
class SourceDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit SourceDialog(Jobs& jobs, QWidget* parent = nullptr);
  ~SourceDialog() override;

  void showSource(const std::shared_ptr<const Provenance>& provenance, const VoxelSource& source);
  /// There is no frame to show, and why.
  void showNone(const QString& why);

  /// Index into Provenance::frames of what is shown; empty when there is no frame.
  [[nodiscard]] std::optional<std::size_t> shownFrame() const;
  /// The shown frame's pixels; null while they are read and when they cannot be.
  [[nodiscard]] const QImage& image() const;
  /// Why the pixels cannot be shown; empty when they can or are on their way.
  [[nodiscard]] const QString& problem() const { return problem_; }
  /// Where the point lies on the shown frame, in its pixels.
  [[nodiscard]] std::optional<QPointF> cross() const;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addRows();
  bool takesKey(int key);
  void goHome();
  void step(int by);
  void read();
  void showAll();
  [[nodiscard]] QString wordsOfVoxel() const;

  Jobs& jobs_;
  int job_ = 0;
  std::shared_ptr<const Provenance> provenance_;
  std::shared_ptr<const Sequence> images_;
  VoxelSource source_;
  std::size_t shown_ = 0;
  QString problem_;  ///< why there is no image
  QString none_;     ///< why there is no frame
  QLabel* sentence_ = nullptr;
  SourceImage* image_ = nullptr;
  QWidget* facts_ = nullptr;
  QLabel* sweep_ = nullptr;
  QLabel* frame_ = nullptr;
  QLabel* time_ = nullptr;
  QLabel* voxel_ = nullptr;
  QLabel* distance_ = nullptr;
  QPushButton* before_ = nullptr;
  QPushButton* home_ = nullptr;
  QPushButton* after_ = nullptr;
};

}  // namespace ew::ui
