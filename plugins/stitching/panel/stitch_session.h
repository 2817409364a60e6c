#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ew/sdk/host.h"
#include "panel/alignment_edits.h"
#include "panel/mosaic.h"
#include "panel/notices.h"
#include "panel/project_document.h"
#include "panel/project_inputs.h"
#include "panel/stitch_look.h"
#include "panel/stitch_results.h"
#include "panel/stitch_runs.h"

namespace ew::stitching {

/// What panel and stage share: owns what is edited, what was found, what is looked at and what runs, lets them follow each other, and shows
/// the whole to the window as one document. All on the window's thread; long work runs in the host's jobs on copies.
/// Each part knows those above it in the list of members and none below it.
class StitchSession final : public QObject, public sdk::PanelDocument {
  Q_OBJECT

 public:
  /// @param folder for results and the recovery file; empty: the application's own data folder
  explicit StitchSession(sdk::Host& host, std::filesystem::path folder = {});

  // The document, as the window sees it.
  [[nodiscard]] std::string title() const override;
  [[nodiscard]] std::string remark() const override;
  [[nodiscard]] std::string note() const override;
  [[nodiscard]] std::string undoText() const override { return document_.undoName(); }
  [[nodiscard]] std::string redoText() const override { return document_.redoName(); }
  void undo() override { document_.undo(); }
  void redo() override { document_.redo(); }
  void save(bool elsewhere) override { document_.save(elsewhere); }
  [[nodiscard]] std::shared_ptr<void> onChanged(std::function<void()> callback) override;

  [[nodiscard]] sdk::Host& host() { return host_; }
  [[nodiscard]] Notices& notices() { return notices_; }
  [[nodiscard]] ProjectDocument& document() { return document_; }
  [[nodiscard]] ProjectInputs& inputs() { return inputs_; }
  [[nodiscard]] StitchResults& results() { return results_; }
  [[nodiscard]] Mosaic& mosaic() { return mosaic_; }
  [[nodiscard]] StitchLook& look() { return look_; }
  [[nodiscard]] StitchRuns& runs() { return runs_; }
  [[nodiscard]] AlignmentEdits& edits() { return edits_; }

 Q_SIGNALS:
  void changed();      ///< the project, what was found, what is chosen, or what runs
  void lookChanged();  ///< plane, cross-hairs, stage
  void levelsChanged();

 private:
  void connectParts();
  void connectSignals();
  void tellAll();
  void tellWindow();

  sdk::Host& host_;
  Notices notices_;
  ProjectDocument document_;
  ProjectInputs inputs_;
  StitchResults results_;
  Mosaic mosaic_;
  StitchLook look_;
  StitchRuns runs_;
  AlignmentEdits edits_;
  std::vector<std::weak_ptr<std::function<void()>>> callbacks_;
};

}  // namespace ew::stitching
