#pragma once

#include <QObject>
#include <QPointer>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "case/case_document.h"
#include "ew/sdk/host.h"
#include "ew/sdk/window.h"
#include "ew/sdk/workspaces.h"
#include "jobs/jobs.h"

namespace ew {
class AccessPolicy;
}

namespace ew::ui {

class HostOverlays;
class HostScan;
class MessageBar;
class Session;
class WorkspacePanels;

/// The host of plugins in the window: cases through the undo history, jobs as cards, panels as tabs of their workspace, the session's scan.
/// What a plugin throws does not get here: door::PluginList stops it before.
class WorkstationHost final : public QObject, public sdk::Host {
  Q_OBJECT

 public:
  /// Everything must outlive the host. @param panels receives one tab a panel
  WorkstationHost(CaseDocument& document, Jobs& jobs, Session& session, WorkspacePanels& panels, MessageBar& messages,
                  QObject* parent = nullptr);
  ~WorkstationHost() override;

  sdk::Volumes& volumes() override;
  sdk::Files& files() override;
  sdk::Cases& cases() override;
  sdk::Jobs& jobs() override;
  sdk::Panels& panels() override;
  sdk::Commands& commands() override;
  sdk::Scan& scan() override;
  sdk::Workspaces& workspaces() override;
  sdk::Overlays& overlays() override;
  sdk::CaseParts& caseParts() override;
  sdk::Window& window() override;
  sdk::Log& log() override;

  /// How the window saves the open case and makes it the user's own; both may ask. Without them saving asks nobody.
  struct CaseSaving {
    std::function<Result<void>(const std::filesystem::path& folder)> save;
    std::function<Result<void>()> makeOwn;
    std::function<Result<void>()> saveCopy;  ///< asks for the folder
  };
  void setCaseSaving(CaseSaving saving);
  /// How the open case is scanned, and what a case may choose from: the window knows.
  void setScan(std::function<std::optional<sdk::Cases::Scan>()> scan);
  void setChoices(std::function<sdk::Cases::Choices()> choices);
  /// What is scanned that is no case's: the window knows.
  void setShownVolume(std::function<std::optional<sdk::DisplayVolume>()> shown);
  /// What the lock for trainees lets plugins read and change; it outlives the host. Without one they may everything.
  void setAccess(const AccessPolicy& access);
  void tellAccessChanged();
  /// How the window opens a case.
  void setOpening(std::function<Result<void>(const std::filesystem::path&)> open);
  /// Tells whoever waits for it (CaseParts::onAsked), when the case is open, and brings the panel with the section's name to the front.
  void askFor(const std::filesystem::path& caseFolder, const std::string& part, const std::string& item);
  /// Workspaces that plugins bring: how the window adds one (false: its id is taken), shows one and says which is in front.
  struct WorkspaceSwitch {
    std::function<bool(const sdk::Workspace&)> add;
    std::function<void(const std::string& id)> show;
    std::function<std::string()> shown;
  };
  void setWorkspaceSwitch(WorkspaceSwitch theSwitch);
  /// How the window adds an entry to its menus; the ticket takes it out.
  void setMenu(std::function<sdk::Ticket(const sdk::MenuEntry&, std::function<void()>)> addEntry);

  /// Of the tab in front; whether it is seen is the window's affair.
  [[nodiscard]] bool hasStageInFront() const;
  [[nodiscard]] QWidget* stageInFront(QWidget* parent);  ///< made when first asked for; null: it has none
  [[nodiscard]] std::shared_ptr<sdk::PanelDocument> documentInFront() const;
  [[nodiscard]] std::vector<const sdk::StagePanel*> panelsAdded() const;
  /// What would be lost if the window closed, beside what documents of panels say.
  [[nodiscard]] std::vector<sdk::UnsavedWork> unsaved() const;
  [[nodiscard]] HostScan& hostScan();
  [[nodiscard]] HostOverlays& hostOverlays();
  /// Id of the panel in whose column or stage `part` lies; empty: in none.
  [[nodiscard]] static std::string panelOf(const QObject* part);

 Q_SIGNALS:
  void panelDocumentChanged();
  /// @param madeFrom files that it was made from, as far as they are known
  void volumeShown(std::shared_ptr<const ew::Volume> volume, const QString& title, const std::vector<std::filesystem::path>& madeFrom);
  void volumeKept(std::shared_ptr<const ew::Volume> volume);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew::ui
