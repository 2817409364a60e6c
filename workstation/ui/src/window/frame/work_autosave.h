#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/volume.h"
#include "ew/io/autosave.h"
#include "measure/calipers/measurement_work.h"

namespace ew::ui {

class Calipers;
class Recorder;
class Session;
class Worksheets;

// What descriptions of kept work call it (Autosave::Left::about, "kind").
inline const std::string kWindowWork = "window";           ///< of this file
inline const std::string kExpertScanWork = "expert_scan";  ///< a recording that an author's lesson was to get

inline const auto kKeepingWorkTopic = QStringLiteral("keep work");  ///< of messages that something cannot be kept

/// Keeps what was recorded, measured and made in a window where a crash does not take it, as it grows.
class WorkAutosave final : public QObject {
  Q_OBJECT

 public:
  /// A volume that was made here and lies in no file yet.
  struct SessionVolume {
    QString path;   ///< of what it was made from
    QString title;  ///< for people
    std::shared_ptr<const Volume> volume;
    bool isShown = false;
  };

  WorkAutosave(const std::filesystem::path& root, Session& session, Recorder& recorder, Calipers& calipers, Worksheets& worksheets,
               QObject* parent = nullptr);
  ~WorkAutosave() override;

  /// @param path of the case or file that is scanned, with which it can be opened again; empty: it lies in none
  void setOpen(const QString& path);
  [[nodiscard]] const QString& path() const { return path_; }
  /// A recording ended, or one of before the crash is here again; null: nothing was recorded.
  void takeRecording(const std::shared_ptr<const ScanRecording>& recording);
  /// It was saved, or the user gave it up.
  void dropRecording();
  void setVolumes(const std::vector<SessionVolume>& volumes);
  /// What was measured before the crash is here again.
  void restore(const MeasurementWork& work);
  /// What is measured now, at once.
  void keepMeasured();
  /// The window closes, and whoever was asked has decided.
  void forget();
  [[nodiscard]] Autosave& keeper() { return kept_; }

 Q_SIGNALS:
  void failed(const ew::Error& problem);  ///< something cannot be kept; once until it can again

 private:
  struct VolumeAutosave {
    SessionVolume made;
    std::string item;
  };
  void describe();
  void grow();
  void append(const ScanRecording& recording);
  void follow();
  void remember(std::uint64_t image, const measurement::Measurements& shown);
  [[nodiscard]] MeasurementWork measured() const;

  Session& session_;
  Recorder& recorder_;
  Calipers& calipers_;
  Worksheets& worksheets_;
  QString path_;
  bool isDescribed_ = false;
  bool isRecordingKept_ = false;
  bool isMeasuredKept_ = false;
  const ScanRecording* growing_ = nullptr;  ///< whose events are in the file
  std::size_t events_ = 0;                  ///< so many
  std::vector<ImageMeasurements> images_;
  std::vector<VolumeAutosave> volumes_;
  int nextVolume_ = 1;
  QTimer keepSoon_;
  Autosave kept_;  // last: its thread tells this object
};

/// What a program that crashed has left behind, read.
struct RecoverableWork {
  struct VolumeDraft {
    QString path, title;
    std::filesystem::path file;  ///< empty: it was too large to be kept
    bool isShown = false;
  };
  struct Step {
    std::string lesson;
    QString title;
    int number = 1, count = 1;
  };
  explicit RecoverableWork(Autosave::Left kept) : left(std::make_shared<Autosave::Left>(std::move(kept))) {}

  std::shared_ptr<Autosave::Left> left;
  std::string kind;
  QString path;   ///< as of WorkAutosave::setOpen
  QString title;  ///< of what was scanned, as a trainee may read it
  std::shared_ptr<const ScanRecording> recording;
  MeasurementWork measured;
  std::vector<VolumeDraft> volumes;
  std::optional<Step> step;
  std::vector<Message> unread;  ///< of what lies there and cannot be read, or not to its end: why
  // While it is gone on with.
  std::shared_ptr<const Volume> scanned;  ///< of the volumes the one that all else is of, once it is here again; null: what `path` names
  bool isAsked = false;                   ///< what `path` names is opened, and a dialog asks how

  /// Nothing that somebody would miss, of what could be read.
  [[nodiscard]] bool isEmpty() const { return !recording && measured.isEmpty() && volumes.empty() && !step; }
  /// Some of it means nothing with another patient.
  [[nodiscard]] bool isOfPatient() const { return recording || !measured.isEmpty(); }
};
/// Off the window's thread: a recording of an hour is tens of megabytes.
[[nodiscard]] RecoverableWork readLeftWork(Autosave::Left left);
/// One line for each thing that was kept, for the question about it.
[[nodiscard]] QStringList linesOf(const RecoverableWork& work);

}  // namespace ew::ui
