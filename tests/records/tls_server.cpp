#include "tls_server.h"

#include <arpa/inet.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rsa.h>
#include <openssl/x509v3.h>
#include <poll.h>
#include <pthread.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace ew::test {
namespace {

template <class T, void (*end)(T*)>
struct End {
  void operator()(T* object) const { end(object); }
};
using Key = std::unique_ptr<EVP_PKEY, End<EVP_PKEY, EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, End<X509, X509_free>>;

Certificate certificateFor(const std::string& name, EVP_PKEY* key) {
  Certificate made(X509_new());
  X509_set_version(made.get(), 2);
  ASN1_INTEGER_set(X509_get_serialNumber(made.get()), 1);
  X509_gmtime_adj(X509_getm_notBefore(made.get()), -3600);
  X509_gmtime_adj(X509_getm_notAfter(made.get()), 86'400);
  X509_set_pubkey(made.get(), key);
  X509_NAME* subject = X509_get_subject_name(made.get());
  X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_ASC, reinterpret_cast<const unsigned char*>("test"), -1, -1, 0);
  X509_set_issuer_name(made.get(), subject);
  for (const auto& [what, value] :
       {std::pair{NID_subject_alt_name, name}, std::pair{NID_basic_constraints, std::string("critical,CA:TRUE")}}) {
    X509_EXTENSION* extension = X509V3_EXT_conf_nid(nullptr, nullptr, what, value.c_str());
    X509_add_ext(made.get(), extension, -1);
    X509_EXTENSION_free(extension);
  }
  X509_sign(made.get(), key, EVP_sha256());
  return made;
}

}  // namespace

TlsServer::TlsServer(const std::string& name) : context_(SSL_CTX_new(TLS_server_method())) {
  const Key key(EVP_RSA_gen(2048));
  const Certificate certificate = certificateFor(name, key.get());
  if (SSL_CTX_use_certificate(context_.get(), certificate.get()) != 1 || SSL_CTX_use_PrivateKey(context_.get(), key.get()) != 1)
    std::abort();
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  if (::bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 || ::listen(listener_, 8) != 0) std::abort();
  ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
  port_ = ntohs(address.sin_port);
  thread_ = std::thread([this] { serve(); });
}

TlsServer::~TlsServer() {
  stops_ = true;
  thread_.join();
  ::close(listener_);
}

void TlsServer::writeCertificate(const std::filesystem::path& file) const {
  std::FILE* out = std::fopen(file.c_str(), "w");
  PEM_write_X509(out, SSL_CTX_get0_certificate(context_.get()));
  std::fclose(out);
}

void TlsServer::serve() {
  sigset_t pipe;  // OpenSSL writes to connections that may be closed
  sigemptyset(&pipe);
  sigaddset(&pipe, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
  while (!stops_) {
    pollfd waiting{listener_, POLLIN, 0};
    if (::poll(&waiting, 1, 10) <= 0) continue;
    const int connection = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (connection >= 0) talk(connection);
  }
}

void TlsServer::talk(int connection) {
  SSL* tls = SSL_new(context_.get());
  SSL_set_fd(tls, connection);
  std::string text(64 << 10, '\0');
  if (SSL_accept(tls) == 1) {
    std::size_t have = 0;
    for (int count = 1; count > 0 && text.substr(0, have).find("]") == std::string::npos;
         have += static_cast<std::size_t>(std::max(count, 0)))
      count = SSL_read(tls, text.data() + have, static_cast<int>(text.size() - have));
    if (have > 0) {
      ++questions_;
      const auto begin = text.find("\r\n\r\n");
      nlohmann::json ids = nlohmann::json::array();
      for (const auto& each : nlohmann::json::parse(text.substr(begin, have - begin))) ids.push_back(each["id"]);
      const std::string answer =
          "HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Length: " + std::to_string(ids.dump().size()) + "\r\n\r\n" + ids.dump();
      SSL_write(tls, answer.data(), static_cast<int>(answer.size()));
    }
    SSL_shutdown(tls);
  }
  SSL_free(tls);
  ::close(connection);
}

}  // namespace ew::test
