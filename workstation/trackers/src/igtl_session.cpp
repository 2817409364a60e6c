#include "ew/trackers/igtl_session.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ew {
namespace {

constexpr std::size_t kIgtlMostTools = 64;  // as the queue: made-up names must not fill the memory
constexpr double kIgtlTroubleLasts_s = 2.0;
constexpr double kIgtlLookEvery_s = 0.25;  // PLUS says STATUS as often when it has nothing else to say

/// Whether @p wait_s is over. The end of the wait is the same sum that tick_s() gives: the difference of two clock readings can be a last
/// digit short of it, and who is called at tick_s() would then be called for ever.
bool isOver(double since_s, double wait_s, double now_s) { return now_s >= since_s + wait_s; }

std::string igtlAddressText(const IgtlSettings& settings) {
  const bool isIpv6 = settings.host.find(':') != std::string::npos;
  return (isIpv6 ? "[" + settings.host + "]" : settings.host) + ":" + std::to_string(settings.port);
}

}  // namespace

IgtlSession::IgtlSession(IgtlSettings settings, IgtlTiming timing, ReadingQueue& queue)
    : settings_(std::move(settings)),
      timing_(timing),
      queue_(queue),
      reader_(settings_.checksSums),
      address_(igtlAddressText(settings_)),
      pause_s_(timing.firstPause_s) {}

void IgtlSession::opened(double now_s) {
  reader_.reset();
  toSend_.clear();
  tools_.clear();
  trouble_ = {};
  isOpen_ = true;
  heardPose_ = false;
  opened_s_ = bytes_s_ = message_s_ = pose_s_ = asked_s_ = looked_s_ = now_s;
  if (settings_.speaksVersion3) ask("GET_STATUS", {}, 2);
  told_ = Told::nothing;
  tell(Told::connected, now_s);
}

void IgtlSession::closed(double now_s, Message why) {
  isOpen_ = false;
  told_ = Told::nothing;
  attempt_s_ = now_s + pause_s_;
  pause_s_ = std::min(2.0 * pause_s_, timing_.longestPause_s);
  reader_.reset();
  toSend_.clear();
  queue_.setLink(LinkState::connecting, std::move(why), now_s);
}

bool IgtlSession::received(std::span<const std::uint8_t> bytes, double now_s) {
  bytes_s_ = now_s;
  const auto read = reader_.read(
      bytes, [this, now_s](const IgtlMessage& message) { take(message, now_s); }, [this](Message why) { queue_.refuse(std::move(why)); });
  if (read) return true;
  queue_.refuse(read.error().message);
  closed(now_s, read.error().message);
  return false;
}

void IgtlSession::take(const IgtlMessage& message, double now_s) {
  message_s_ = now_s;
  pause_s_ = timing_.firstPause_s;  // not when the connection opens: a server that hangs up at once would be tried without a pause
  if (told_ == Told::noBytes) tell(Told::noPoses, now_s);
  if (const auto status = igtlStatus(message)) takeStatus(*status, now_s);
  if (const auto poses = igtlPoses(message)) {
    takePoses(message, *poses, now_s);
  } else {
    queue_.refuse(poses.error().message);
  }
  lookForMissing(now_s);
}

void IgtlSession::takeStatus(const IgtlStatus& status, double now_s) {
  const bool isNews = status != std::exchange(trouble_, status);
  if (status.code != 1) {
    trouble_s_ = now_s;
    if (isNews) told_ = Told::nothing;  // another trouble has another sentence
    tell(Told::trouble, now_s);
  } else if (told_ == Told::trouble) {
    tell(heardPose_ ? Told::connected : Told::noPoses, now_s);
  }
}

void IgtlSession::takePoses(const IgtlMessage& message, const std::vector<IgtlPose>& poses, double now_s) {
  const bool isList = message.type == "TDATA" || message.type == "QTDATA";
  const std::string list = isList ? message.type + " " + message.device : std::string();
  for (const IgtlPose& pose : poses) {
    heardPose_ = true;
    pose_s_ = now_s;
    if (!pose.refusal.empty()) queue_.refuse(pose.refusal);
    if (auto known = tools_.find(pose.tool); known != tools_.end()) {
      known->second.latest_s = now_s;
    } else if (tools_.size() < kIgtlMostTools) {
      tools_.emplace(pose.tool, Tool{list, now_s});
    }
    queue_.add(
        {.tool = pose.tool, .toolToTracker = pose.toolToTracker, .state = pose.state, .device_s = message.time_s, .arrival_s = now_s});
  }
  // A single complaint, about our question for TDATA perhaps, is over when poses keep coming; a lasting one is repeated.
  if (!poses.empty() && (told_ != Told::trouble || now_s - trouble_s_ > kIgtlTroubleLasts_s)) tell(Told::connected, now_s);
  if (!isList) return;
  for (auto& [name, tool] : tools_) {
    if (tool.list != list || std::any_of(poses.begin(), poses.end(), [&name = name](const IgtlPose& pose) { return pose.tool == name; }))
      continue;
    tool.latest_s = now_s;
    sayMissing(name, message.time_s, now_s);
  }
}

