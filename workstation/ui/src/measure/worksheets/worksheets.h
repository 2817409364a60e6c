#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ew/measurement/examination.h"

namespace ew::ui {

class Calipers;
class Session;
struct MeasurementWork;

/// The worksheets of the scan that is open: one examination for each package that was chosen. What the calipers measure for an item is
/// entered as it is drawn, and stays when its image goes. Another patient begins with empty ones.
class Worksheets final : public QObject {
  Q_OBJECT

 public:
  Worksheets(Session& session, Calipers& calipers, QObject* parent = nullptr);

  void setPackages(std::vector<measurement::Package> packages);
  [[nodiscard]] const std::vector<std::shared_ptr<const measurement::Package>>& packages() const { return packages_; }

  /// @param id of a package; empty: none
  void choose(const std::string& id);
  [[nodiscard]] const measurement::Examination* current() const { return current_; }
  /// The one way to change answers and gestation, and to remove values. Expects a current one.
  void change(const std::function<void(measurement::Examination&)>& edit);
  /// Takes the caliper of an item into the hand, or puts it down when it is there for that.
  void measure(const std::string& item, const std::string& side);

  /// What people call an image (Calipers::image) of several; empty: it is the only one, or gone.
  std::function<QString(std::uint64_t)> nameOfImage;
  /// What speaks against measuring an item of this side in the image in hand; empty: nothing.
  std::function<QString(const std::string& side)> whyNotSide;

  /// All that was in them before the program ended, in place of what there is.
  void restore(const MeasurementWork& work);
  /// What is in them, to be kept: MeasurementWork::sheets and current.
  void keepIn(MeasurementWork& work) const;

  /// One with something in it that was not saved since; null when there is none.
  [[nodiscard]] const measurement::Examination* unsaved() const;
  /// Those with something in them.
  [[nodiscard]] std::vector<const measurement::Examination*> filled() const;
  /// These were written, as they were then: what was entered since is not saved.
  void setSaved(const std::vector<const measurement::Examination*>& written);
  /// All worksheets begin anew.
  void clear();

 Q_SIGNALS:
  void changed();
  void packagesChanged();
  void said(const QString& sentence);  ///< why a value was not entered

 private:
  void take();
  /// Once for each value, and when a drag has ended.
  void sayRefused();

  Calipers& calipers_;
  std::vector<std::shared_ptr<const measurement::Package>> packages_;
  std::map<std::string, measurement::Examination> examinations_;  ///< by package
  std::map<std::string, measurement::Examination> saved_;
  measurement::Examination* current_ = nullptr;
  QString refused_;  ///< why a value of the image is not entered; empty: all are
  QString said_;     ///< of it last
};

}  // namespace ew::ui
