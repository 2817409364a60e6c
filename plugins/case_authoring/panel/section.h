#pragma once

#include <QString>
#include <QWidget>

class QFormLayout;
class QLabel;
class QToolButton;

namespace ew::case_authoring {

/// A part of the long form below a heading that opens and closes it, with a mark of what is missing in it. Whether it is open is kept for
/// the next start.
class Section final : public QWidget {
  Q_OBJECT

 public:
  /// @param id for the settings and the widget's name, "section_ID"
  Section(const QString& id, const QString& title, QWidget* parent = nullptr);

  [[nodiscard]] QFormLayout& form() { return *form_; }
  void setOpen(bool open);
  /// @param names of fields that a published case needs and this one has not; empty: a quiet tick where `isNeeded`, else nothing
  void setMissing(const QStringList& names, bool isNeeded);

 Q_SIGNALS:
  void toggled();

 private:
  QString id_;
  QToolButton* head_ = nullptr;
  QLabel* mark_ = nullptr;
  QWidget* body_ = nullptr;
  QFormLayout* form_ = nullptr;
};

}  // namespace ew::case_authoring
