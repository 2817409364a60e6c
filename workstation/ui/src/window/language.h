#pragma once

#include <QString>
#include <QTranslator>
#include <memory>
#include <vector>

class QApplication;

namespace ew::ui {

/// A language nobody speaks, made from the source texts while the program runs: every text is longer by about a third and in brackets, and
/// is read from the right. What shows no brackets never passed through a translation; what is cut here would be cut in a longer language.
inline const QString kPseudoLanguage = QStringLiteral("qps-rtl");

/// "&Open %1…" becomes "[&Open %1… ~~~]", embedded from right to left. Markup, places and the letter of the menu stay as they are.
[[nodiscard]] QString pseudoWords(const QString& source);

class PseudoTranslator final : public QTranslator {
 public:
  using QTranslator::QTranslator;
  /// Names of keys stay: they stand on the keys.
  [[nodiscard]] QString translate(const char* context, const char* source, const char* disambiguation, int n) const override;
  [[nodiscard]] bool isEmpty() const override { return false; }
};

/// What is spoken from now on: the user's choice, for one start what ECHOWEAVE_LANGUAGE says ("en", "de", "qps-rtl"), or else the system's
/// language. Sets how numbers are written and from which side the window is read. @return the words; they are spoken as long as they live
[[nodiscard]] std::vector<std::unique_ptr<QTranslator>> speak(QApplication& app);

}  // namespace ew::ui
