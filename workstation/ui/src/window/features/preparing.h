#pragma once

#include <QString>
#include <map>
#include <string>

#include "window/frame/feature.h"

namespace ew::ui {

struct CaseToMake;

/// Cases whose volumes are made in the background: what the cards say of them, and what the window tells when one is ready.
class Preparing final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void connectParts() override;

  /// Makes the volumes of the shipped cases that have none yet; while something is opened that waits until openingIsRead().
  void begin();
  /// What was being opened when the work was to begin is read, and has the work paused where it makes a volume itself; or it is over.
  void openingIsRead();
  /// Prepares a case without taking what is open away, and offers it when it is ready.
  void prepareBehind(const QString& path, const CaseToMake& left);
  void tellBehind(const CaseToMake& left);  ///< that it is being prepared
  void show();                              ///< on the cards in sight
  /// It is open: nobody has to be told that it is ready.
  void forgetOffer(const std::string& caseId);

 private:
  void offer(const QString& caseId);

  struct Offer {
    QString path, title;
  };
  std::map<std::string, Offer> offers_;  ///< by the case's id: those that are prepared behind what is open
  bool waitsToBegin_ = false;
};

}  // namespace ew::ui
