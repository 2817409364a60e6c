#pragma once

// Text of the libraries as the window shows it. Not part of the library ew_sdk: whoever includes this links Qt5::Core itself.

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <string>
#include <vector>

#include "ew/core/message.h"
#include "ew/core/result.h"

namespace ew::sdk {

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

}  // namespace ew::sdk
