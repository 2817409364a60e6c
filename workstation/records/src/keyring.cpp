#include "keyring.h"

#include "ew/records/record_store_settings.h"

#ifdef EW_HAVE_LIBSECRET
#include <libsecret/secret.h>

#include <condition_variable>
#include <mutex>
#include <thread>
#endif

namespace ew {

bool hasKeyring() {
#ifdef EW_HAVE_LIBSECRET
  return true;
#else
  return false;
#endif
}

namespace records {

#ifdef EW_HAVE_LIBSECRET
namespace {

const SecretSchema& schema() {
  static const SecretSchema made = [] {
    SecretSchema one{};
    one.name = "io.echoweave.Records";
    one.flags = SECRET_SCHEMA_NONE;
    one.attributes[0] = {"folder", SECRET_SCHEMA_ATTRIBUTE_STRING};
    one.attributes[1] = {"name", SECRET_SCHEMA_ATTRIBUTE_STRING};
    return one;
  }();
  return made;
}

/// Cancels a call that takes too long: a keyring may wait for its owner for ever.
class Limit {
 public:
  explicit Limit(double seconds) : cancellable_(g_cancellable_new()), thread_([this, seconds] { watch(seconds); }) {}
  ~Limit() {
    {
      const std::lock_guard lock(mutex_);
      isDone_ = true;
    }
    changed_.notify_one();
    thread_.join();
    g_object_unref(cancellable_);
  }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;
  [[nodiscard]] GCancellable* cancellable() const { return cancellable_; }

 private:
  void watch(double seconds) {
    std::unique_lock lock(mutex_);
    if (!changed_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return isDone_; })) g_cancellable_cancel(cancellable_);
  }
  GCancellable* cancellable_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool isDone_ = false;
  std::thread thread_;  // last: it uses the others
};

KeyringAnswer failedBy(GError* error) {
  KeyringAnswer answer{Keyring::absent, {}, error->message != nullptr ? error->message : "no reason was given"};
  g_error_free(error);
  return answer;
}

std::string folderName(const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(folder, ignored).string();
}

}  // namespace

KeyringAnswer keepInKeyring(const std::filesystem::path& folder, const std::string& name, const std::string& secret, double timeout_s) {
  const Limit limit(timeout_s);
  GError* error = nullptr;
  secret_password_store_sync(&schema(), SECRET_COLLECTION_DEFAULT, ("EchoWeave: " + name).c_str(), secret.c_str(), limit.cancellable(),
                             &error, "folder", folderName(folder).c_str(), "name", name.c_str(), nullptr);
  return error != nullptr ? failedBy(error) : KeyringAnswer{Keyring::done, {}, {}};
}

KeyringAnswer readKeyring(const std::filesystem::path& folder, const std::string& name, double timeout_s) {
  const Limit limit(timeout_s);
  GError* error = nullptr;
  gchar* secret = secret_password_lookup_sync(&schema(), limit.cancellable(), &error, "folder", folderName(folder).c_str(), "name",
                                              name.c_str(), nullptr);
  if (error != nullptr) return failedBy(error);
  if (secret == nullptr) return {Keyring::empty, {}, {}};
  KeyringAnswer answer{Keyring::done, secret, {}};
  secret_password_free(secret);
  return answer;
}

KeyringAnswer forgetInKeyring(const std::filesystem::path& folder, const std::string& name, double timeout_s) {
  const Limit limit(timeout_s);
  GError* error = nullptr;
  const bool isGone = secret_password_clear_sync(&schema(), limit.cancellable(), &error, "folder", folderName(folder).c_str(), "name",
                                                 name.c_str(), nullptr) != FALSE;
  if (error != nullptr) return failedBy(error);
  return {isGone ? Keyring::done : Keyring::empty, {}, {}};
}

#else

KeyringAnswer keepInKeyring(const std::filesystem::path&, const std::string&, const std::string&, double) { return {}; }
KeyringAnswer readKeyring(const std::filesystem::path&, const std::string&, double) { return {}; }
KeyringAnswer forgetInKeyring(const std::filesystem::path&, const std::string&, double) { return {}; }

#endif

}  // namespace records
}  // namespace ew
