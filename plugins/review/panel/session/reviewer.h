#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <string>

#include "ew/assessment/pseudonym.h"
#include "ew/library/attempt.h"

namespace ew::review {

/// Who reviews, and what people are called: by their names, or by codes. Both are kept in the window's settings.
class Reviewer final : public QObject {
  Q_OBJECT

 public:
  Reviewer();

  /// Comments, ratings and plans are kept under it; empty: nobody has said it.
  [[nodiscard]] QString name() const { return name_; }
  /// Tells nobody: whoever sets it (ReviewSession::setReviewer) says when the rest has followed.
  void setName(const QString& name);
  /// Whether people are called by their names; else by codes.
  [[nodiscard]] bool showsNames() const { return showsNames_; }
  void setShowsNames(bool names);
  [[nodiscard]] QString personOf(const Attempt& attempt) const;
  /// Of who rates and comments, in the same way.
  [[nodiscard]] QString called(const std::string& reviewer) const;

 Q_SIGNALS:
  void changed();       ///< whose name it is
  void namesChanged();  ///< they are shown, or no longer

 private:
  [[nodiscard]] const Pseudonyms* codes() const;  ///< null: they cannot be read

  QString name_;
  bool showsNames_ = false;
  mutable std::optional<Pseudonyms> codes_;  ///< of the library, read when they are first asked for
};

}  // namespace ew::review
