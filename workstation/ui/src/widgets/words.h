#pragma once

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <filesystem>

#include "ew/core/data_file.h"
#include "ew/sdk/words.h"

namespace ew::ui {

using sdk::words;
/// Of a data file, in the window's language.
inline QString words(const Words& text) { return QString::fromStdString(text.in(QLocale().name().toStdString())); }
inline QString wordsOf(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }
inline std::filesystem::path pathOf(const QString& text) { return {text.toStdString()}; }

/// Of a probe, as people read it: the program's own in the window's language, those of others as they are called.
inline QString nameOfProbe(const std::string& name) { return QCoreApplication::translate("ew::Probe", name.c_str()); }

}  // namespace ew::ui
