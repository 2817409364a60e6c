#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "ew/controls/binding.h"
#include "ew/controls/hub.h"
#include "ew/controls/learn.h"

namespace ew::ui {

/// Something of the window that a knob can move.
struct SurfaceSetting {
  std::string id;
  QString group, name;
  std::function<bool()> isThere = [] { return true; };        ///< false: off, or the probe does not have it
  std::function<std::optional<double>()> present;             ///< 0..1 of its range; empty: it has none
  std::function<void(double)> to = [](double) {};             ///< 0..1
  std::function<void(double)> by = [](double) {};             ///< so many steps
  std::function<QString()> words = [] { return QString(); };  ///< its value, for people
};

/// The knobs and buttons of devices, and what they do in the window. Devices are looked for only while something is bound or learned.
class ControlSurface final : public QObject {
  Q_OBJECT

 public:
  /// What the window lends.
  struct Window {
    std::vector<SurfaceSetting> settings;
    std::function<bool(const std::string& command)> doCommand;
    std::function<void(const QString& sentence)> say;
  };

  explicit ControlSurface(QObject* parent = nullptr);
  ~ControlSurface() override;

  void setWindow(Window window) { window_ = std::move(window); }
  [[nodiscard]] const std::vector<SurfaceSetting>& settings() const { return window_.settings; }
  [[nodiscard]] const SurfaceSetting* setting(const std::string& id) const;
  /// In place of the system's (tests).
  void setBackends(std::vector<std::unique_ptr<controls::Backend>> backends);

  [[nodiscard]] const std::vector<controls::Binding>& bindings() const { return bindings_; }
  void setBindings(std::vector<controls::Binding> bindings);

  /// From now on controls do nothing, until one of them is found for the target or stopLearning().
  void learn(const controls::Target& target);
  void stopLearning();
  [[nodiscard]] bool isLearning() const { return learner_.has_value(); }
  [[nodiscard]] controls::Learner::Needs learnerNeeds() const;
  /// Looks for all devices, so that state() tells them.
  void setLooking(bool looking);
  [[nodiscard]] controls::Hub::State state() const { return hub_->state(); }
  /// Looks for devices and takes what they sent, at once (tests).
  void takeNow();

 Q_SIGNALS:
  void bindingsChanged();              ///< by learning
  void learnt(const QString& before);  ///< a binding was added; what that control did until now, or nothing
  void learningChanged();
  void stateChanged();

 private:
  void makeHub(std::vector<std::unique_ptr<controls::Backend>> backends);
  void wantDevices();
  void drain();
  void take(const controls::ControlEvent& event);
  void follow(std::size_t binding, int value);
  void keep(const controls::Learned& found);

  Window window_;
  std::vector<controls::Binding> bindings_;
  std::map<std::size_t, controls::Follower> followers_;  ///< by binding
  std::optional<controls::Learner> learner_;
  controls::Target wanted_;
  bool isLooking_ = false;
  controls::Hub::State told_;
  std::unique_ptr<controls::Hub> hub_;  ///< last: its threads end before the rest
};

}  // namespace ew::ui
