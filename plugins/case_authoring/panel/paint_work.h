#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ew/sdk/host.h"
#include "ew/sdk/scan.h"
#include "logic/keeping_aside.h"
#include "logic/painting.h"

namespace ew::case_authoring {

/// Painting in the labels of the open case: from the first stroke until it is kept in the case, which is one step of the case, or
/// discarded. Meanwhile image and body show what is painted, and it is kept aside, so that a crash loses at most what was painted in the
/// last second. When another case is opened it is kept aside for whoever opens its own again; what cannot be stays here.
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
  /// Whether something that was painted in this case waits: a program that ended too early has left it, or another case was opened.
  [[nodiscard]] bool hasLeft() const { return left_.has_value() || unkeptHere() != nullptr; }
  void goOnWithLeft();
  void discardLeft();
  /// The title of another case, in which something was painted that could not be kept aside and lies here alone; empty: none.
  [[nodiscard]] QString unkeptElsewhere() const;
  void discardElsewhere();
  /// Tries again with all that could not be kept aside.
  void keepUnkept();

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
  /// @param isSaving it is all there is of it: nobody cancels it, or closes the window, without being asked
  [[nodiscard]] KeepingAside::Start starting(bool isSaving) const;
  [[nodiscard]] std::shared_ptr<KeepingAside> newAside() const;
  /// Keeps what is painted now; what another program left of it goes once that is done.
  void startKeepingAside();
  /// What was painted in a case that another was opened in place of, until it is kept aside.
  struct Parted {
    KeepingAside::Painted painted;
    std::shared_ptr<KeepingAside> aside;            ///< which holds what was kept of it before
    std::optional<PaintingAutosave::Left> earlier;  ///< of another program; it goes once this is kept
    QString title;                                  ///< of the case
    bool isTried = true;                            ///< it is being kept; false: it could not be
  };
  void part(const std::shared_ptr<KeepingAside>& aside);
  void keepParted(const std::shared_ptr<Parted>& parted);
  void settle(const std::shared_ptr<Parted>& parted, const Result<void>& outcome);
  void drop(const std::shared_ptr<Parted>& parted);
  /// What could not be kept aside; null: nothing. Of the case that is open, or of another.
  [[nodiscard]] std::shared_ptr<Parted> unkeptHere() const;
  [[nodiscard]] std::shared_ptr<Parted> unkeptThere() const;
  [[nodiscard]] QString closingSentence() const;
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
  QString title_;                         ///< of the case
  std::shared_ptr<KeepingAside> aside_;
  std::optional<PaintingAutosave::Left> left_, takenOver_;
  std::vector<std::shared_ptr<Parted>> parted_;
  sdk::Ticket asking_, closing_, holding_;
  bool isBusy_ = false;
  std::shared_ptr<std::atomic<bool>> growing_;  ///< true: it is to stop; null: nothing grows
  QTimer keepSoon_;
};

}  // namespace ew::case_authoring
