#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "ew/core/message.h"
#include "ew/core/volume.h"
#include "ew/sdk/host.h"
#include "ew/stitching/project.h"

class QDropEvent;

namespace ew::stitching {

class Notices;
class ProjectDocument;
struct FilesRead;

/// The volumes and sweeps of the project: their voxels, read in the host's jobs, and why others could not be read. On the window's thread.
class ProjectInputs final : public QObject {
  Q_OBJECT

 public:
  ProjectInputs(sdk::Host& host, Notices& notices, ProjectDocument& document);

  /// Volumes, sweeps, or one project (which takes the place of an empty one, else its volumes are added).
  void addFiles(const std::vector<std::filesystem::path>& files);
  void addDropped(QDropEvent& event);
  void readVolumes();     ///< those of the project that are not there yet
  void forgetFailures();  ///< and so tries again
  void keep(const ProjectVolume& line, std::shared_ptr<const Volume> volume);

  [[nodiscard]] std::shared_ptr<const Volume> volume(std::size_t index) const;            ///< null: not read yet, or it cannot be read
  [[nodiscard]] std::shared_ptr<const Volume> volumeOf(const ProjectVolume& line) const;  ///< the same of any line
  [[nodiscard]] bool isUnreadable(std::size_t index) const;
  [[nodiscard]] QString whyUnreadable(std::size_t index) const;
  [[nodiscard]] bool isSweep(std::size_t index) const;  ///< as far as it was looked at
  /// So little of a sweep is kept that a person has to say it is meant, or one has said so.
  [[nodiscard]] bool asksAboutLittle(std::size_t index) const;
  void setAcceptsSmall(std::size_t index, bool accepts);
  /// How a sweep becomes a volume; it is read again.
  void setCalibration(std::size_t index, const std::filesystem::path& deviceSet);
  void setSweepSpacing(std::size_t index, double spacing_mm);

 Q_SIGNALS:
  void volumesRead();
  void mendingWanted(std::size_t index);  ///< of a sweep that was added and needs something said before it is a volume

 private:
  [[nodiscard]] const StitchProject& project() const;
  [[nodiscard]] std::vector<ProjectVolume> linesOf(const std::vector<std::filesystem::path>& files);  ///< says which are listed already
  void takeRead(FilesRead& read, const Result<void>& outcome);

  sdk::Host& host_;
  Notices& notices_;
  ProjectDocument& document_;
  std::shared_ptr<std::timed_mutex> readingTurn_ = std::make_shared<std::timed_mutex>();
  std::map<std::string, std::shared_ptr<const Volume>> volumes_;  ///< by keyOf
  std::map<std::string, Message> unreadable_;                     ///< by keyOf: why
  std::set<std::string> little_;                                  ///< keyOf those of which too little is kept
  std::set<std::filesystem::path> sweeps_;                        ///< files that were seen to be some
  bool reading_ = false;
};

}  // namespace ew::stitching
