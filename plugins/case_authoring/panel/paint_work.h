#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "ew/sdk/host.h"
#include "ew/sdk/scan.h"
#include "logic/keeping_aside.h"
#include "logic/painting.h"

namespace ew::case_authoring {

/// Painting in the labels of the open case: from the first stroke until it is kept in the case, which is one step of the case, or
/// discarded. Meanwhile image and body show what is painted, and it is kept aside, so that a crash loses at most what was painted in the
/// last second.
class PaintWork final : public QObject {
  Q_OBJECT

 public:
  explicit PaintWork(sdk::Host& host, QObject* parent = nullptr);
  ~PaintWork() override;

  /// The label that strokes have; 0: none, and tools end.
  void setLabel(int label);
  /// Strokes over the scan until it is empty again, or the user ends them.
  void take(const std::optional<PaintSettings>& settings);
  [[nodiscard]] std::optional<PaintTool> tool() const { return settings_ ? std::optional(settings_->tool) : std::nullopt; }

  [[nodiscard]] const Painting* painting() const { return painting_.get(); }
  [[nodiscard]] bool hasUnkept() const { return painting_ && painting_->isChanged(); }
  [[nodiscard]] bool isBusy() const { return isBusy_; }  ///< growing, or being kept
  [[nodiscard]] bool isGrowing() const { return growing_ != nullptr; }
  void cancelGrowing();  ///< nothing is labelled then
  [[nodiscard]] QString undoText() const;
  [[nodiscard]] QString redoText() const;
  void undo();
  void redo();
  void fillBetween();
  void keepLargest();
  void smooth();
  /// Into the case: a label file of its own, and the step of the case that names it.
  void keep();
  void discard();
  /// Gives the case labels without any voxel when it has none, then calls `done` on the window's thread: a structure needs a number there.
  void withLabelFile(std::function<void(const std::string& file)> done);
  /// The case's labels without those of one structure, in a file of their own, of which `done` is told; also what is being painted loses
  /// it.
  void withoutLabel(int label, std::function<void(const std::string& file)> done);

  /// Another case was opened, or this one has another folder now.
  void followCase();
  /// Whether a program that ended too early has left something that was painted in this case.
  [[nodiscard]] bool hasLeft() const { return left_.has_value(); }
  void goOnWithLeft();
  void discardLeft();

  std::function<void()> onChanged;                      ///< what is painted, the tool, or whether it is busy
  std::function<void(const QString& sentence)> onSaid;  ///< what is wrong or to be known; empty: nothing any more

 private:
  [[nodiscard]] bool begin();
  [[nodiscard]] std::optional<Transform<frame::World, frame::File>> fileToWorld() const;
  [[nodiscard]] std::optional<Transform<frame::File, frame::Probe>> planeToFile() const;
  void askForStrokes();
  void strokeBegun(const glm::dvec2& at_mm);
  void strokeEnded();
  void grow(const glm::dvec2& at_mm);
  void showGrowth(const labelling::GrowResult& result);
  void painted();
  /// Adds labels to the case in a job, and tells `done` their file when the case is still open.
  void addLabels(const QString& title, std::function<Result<Volume>(Progress&)> make, std::function<void(const std::string& file)> done);
  void keepAside();
  [[nodiscard]] std::shared_ptr<KeepingAside> newAside() const;
  /// Keeps what is painted now; what another program left of it goes once that is done.
  void startKeepingAside();
  void rememberCase();
  void end();
  void say(const QString& sentence) const;
  void say(const Error& error) const;
  [[nodiscard]] QString nameOfStroke() const;

  sdk::Host& host_;
  int label_ = 0;
  std::optional<PaintSettings> settings_;
  std::unique_ptr<Painting> painting_;
  std::filesystem::path caseFolder_;
  std::shared_ptr<const Volume> voxels_;  ///< that are painted over
  std::string before_;                    ///< what the case named as its labels, as it was last seen open
  std::shared_ptr<KeepingAside> aside_;
  std::optional<KeptPainting::Left> left_, takenOver_;
  sdk::Ticket asking_, closing_;
  bool isBusy_ = false;
  std::shared_ptr<std::atomic<bool>> growing_;  ///< true: it is to stop; null: nothing grows
  QTimer keepSoon_;
};

}  // namespace ew::case_authoring
