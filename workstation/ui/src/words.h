#pragma once

#include <QString>
#include <filesystem>
#include <string>

namespace ew::ui {

inline QString words(const std::string& text) { return QString::fromStdString(text); }
inline QString wordsOf(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }
inline std::filesystem::path pathOf(const QString& text) { return {text.toStdString()}; }

}  // namespace ew::ui
