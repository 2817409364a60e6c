#!/usr/bin/env bash
# libubsan 12.2.0 (Debian libubsan1 12.2.0-14+deb12u1): in a program that has as many files
# open as it may have, -fsanitize=vptr calls sound objects broken ("does not point to an
# object of type", "object has invalid vptr"), and with -fno-sanitize-recover ends it.
# Before it reads an object it has not met, it opens a pipe and lets the kernel say whether
# the memory can be read; a pipe that cannot be made counts as memory that cannot.
# Types it has met stand in a small table by the address of their vtable, which changes from
# run to run: so a test that lets a reader meet EMFILE fails on some days only, inside
# std::istream as a rule.
# Surprised: whoever tests what a program says when files run out. Expected: no check, or a
# word about the pipe; the object is whole, and the same call is silent one file earlier.
# Compiled with the g++ of the machine (seen with 12.2.0). Source: the manual of GCC,
# -fsanitize=vptr: it tells of a wrong dynamic type, and of nothing that must be free for it.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

packages=(libubsan1=12.2.0-14+deb12u1)
apt=(apt-get -qq -o APT::Sandbox::User=root)
if ! "${apt[@]}" download "${packages[@]}" >/dev/null 2>&1; then
  mkdir -p lists/partial cache/archives/partial
  apt+=(-o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache")
  "${apt[@]}" update
  "${apt[@]}" download "${packages[@]}" >/dev/null
fi
for deb in *.deb; do dpkg -x "$deb" root; done
version=$(dpkg-deb -f libubsan1_*.deb Version)
[ "$version" = 12.2.0-14+deb12u1 ] || { echo "This is libubsan $version, another one." >&2; exit 1; }

cat > object.cpp <<'CPP'
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

struct Shape {
  virtual ~Shape() = default;
  virtual int corners() const { return 0; }
};
struct Square : Shape {
  int corners() const override { return 4; }
};
[[gnu::noinline]] int cornersOf(const Shape* shape) { return shape->corners(); }

int main(int, char** words) {
  const Square square;
  const int lowest = open("/dev/null", O_RDONLY);
  close(lowest);
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  files.rlim_cur = rlim_t(lowest + std::atoi(words[1]));  // so many files may still be opened
  setrlimit(RLIMIT_NOFILE, &files);
  std::printf("%d corners\n", cornersOf(&square));
}
CPP
g++ -fsanitize=vptr -o object object.cpp

called() { # FREE: what the sanitizer says of the object while so many files are free
  LD_LIBRARY_PATH="$work/root/usr/lib/x86_64-linux-gnu" ./object "$1" 2>&1 >corners | grep -c 'object has invalid vptr' || true
}

free=$(called 8)
[ "$(cat corners)" = "4 corners" ] && [ "$free" = 0 ] || { echo "With files free it complains as well." >&2; exit 1; }
none=$(called 0)
echo "libubsan $version: with 8 files free $free complaints, with none $none, about the same call, which says $(cat corners)."
[ "$none" -gt 0 ] || { echo "It is silent: the behaviour has changed." >&2; exit 1; }
