#pragma once

#include <QObject>
#include <QString>

#include "ew/core/result.h"
#include "ew/sdk/host.h"

namespace ew::stitching {

/// What the column says below its steps, whoever says it.
class Notices final : public QObject {
  Q_OBJECT

 public:
  explicit Notices(sdk::Log& log) : log_(log) {}
  void say(const Error& error);  ///< and keeps it in the log

 Q_SIGNALS:
  void problem(const QString& sentence);  ///< empty: none any more
  void said(const QString& sentence);     ///< what was done, where it matters

 private:
  sdk::Log& log_;
};

}  // namespace ew::stitching
