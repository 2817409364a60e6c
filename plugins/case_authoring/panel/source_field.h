#pragma once

#include <QString>
#include <QWidget>
#include <array>
#include <functional>

#include "ew/library/new_case.h"

class QButtonGroup;
class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QRadioButton;

namespace ew::sdk {
class NumberField;
}

namespace ew::case_authoring {

/// What a volume is made from: a file of one of three kinds, or nothing yet. A chosen file says by itself what it is.
class SourceField final : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { volume, sweep, stitched, nothing };
  /// @param offersNothing whether "nothing yet" can be chosen
  explicit SourceField(bool offersNothing, QWidget* parent = nullptr);

  [[nodiscard]] Kind kind() const;
  [[nodiscard]] QString file() const;  ///< as it is written in the field; empty for nothing
  /// What was chosen. @error notFound, as sourceOf; badUsage: no file is chosen yet
  [[nodiscard]] Result<CaseSource> source() const;
  void setFile(const QString& file);

 Q_SIGNALS:
  void changed();

 private:
  void addKind(Kind kind, const char* name, const QString& title, const QString& text);
  void chooseFile();
  void look();

  QButtonGroup* kinds_ = nullptr;
  QWidget* fileRow_ = nullptr;
  QLineEdit* file_ = nullptr;
  QPushButton* choose_ = nullptr;
  QWidget* sweepRow_ = nullptr;
  sdk::NumberField* spacing_ = nullptr;
  QCheckBox* fan_ = nullptr;
  QLabel* remark_ = nullptr;
};

}  // namespace ew::case_authoring
