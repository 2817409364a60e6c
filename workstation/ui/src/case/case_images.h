#pragma once

#include <QWidget>
#include <filesystem>
#include <string>
#include <vector>

namespace ew::ui {

/// The images of an earlier examination, small, in a row that wraps; one that is chosen is shown large until it is closed.
/// @param files as the case names them; what is not there is left out
[[nodiscard]] QWidget* caseImages(const std::filesystem::path& folder, const std::vector<std::string>& files, const QString& title);

}  // namespace ew::ui
