#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ew/library/case_values.h"
#include "ew/sdk/host.h"
#include "logic/edits.h"

class QFormLayout;
class QLabel;
class QScrollArea;
class QStackedWidget;
class QVBoxLayout;

namespace ew::case_authoring {

class ExaminationsField;
class FilesDialog;
class PublishDialog;
class Section;

/// The open case as a form in sections. Every change goes to the host as one undoable step; what the schema refuses is said beside its
/// field and changes nothing. The case and its undo history are the host's.
class CasePanel final : public QWidget {
  Q_OBJECT

 public:
  /// @param begin what begins a new case
  CasePanel(sdk::Host& host, std::function<void()> begin, QWidget* parent = nullptr);

  /// Saves where the case is, or into a new folder.
  void save(bool elsewhere = false);  ///< asks for a new folder, or saves where the case lies
  /// Brings what a problem or a line of the list before publishing is about into sight: a field of the form, or the panel that edits it.
  /// @param path as CheckItem::field
  void showField(const std::string& path);

 private:
  /// A form field: how to show the case in it, and where its problem is said.
  struct Field {
    std::function<void(const Case& shown)> show;
    QLabel* problem = nullptr;
  };

  /// Where a field stands.
  struct Row {
    Section* section = nullptr;
    QWidget* editor = nullptr;
    QString label;
    QLabel* warning = nullptr;
  };

  QWidget* makeForm();
  QWidget* makeTakenRow();
  QWidget* makeNoVolumeRow();
  void giveVolume();
  Section* addSection(const QString& id, const QString& title);
  void addCaseSection();
  void addPatientSection();
  void addBeforeSection();
  void addFindingsSection();
  void addMeasurements();
  void addScanSection();
  void addVolumeSection();
  void addName(QFormLayout* form);
  void addVolume(QFormLayout* form);
  /// A list of ids that are ticked; the first one counts more than the others.
  /// @param atStart what is said of the first: "At the start: %1"; empty: nothing
  void addIds(QFormLayout* form, const std::string& path, const QString& label, const QString& none, const QString& atStart,
              const std::vector<std::pair<std::string, std::string>>& known, const CaseTexts& ids);
  void addImagesTo(ExaminationsField& field, std::size_t number);
  [[nodiscard]] std::optional<CaseMeasurement> takeCaliper(const CaseMeasurement& expected);
  void showWarnings();  ///< what looks real, beside its fields
  void showMissing();   ///< what a published case needs, in the heads of the sections
  void showFiles();
  void publish();
  QWidget* makeSaveRow();
  // Each of these edits one field of the case, whose name in case.json is `path`.
  void addLine(QFormLayout* form, const std::string& path, const CaseText& text, const QString& label, const QString& what,
               QWidget* beside = nullptr);
  void addText(QFormLayout* form, const std::string& path, const CaseText& text, const QString& label, const QString& what);
  void addSex(QFormLayout* form);
  void addAge(QFormLayout* form);
  void addLaboratory(QFormLayout* form);
  void addDifficulty(QFormLayout* form);
  void addLines(QFormLayout* form, const std::string& path, const CaseTexts& texts, const QString& label, const QString& what);
  void addExaminations(QFormLayout* form);
  void addStartPose(QFormLayout* form);
  void addProbes(QFormLayout* form);
  void addMannequin(QFormLayout* form);
  void addScene(QFormLayout* form);
  QLabel* addRow(QFormLayout* form, const QString& label, QWidget* editor, const std::string& path);
  /// @param part of what `path` names: edits of one part in a row are one step of undo
  void change(const std::string& path, const QString& what, const std::function<Case(Case)>& edit, const std::string& part = {});
  void showCase();
  void showSaved();
  void showStartRemark();
  void checkCase();
  void say(const Error& problem);

  sdk::Host& host_;
  std::map<std::string, Field> fields_;
  std::map<std::string, Row> rows_;
  std::vector<Section*> sections_;
  QVBoxLayout* sectionColumn_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  QTimer missingSoon_;
  QWidget* takenRow_ = nullptr;  ///< somebody else edits the case
  QLabel* takenWhy_ = nullptr;
  QWidget* noVolumeRow_ = nullptr;
  QPointer<FilesDialog> files_;
  QPointer<PublishDialog> publishing_;
  std::string typedIn_;  ///< path of the field whose changes are one step of undo
  Case beforeTyping_;    ///< the case before that step
  std::filesystem::path shownFolder_;
  bool changing_ = false;  ///< this panel is the one that edits: its fields are already as the user typed them
  QStackedWidget* pages_ = nullptr;
  QLabel* saved_ = nullptr;
  QLabel* where_ = nullptr;
  QLabel* problem_ = nullptr;
  QLabel* checked_ = nullptr;      ///< what a check has found good
  QLabel* startRemark_ = nullptr;  ///< the case may be saved all the same
  sdk::Cases::Ticket ticket_;
};

}  // namespace ew::case_authoring
