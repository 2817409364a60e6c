#pragma once

// Who learns at this workstation. Not part of the library ew_sdk: whoever includes this links Qt5::Core itself.

#include <QSettings>
#include <QString>
#include <string>

namespace ew::sdk {

inline constexpr int kLongestPersonName = 80;

/// As they call themselves; empty: nobody has said so, and nobody is asked.
inline std::string personWhoLearns() { return QSettings().value(QStringLiteral("learning/person")).toString().toStdString(); }

inline void setPersonWhoLearns(const QString& name) {
  QSettings().setValue(QStringLiteral("learning/person"), name.simplified().left(kLongestPersonName));
}

}  // namespace ew::sdk
