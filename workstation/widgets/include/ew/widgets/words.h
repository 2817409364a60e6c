#pragma once

// Text of the libraries as a window shows it. Needs Qt's core alone, and nothing of the library ew_widgets but this header.

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <filesystem>
#include <string>
#include <vector>

#include "ew/core/data_file.h"
#include "ew/core/message.h"
#include "ew/core/result.h"

namespace ew {

inline QString words(const std::string& text) { return QString::fromStdString(text); }

/// A message in the window's language; a text that has no translation stays English, and a number has the point of QLocale(). Any thread.
inline QString words(const Message& message) {
  std::vector<std::string> parts;
  parts.reserve(message.arguments().size());
  for (const Message& argument : message.arguments()) parts.push_back(words(argument).toStdString());
  if (message.text() != nullptr) return words(filledIn(QCoreApplication::translate(kMessageContext, message.text()).toStdString(), parts));
  if (message.isNumeral()) return words(message.verbatim()).replace(QLatin1Char('.'), QString(QLocale().decimalPoint()));
  if (parts.empty()) return words(message.verbatim());
  std::string all = parts.front();
  for (std::size_t n = 1; n < parts.size(); ++n) all += message.verbatim() + parts[n];
  return words(all);
}

inline QString words(const Error& error) { return words(error.message); }

/// Of a data file, in the window's language.
inline QString words(const Words& text) { return words(text.in(QLocale().name().toStdString())); }
inline QString wordsOf(const std::filesystem::path& path) { return words(path.string()); }
inline std::filesystem::path pathOf(const QString& text) { return {text.toStdString()}; }

/// Of a probe, as people read it: the program's own in the window's language, those of others as they are called.
inline QString nameOfProbe(const std::string& name) { return QCoreApplication::translate("ew::Probe", name.c_str()); }

}  // namespace ew
