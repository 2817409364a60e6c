#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "case_document.h"
#include "ew/sdk/host.h"
#include "jobs.h"

class QTabWidget;

namespace ew::ui {

/// The host of plugins in the window: cases through the undo history, jobs as cards, panels as tabs of the Author workspace. What a plugin
/// throws does not get here: door::PluginList stops it before.
class WorkstationHost final : public QObject, public sdk::Host {
  Q_OBJECT

 public:
  /// Everything must outlive the host. @param panels receives one tab a panel
  WorkstationHost(CaseDocument& document, Jobs& jobs, QTabWidget& panels, QObject* parent = nullptr);
  ~WorkstationHost() override;

  sdk::Volumes& volumes() override;
  sdk::Files& files() override;
  sdk::Cases& cases() override;
  sdk::Jobs& jobs() override;
  sdk::Panels& panels() override;
  sdk::Commands& commands() override;
  sdk::Log& log() override;

  /// How the window saves the open case and makes it the user's own; both may ask. Without them saving asks nobody.
  struct CaseSaving {
    std::function<Result<void>(const std::filesystem::path& folder)> save;
    std::function<Result<void>()> makeOwn;
  };
  void setCaseSaving(CaseSaving saving);
  /// How the open case is scanned, and what a case may choose from: the window knows.
  void setScan(std::function<std::optional<sdk::Cases::Scan>()> scan);
  void setChoices(std::function<sdk::Cases::Choices()> choices);

  /// Of the tab in front; whether it is seen is the window's affair.
  [[nodiscard]] bool hasStageInFront() const;
  [[nodiscard]] QWidget* stageInFront(QWidget* parent);  ///< made when first asked for; null: it has none
  [[nodiscard]] sdk::PanelDocument* documentInFront() const;
  [[nodiscard]] std::vector<const sdk::StagedPanel*> panelsAdded() const;
  /// Id of the panel in whose column or stage `part` lies; empty: in none.
  [[nodiscard]] static std::string panelOf(const QObject* part);

 Q_SIGNALS:
  void panelDocumentChanged();
  void volumeShown(std::shared_ptr<const ew::Volume> volume, const QString& title);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew::ui
