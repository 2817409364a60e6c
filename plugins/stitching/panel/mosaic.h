#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <memory>
#include <string>

#include "ew/core/volume.h"
#include "ew/sdk/host.h"
#include "ew/stitching/chain.h"
#include "ew/stitching/project.h"
#include "ew/stitching/result_files.h"

namespace ew::stitching {

class Notices;
class ProjectDocument;
struct CaseWithVolume;

/// The one volume that a run made of all, and where it goes: into a folder, or into the open case. On the window's thread.
class Mosaic final : public QObject {
  Q_OBJECT

 public:
  Mosaic(sdk::Host& host, Notices& notices, const ProjectDocument& document);

  /// @param state of the run that made it @param asked what it was made of
  void take(std::shared_ptr<const Volume> volume, const ChainState& state, const StitchProject& asked);
  void forget();
  /// Its files lie in another folder now.
  void moveFiles(const std::filesystem::path& before, const std::filesystem::path& after);
  [[nodiscard]] std::shared_ptr<const Volume> volume() const { return volume_; }  ///< null: not made
  [[nodiscard]] bool isFresh() const;                                             ///< the project still asks for this one

  [[nodiscard]] bool isCaseOpen() const;  ///< that could take it over
  void handToCase();
  void saveIn(const std::filesystem::path& folder);  ///< volume, coverage, source and provenance

 private:
  [[nodiscard]] const StitchProject& project() const;
  void writeIntoCase(const std::filesystem::path& caseFolder, const std::string& name);
  /// The open case with the stitched volume under a name. Expects an open case and a volume.
  [[nodiscard]] CaseWithVolume caseWith(const std::string& name);
  [[nodiscard]] QString titleOfCase() const;
  void useInCase(const std::filesystem::path& caseFolder, const std::string& name);
  [[nodiscard]] static bool mayReplace(const std::filesystem::path& folder, const QStringList& names);  ///< asks
  [[nodiscard]] bool mayDropTargets(const CaseWithVolume& next);                                        ///< asks

  sdk::Host& host_;
  Notices& notices_;
  const ProjectDocument& document_;
  std::shared_ptr<const Volume> volume_;
  ResultPaths files_;
  StitchProject asked_;  ///< of which it was made
};

}  // namespace ew::stitching
