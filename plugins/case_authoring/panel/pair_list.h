#pragma once

#include <functional>
#include <string>
#include <vector>

#include "logic/landmark_pairs.h"
#include "panel/list_field.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace ew::case_authoring {

/// Pairs of places, one below the other: what the author calls it, where it is in the volume and on the body, and how far the two lie
/// apart when the volume is placed by all of them.
class PairList final : public EntryRows {
  Q_OBJECT

 public:
  explicit PairList(QWidget* parent = nullptr);

  void setLandmarks(std::vector<BodyLandmark> landmarks);
  /// What is being pointed at now: of which pair, and whether in the image.
  struct Asked {
    std::size_t pair = 0;
    bool inImage = true;
    bool operator==(const Asked&) const = default;
  };
  void show(const std::vector<DraftPair>& pairs, const PairsFit& fit, const std::optional<Asked>& asked);

  std::function<void(std::size_t pair, const QString& name)> onNamed;
  std::function<void(std::size_t pair)> onRemoved;
  std::function<void(std::size_t pair, bool asks)> onInImage;                ///< the author is to point at it there, or not any more
  std::function<void(std::size_t pair)> onOnBody;                            ///< the same on the body
  std::function<void(std::size_t pair, const BodyLandmark& at)> onLandmark;  ///< its place on the body is a named one

 private:
  struct Row {
    QLineEdit* name = nullptr;
    QLabel* residual = nullptr;
    QPushButton* inImage = nullptr;
    QComboBox* onBody = nullptr;
  };
  void remake(std::size_t count);
  [[nodiscard]] Row addRow(std::size_t pair, QVBoxLayout& rows);
  void showBody(QComboBox& choice, const DraftPair& pair, bool asked) const;
  void chooseBody(std::size_t pair, int index);

  std::vector<BodyLandmark> landmarks_;
  std::vector<Row> rows_;
};

}  // namespace ew::case_authoring