void IgtlSession::sayMissing(const std::string& tool, double device_s, double now_s) {
  queue_.add({.tool = tool, .toolToTracker = {}, .state = TrackingState::outOfView, .device_s = device_s, .arrival_s = now_s});
}

void IgtlSession::lookForMissing(double now_s) {
  if (now_s - looked_s_ < kIgtlLookEvery_s) return;
  looked_s_ = now_s;
  for (const auto& [name, tool] : tools_)
    if (now_s - tool.latest_s >= timing_.silentAfter_s) sayMissing(name, std::numeric_limits<double>::quiet_NaN(), now_s);
}

bool IgtlSession::tick(double now_s) {
  if (!isOpen_) return true;
  if (isOver(bytes_s_, timing_.anewAfter_s, now_s)) {
    closed(now_s, say<"Nothing came from %1 for long; the connection is opened anew. Check that the server runs and sends.">(address_));
    return false;
  }
  if (bytes_s_ > message_s_ && isOver(message_s_, timing_.stepLostAfter_s, now_s)) {
    closed(now_s, say<"What %1 sends holds no message any more; the connection is opened anew.">(address_));
    return false;
  }
  if (isOver(message_s_, timing_.silentAfter_s, now_s)) {
    tell(Told::noBytes, now_s);
  } else if (isOver(pose_s_, timing_.silentAfter_s, now_s) && told_ != Told::trouble) {
    tell(Told::noPoses, now_s);
  }
  if (!heardPose_ && isOver(asked_s_, questionPause_s(), now_s)) {
    asked_s_ = now_s;
    ask("STT_TDATA", igtlStartTrackingContent(), 1);
  }
  return true;
}

double IgtlSession::questionPause_s() const { return asked_s_ > opened_s_ ? timing_.asksEvery_s : timing_.asksAfter_s; }

double IgtlSession::tick_s() const {
  if (!isOpen_) return attempt_s_;
  double next_s = bytes_s_ + timing_.anewAfter_s;
  if (bytes_s_ > message_s_) next_s = std::min(next_s, message_s_ + timing_.stepLostAfter_s);
  if (told_ == Told::connected) next_s = std::min(next_s, pose_s_ + timing_.silentAfter_s);
  if (told_ == Told::noPoses || told_ == Told::trouble) next_s = std::min(next_s, message_s_ + timing_.silentAfter_s);
  if (!heardPose_) next_s = std::min(next_s, asked_s_ + questionPause_s());
  return next_s;
}

void IgtlSession::tell(Told what, double now_s) {
  if (what == std::exchange(told_, what)) return;
  if (const Message sentence = sentenceFor(what); !sentence.empty()) queue_.setLink(LinkState::connected, sentence, now_s);
}

Message IgtlSession::sentenceFor(Told what) const {
  switch (what) {
    case Told::nothing:
      return {};
    case Told::connected:
      return say<"Connected with %1.">(address_);
    case Told::noPoses:
      return heardPose_
                 ? say<"The server at %1 answers, but sends no poses any more; bring the tools back into the tracker's view.">(address_)
                 : say<"The server at %1 answers, but sends no poses; check that the tools are in view, and that the server is set up to "
                       "send transforms.">(address_);
    case Told::noBytes:
      return heardPose_ ? say<"Nothing comes from %1 any more; check that the tracker and its server still run.">(address_)
                        : say<"Connected with %1, but nothing comes; check that the server is set up to send transforms.">(address_);
    case Told::trouble:
      return igtlStatusSentence(trouble_);
  }
  return {};
}

void IgtlSession::ask(const char* type, std::vector<std::uint8_t> content, int version) {
  IgtlMessage question;
  question.version = version;
  question.type = type;
  question.content = std::move(content);
  const std::vector<std::uint8_t> bytes = igtlBytes(question);
  toSend_.insert(toSend_.end(), bytes.begin(), bytes.end());
}

std::vector<std::uint8_t> IgtlSession::takeToSend() { return std::exchange(toSend_, {}); }

std::size_t IgtlSession::held_bytes() const {
  std::size_t held = reader_.held_bytes() + toSend_.size();
  for (const auto& [name, tool] : tools_) held += sizeof(tool) + name.size() + tool.list.size();
  return held;
}

}  // namespace ew
