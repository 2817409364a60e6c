#pragma once

#include <openssl/ssl.h>

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

namespace ew::test {

/// A record store behind TLS on 127.0.0.1 with a certificate that it made itself. It says yes to every POST.
class TlsServer {
 public:
  /// @param name that the certificate is for: "IP:127.0.0.1", "DNS:records.example"
  explicit TlsServer(const std::string& name);
  ~TlsServer();
  TlsServer(const TlsServer&) = delete;
  TlsServer& operator=(const TlsServer&) = delete;

  [[nodiscard]] std::string endpoint() const { return "https://127.0.0.1:" + std::to_string(port_) + "/xapi/"; }
  void writeCertificate(const std::filesystem::path& file) const;
  [[nodiscard]] int questions() const { return questions_; }  ///< that got through the encryption

 private:
  struct ContextEnd {
    void operator()(SSL_CTX* context) const { SSL_CTX_free(context); }
  };
  void serve();
  void talk(int connection);

  std::unique_ptr<SSL_CTX, ContextEnd> context_;
  int port_ = 0;
  int listener_ = -1;
  std::atomic<bool> stops_{false};
  std::atomic<int> questions_{0};
  std::thread thread_;
};

}  // namespace ew::test
