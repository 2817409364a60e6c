#pragma once

#include <QObject>
#include <functional>
#include <string>
#include <vector>

#include "ew/annotation/annotation.h"
#include "ew/annotation/word_list.h"
#include "scan/still_image.h"

namespace ew::ui {

/// Texts and arrows on the image that stands still, and the words that are offered for it. They belong to one image, as calipers do:
/// another one of the cine loop or of a recording has its own, and the scan that goes on takes all of them away.
class ImageAnnotations final : public QObject {
  Q_OBJECT

 public:
  explicit ImageAnnotations(Session& session, QObject* parent = nullptr);

  void setWordLists(std::vector<annotation::WordList> lists);
  /// @param region of the case; empty: not known
  void setRegion(const std::string& region);
  /// The list of an examination; empty: that of the region.
  void chooseList(const std::string& id);
  /// The list in use; null: the words of all.
  [[nodiscard]] const annotation::WordList* wordList() const;
  /// The lists that go with every other one.
  [[nodiscard]] std::vector<const annotation::WordList*> commonLists() const;
  [[nodiscard]] const std::vector<std::string>& terms() const { return terms_; }

  /// Brings the image to a stand: a live one is frozen, what plays is paused. False, with a word, where there is none to write on.
  bool hold();
  /// Takes the arrow into the hand, or puts it down when it is there already.
  void takeArrow();
  void putDown();
  [[nodiscard]] bool isArrowAtHand() const { return isArrowAtHand_; }

  /// What is written changes places with that of another one, as Calipers::exchange has it.
  void exchange(ImageAnnotations& other);
  void tellOfAll() { Q_EMIT changed(); }
  /// Whether undo means the writing on this image: nothing was measured on it since.
  [[nodiscard]] bool wasWrittenLast() const { return wasWrittenLast_; }
  void setMeasuredLast() { wasWrittenLast_ = false; }

  [[nodiscard]] const annotation::AnnotationList& list() const { return lists_.now(); }
  [[nodiscard]] const std::vector<annotation::Annotation>& all() const { return list().now().all; }
  /// The one way to change what is there.
  void change(const std::function<void(annotation::AnnotationList&)>& edit);
  void select(int number);
  [[nodiscard]] int selected() const { return selected_; }  ///< 0: none

  [[nodiscard]] const annotation::HomePosition& home() const { return home_; }
  void setHome(const annotation::HomePosition& home);

 Q_SIGNALS:
  void changed();
  void pauseAsked();  ///< of a recording or the cine loop
  void said(const QString& sentence);

 private:
  void look();
  void forget();
  void showTerms();

  Session& session_;
  std::vector<annotation::WordList> wordLists_;
  std::string region_, chosen_;
  std::vector<std::string> terms_;
  OfImages<annotation::AnnotationList> lists_;
  bool isArrowAtHand_ = false;
  int selected_ = 0;
  bool wasWrittenLast_ = false;
  annotation::HomePosition home_;
};

}  // namespace ew::ui
