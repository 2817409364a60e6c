#include "ew/trackers/igtl_server.h"

#include <poll.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "ew/core/contract.h"
#include "ew/trackers/igtl_bodies.h"
#include "ew/tracking/tool_reading.h"
#include "igtl_server_client.h"

namespace ew {
namespace {

constexpr std::size_t kIgtlMostClients = 16;
constexpr double kIgtlAcceptAgain_s = 0.5;      // after the system refused one, for want of descriptors or memory
constexpr std::size_t kIgtlMostHandedOver = 4;  // frames the thread has not packed yet

/// LPS to RAS is half a turn about the axis to the head: what is rigid stays rigid.
const glm::dmat4 kIgtlLpsToRas = glm::dmat4(-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

double igtlUniversalNow_s() { return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count(); }

struct IgtlHandedOver {
  Pose pose;
  GreyImage image;
  Transform<frame::World, frame::Image> imageToWorld;
  double time_s = 0.0;
};

}  // namespace

struct IgtlServer::State {
  explicit State(IgtlServerOptions given) : options(std::move(given)) {}

  void run();
  void acceptClients();
  void pass(const IgtlHandedOver& frame);
  void passStatus();
  void offer(const IgtlMessage& message, bool isImage);
  void offer(IgtlServerClient& client, IgtlPacket packet);
  void answer(IgtlServerClient& client, const IgtlMessage& question);
  void serve(IgtlServerClient& client, short events);
  [[nodiscard]] IgtlMessage statusMessage() const;
  [[nodiscard]] IgtlMessage poseMessage(const IgtlHandedOver& frame) const;

  const IgtlServerOptions options;
  std::mutex startOrStop;
  std::thread thread;
  std::atomic<bool> stopping = false;
  std::atomic<int> clientCount = 0;
  Wake wake;
  Listening listening;

  mutable std::mutex mutex;  ///< of what follows
  std::deque<IgtlHandedOver> handedOver;
  std::uint64_t lostPoses = 0;  ///< that were handed over faster than they could be packed
  IgtlServerStatus status;

