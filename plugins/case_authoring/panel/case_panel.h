#pragma once

#include <QWidget>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "ew/sdk/host.h"
#include "ew/sdk/panel.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QSpinBox;
class QStackedWidget;

namespace ew::case_authoring {

/// The open case as a form. Every change goes to the host as one undoable step; what the schema refuses is said beside its field and
/// changes nothing. The case and its undo history are the host's.
class CasePanel final : public QWidget {
  Q_OBJECT

 public:
  explicit CasePanel(sdk::Host& host, QWidget* parent = nullptr);

  /// Saves where the case is, or into a new folder.
  void save(const std::filesystem::path& folder = {});

 private:
  /// A form field: how to show the manifest in it, and where its problem is said.
  struct Field {
    std::function<void(const nlohmann::json& manifest)> show;
    QLabel* problem = nullptr;
  };

  QWidget* makeForm();
  QWidget* makeSaveRow();
  void addLine(QFormLayout* form, const std::string& path, const QString& label, const QString& what);
  void addText(QFormLayout* form, const std::string& path, const QString& label, const QString& what);
  void addSex(QFormLayout* form);
  void addAge(QFormLayout* form);
  void addPlace(QFormLayout* form);
  void addLaboratory(QFormLayout* form);
  void addDifficulty(QFormLayout* form);
  void addLines(QFormLayout* form, const std::string& path, const QString& label, const QString& what);
  void addExaminations(QFormLayout* form);
  void addStartPose(QFormLayout* form);
  void addProbes(QFormLayout* form);
  void addMannequin(QFormLayout* form);
  void addScene(QFormLayout* form);
  QLabel* addRow(QFormLayout* form, const QString& label, QWidget* editor, const std::string& path);
  /// @param part of what `path` names: edits of one part in a row are one step of undo
  void change(const std::string& path, const QString& what, const std::function<nlohmann::json(nlohmann::json)>& edit,
              const std::string& part = {});
  void showCase();
  void showSaved();
  void showStartRemark();
  void checkCase();
  void say(const Error& problem);

  sdk::Host& host_;
  std::map<std::string, Field> fields_;
  std::string typedIn_;          ///< path of the field whose changes are one step of undo
  nlohmann::json beforeTyping_;  ///< what it held before that step
  bool changing_ = false;        ///< this panel is the one that edits: its fields are already as the user typed them
  QStackedWidget* pages_ = nullptr;
  QLabel* saved_ = nullptr;
  QLabel* where_ = nullptr;
  QLabel* problem_ = nullptr;
  QLabel* checked_ = nullptr;      ///< what a check has found good
  QLabel* startRemark_ = nullptr;  ///< the case may be saved all the same
  sdk::Cases::Ticket ticket_;
};

}  // namespace ew::case_authoring
