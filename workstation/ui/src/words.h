#pragma once

#include <QString>
#include <filesystem>

#include "ew/sdk/words.h"

namespace ew::ui {

using sdk::words;
inline QString wordsOf(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }
inline std::filesystem::path pathOf(const QString& text) { return {text.toStdString()}; }

}  // namespace ew::ui
