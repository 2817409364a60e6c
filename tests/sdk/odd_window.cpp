// A plugin of the window that throws from every place where the window calls it, or from its constructor: ODD_WINDOW says which
// ("create": once everything is registered), ODD_WINDOW_NUMBER that a number is thrown in place of an exception, ODD_WINDOW_UNSAVED that
// its document holds something.
#include <QPushButton>
#include <QVBoxLayout>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "ew/sdk/plugin.h"

namespace {

bool says(const char* variable, const std::string& value) {
  const char* set = std::getenv(variable);
  return set != nullptr && value == set;
}

[[noreturn]] void fail(const char* why) {
  if (says("ODD_WINDOW_NUMBER", "yes")) throw 42;
  throw std::runtime_error(why);
}

/// Works until it is undone, redone or saved: a document that could not even be asked would have no undo to fail.
class OddDocument final : public ew::sdk::PanelDocument {
 public:
  std::string title() const override { return "Odd project"; }
  std::string remark() const override { return {}; }
  std::string note() const override { fail("the note is gone"); }
  std::string undoText() const override { return "Being odd"; }
  std::string redoText() const override { return "Being odder"; }
  void undo() override { fail("the undo is gone"); }
  void redo() override { fail("the redo is gone"); }
  void save(bool) override { fail("the disk is gone"); }
  std::string unsaved() const override { return says("ODD_WINDOW_UNSAVED", "yes") ? "The odd project is not saved." : ""; }
  std::shared_ptr<void> onChanged(std::function<void()> callback) override {
    return std::make_shared<std::function<void()>>(std::move(callback));
  }
};

class OddWindow final : public ew::sdk::Plugin {
 public:
  explicit OddWindow(ew::sdk::Host& host) : host_(host) {
    host.panels().add("odd_column", "Odd column", [this](QWidget* parent) -> QWidget* {
      auto* half = new QPushButton(QStringLiteral("Half of a panel"), parent);
      half->setObjectName(QStringLiteral("halfMade"));
      fail(why_.c_str());
    });
    host.panels().addStaged({"odd_stage",
                             "Odd stage",
                             [this](QWidget* parent) { return column(parent); },
                             [](QWidget* parent) { return new QWidget(parent); },
                             document_,
                             {}});
    ticket_ = host.cases().onChanged([this] { fail((why_ + " change").c_str()); });
    if (says("ODD_WINDOW", "create")) fail("changed its mind");
  }

 private:
  QWidget* column(QWidget* parent) {
    auto* column = new QWidget(parent);
    auto* rows = new QVBoxLayout(column);
    const auto add = [&](const char* name, auto pressed) {
      auto* button = new QPushButton(QLatin1String(name), column);
      button->setObjectName(QLatin1String(name));
      QObject::connect(button, &QPushButton::clicked, column, pressed);
      rows->addWidget(button);
    };
    add("failAtOnce", [this] { fail((why_ + " click").c_str()); });
    add("failInWork",
        [this] { host_.jobs().start("Odd work", [this](ew::Progress&) -> ew::Result<void> { fail((why_ + " work").c_str()); }, {}); });
    add("failInDone", [this] {
      host_.jobs().start(
          "Odd ending", [](ew::Progress&) { return ew::Result<void>(); },
          [this](const ew::Result<void>&) { fail((why_ + " done").c_str()); });
    });
    return column;
  }

  ew::sdk::Host& host_;
  std::string why_ = "odd";  // used by what is called, so that a call into a plugin that is gone is noticed
  std::shared_ptr<OddDocument> document_ = std::make_shared<OddDocument>();
  ew::sdk::Cases::Ticket ticket_;
};

}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) { return new OddWindow(host); }
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