  // Of the thread alone.
  std::vector<std::unique_ptr<IgtlServerClient>> clients;
  std::vector<IgtlServerClient*> ended;
  std::optional<IgtlHandedOver> latest;  ///< without its image
  double latestSent_s = 0.0;
  double acceptsFrom_s = 0.0;  ///< until then whoever wants to connect waits
  std::uint64_t sent = 0, droppedImages = 0, droppedPoses = 0;
  std::uint32_t id = 0;
};

IgtlServer::IgtlServer(IgtlServerOptions options) : state_(std::make_unique<State>(std::move(options))) {}
IgtlServer::~IgtlServer() { stop(); }

Result<int> IgtlServer::start() {
  const std::scoped_lock lock(state_->startOrStop);
  if (state_->thread.joinable()) return state_->listening.port;
  auto listening = listenOn(state_->options.port, state_->options.everyone);
  if (!listening) return passOn(listening.error());
  state_->listening = std::move(*listening);
  state_->stopping = false;
  state_->wake.answer();
  {
    const std::scoped_lock inner(state_->mutex);
    state_->status = {.port = state_->listening.port};
    state_->handedOver.clear();
  }
  state_->thread = std::thread([this] { state_->run(); });
  return state_->listening.port;
}

void IgtlServer::stop() {
  const std::scoped_lock lock(state_->startOrStop);
  if (!state_->thread.joinable()) return;
  state_->stopping = true;
  state_->wake.call();
  state_->thread.join();
  state_->listening = {};
  const std::scoped_lock inner(state_->mutex);
  state_->status.port = state_->status.clients = 0;
  state_->status.waiting_bytes = 0;
}

void IgtlServer::send(const IgtlFrame& frame) {
  if (state_->clientCount == 0) return;
  IgtlHandedOver handed{frame.pose, {}, frame.imageToWorld, frame.time_s > 0.0 ? frame.time_s : igtlUniversalNow_s()};
  if (frame.image.width > 0) handed.image = copyOf(frame.image);
  {
    const std::scoped_lock lock(state_->mutex);
    if (state_->handedOver.size() == kIgtlMostHandedOver) {
      state_->handedOver.pop_front();
      ++state_->lostPoses;
    }
    state_->handedOver.push_back(std::move(handed));
  }
  state_->wake.call();
}

IgtlServerStatus IgtlServer::status() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->status;
}

void IgtlServer::State::run() {
  latestSent_s = steadyNow_s();
  while (!stopping) {
    const bool accepts = steadyNow_s() >= acceptsFrom_s;
    std::vector<pollfd> asked = {{wake.number(), POLLIN, 0}, {listening.socket.number(), static_cast<short>(accepts ? POLLIN : 0), 0}};
    for (const auto& client : clients)
      asked.push_back({client->number(), static_cast<short>(client->hasMore() ? POLLIN | POLLOUT : POLLIN), 0});
    double idle_s = std::max(0.0, latestSent_s + options.idleAfter_s - steadyNow_s());
    if (!accepts) idle_s = std::min(idle_s, std::max(0.0, acceptsFrom_s - steadyNow_s()));
    ::poll(asked.data(), asked.size(), static_cast<int>(idle_s * 1e3) + 1);
    if (asked[0].revents != 0) wake.answer();

    std::deque<IgtlHandedOver> frames;
    {
      const std::scoped_lock lock(mutex);
      frames.swap(handedOver);
    }
    for (std::size_t n = 0; n + 2 < asked.size(); ++n)
      if (asked[n + 2].revents != 0) serve(*clients[n], asked[n + 2].revents);
    for (const IgtlHandedOver& frame : frames) pass(frame);
    if (steadyNow_s() - latestSent_s >= options.idleAfter_s) passStatus();
    for (const auto& client : clients) serve(*client, POLLOUT);
    std::erase_if(clients, [this](const auto& client) { return std::find(ended.begin(), ended.end(), client.get()) != ended.end(); });
    ended.clear();
    if (asked[1].revents != 0) acceptClients();

    clientCount = static_cast<int>(clients.size());
    const std::scoped_lock lock(mutex);
    status = {listening.port, clientCount, sent, droppedImages, droppedPoses + lostPoses, 0};
    for (const auto& client : clients) status.waiting_bytes += client->waiting_bytes();
  }
  clients.clear();
  clientCount = 0;
}

void IgtlServer::State::acceptClients() {
  while (true) {
    Descriptor socket(::accept4(listening.socket.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!socket) {
      // Whoever waits goes on waiting, and poll() would say so at once, again and again.
      if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR && errno != ECONNABORTED)
        acceptsFrom_s = steadyNow_s() + kIgtlAcceptAgain_s;
      return;
    }
    if (clients.size() == kIgtlMostClients) continue;  // closed again: more than that is no classroom but a fault
    clients.push_back(std::make_unique<IgtlServerClient>(std::move(socket)));
  }
}

IgtlMessage IgtlServer::State::poseMessage(const IgtlHandedOver& frame) const {
  IgtlMessage message;
  message.type = "TRANSFORM";
  message.device = options.poseName;
  message.time_s = frame.time_s;
  message.content = igtlTransformContent(kIgtlLpsToRas * frame.pose.probeToWorld.matrix);
  message.words = {{"TransformStatus", "OK"}};
  return message;
}

IgtlMessage IgtlServer::State::statusMessage() const {
  IgtlStatus said{.code = 1, .subcode = 0, .name = "OK", .text = ""};
  constexpr int kNotPresent = 16;
  if (latest && latest->pose.status != PoseStatus::ok) said = {kNotPresent, 0, "ProbeNotTracked", "The probe is not tracked at the moment"};
  IgtlMessage message;
  message.type = "STATUS";
  message.device = "EchoWeave";
  message.time_s = igtlUniversalNow_s();
  message.content = igtlStatusContent(said);
  return message;
}

void IgtlServer::State::pass(const IgtlHandedOver& frame) {
  const bool wasOk = !latest || latest->pose.status == PoseStatus::ok, isOk = frame.pose.status == PoseStatus::ok;
  latest = IgtlHandedOver{frame.pose, {}, frame.imageToWorld, frame.time_s};
  if (isOk) offer(poseMessage(frame), false);
  if (isOk != wasOk) passStatus();
  if (frame.image.width > 0) {
    IgtlMessage image;
    image.type = "IMAGE";
    image.device = options.imageName;
    image.time_s = frame.time_s;
    image.content = igtlImageContent(viewOf(frame.image), kIgtlLpsToRas * frame.imageToWorld.matrix);
    offer(image, true);
  }
}

void IgtlServer::State::passStatus() { offer(statusMessage(), false); }

void IgtlServer::State::offer(const IgtlMessage& message, bool isImage) {
  latestSent_s = steadyNow_s();
  std::shared_ptr<const std::vector<std::uint8_t>> packed[2];
  IgtlMessage versioned = message;
  versioned.id = ++id;
  for (const auto& client : clients) {
    auto& bytes = packed[client->version() - 1];
    if (!bytes) {
      versioned.version = client->version();
      bytes = std::make_shared<const std::vector<std::uint8_t>>(igtlBytes(versioned));
    }
    offer(*client, {bytes, isImage});
  }
}

void IgtlServer::State::offer(IgtlServerClient& client, IgtlPacket packet) {
  const auto dropped = client.add(std::move(packet));
  droppedImages += static_cast<std::uint64_t>(dropped.images);
  droppedPoses += static_cast<std::uint64_t>(dropped.poses);
}

void IgtlServer::State::answer(IgtlServerClient& client, const IgtlMessage& question) {
  std::optional<IgtlMessage> said;
  if (question.type == "GET_STATUS") said = statusMessage();
  if (question.type == "GET_TRANS" && latest && latest->pose.status == PoseStatus::ok) said = poseMessage(*latest);
  if (!said) return;
  said->version = client.version();
  offer(client, {std::make_shared<const std::vector<std::uint8_t>>(igtlBytes(*said)), false});
}

void IgtlServer::State::serve(IgtlServerClient& client, short events) {
  bool isThere = true;
  if ((events & ~POLLOUT) != 0) isThere = client.receive([&](const IgtlMessage& question) { answer(client, question); });
  if (isThere && (events & POLLOUT) != 0) isThere = client.send(sent);
  if (!isThere) ended.push_back(&client);
}

}  // namespace ew
