#!/usr/bin/env bash
# SDL 2.26.5 (Debian libsdl2 2.26.5+dfsg-1): an audio device without a callback, the one
# SDL_QueueAudio() is for, is served by a thread with a stack of 64 KiB. glibc takes a
# thread's static TLS from its stack, so in a program whose libraries keep more than
# that in thread-local variables SDL_OpenAudioDevice() fails with "Couldn't create audio
# thread" - with every driver, and only where no callback is given: the same device opens
# with one. Which libraries are linked decides, not what the program does.
# Surprised: whoever adds queued sound to a large program, having tried it in a small one.
# Expected: a stack that the thread's own TLS fits beside (glibc: __pthread_get_minstack),
# or an error that names the stack.
# Compiled with the gcc of the machine (seen with 12.2.0, glibc 2.36).
# Source: SDL 2.26 src/audio/SDL_audio.c, open_audio_device(): a stack of 64 * 1024 for
# devices whose callback is SDL's own; pthread_attr_setstacksize(3) and pthread_create(3).
set -euo pipefail

packages=(libsdl2-2.0-0=2.26.5+dfsg-1 libsdl2-dev=2.26.5+dfsg-1)
# What SDL is linked with, in whatever version the release has now.
linked=(libasound2 libasyncns0 libbsd0 libdecor-0-0 libdrm2 libffi8 libflac12 libgbm1 libgcrypt20 libgpg-error0 liblz4-1 liblzma5
  libmd0 libmp3lame0 libmpg123-0 libogg0 libopus0 libpulse0 libsamplerate0 libsndfile1 libsystemd0 libvorbis0a libvorbisenc2
  libwayland-client0 libwayland-cursor0 libwayland-egl1 libwayland-server0 libx11-6 libx11-xcb1 libxau6 libxcb1 libxcursor1 libxdmcp6
  libxext6 libxfixes3 libxi6 libxkbcommon0 libxrandr2 libxrender1 libxss1 libzstd1 libcap2 libdbus-1-3 libexpat1)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

apt=(apt-get -qq -o APT::Sandbox::User=root)
if ! "${apt[@]}" download "${packages[@]}" "${linked[@]}" >/dev/null 2>&1; then
  mkdir -p lists/partial cache/archives/partial
  apt+=(-o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache")
  "${apt[@]}" update
  "${apt[@]}" download "${packages[@]}" "${linked[@]}" >/dev/null
fi
for deb in *.deb; do dpkg -x "$deb" root; done
version=$(dpkg-deb -f libsdl2-2.0-0_*.deb Version)
[ "$version" = 2.26.5+dfsg-1 ] || { echo "This is SDL $version, another one." >&2; exit 1; }

cat > open.c <<'C'
#include <SDL.h>
#include <stdio.h>

static __thread volatile char kept[KEPT]; /* as libraries keep buffers of a thread's own */

static void silence(void *user, Uint8 *out, int bytes) {
  (void)user;
  SDL_memset(out, 0, (size_t)bytes);
}

static const char *opened(SDL_AudioCallback callback) {
  SDL_AudioSpec wanted;
  SDL_memset(&wanted, 0, sizeof wanted);
  wanted.freq = 48000;
  wanted.format = AUDIO_F32SYS;
  wanted.channels = 2;
  wanted.samples = 1024;
  wanted.callback = callback;
  SDL_AudioDeviceID device = SDL_OpenAudioDevice(NULL, 0, &wanted, NULL, 0);
  if (device == 0) return SDL_GetError();
  SDL_CloseAudioDevice(device);
  return "opened";
}

int main(void) {
  kept[0] = 1;
  if (SDL_Init(SDL_INIT_AUDIO) != 0) return 2;
  printf("callback: %s\n", opened(silence));
  printf("queue: %s\n", opened(NULL));
  SDL_Quit();
  return 0;
}
C

lib="$work/root/usr/lib/x86_64-linux-gnu"
told() { # KEPT: what both ways of opening say in a program with so many thread-local bytes
  gcc -DKEPT="$1" -I "$work/root/usr/include/SDL2" -I "$work/root/usr/include/x86_64-linux-gnu" open.c -o "open$1" \
    "$lib/libSDL2-2.0.so.0" -Wl,--allow-shlib-undefined
  LD_LIBRARY_PATH="$lib:$work/root/lib/x86_64-linux-gnu:$lib/pulseaudio" SDL_AUDIODRIVER=dummy "./open$1"
}

small=$(told 1000)
large=$(told 100000)
printf '1,000 thread-local bytes:\n%s\n100,000 thread-local bytes:\n%s\n' "$small" "$large"
[ "$small" = $'callback: opened\nqueue: opened' ] || { echo "Changed: it does not open in a small program either." >&2; exit 1; }
[ "$large" = $'callback: opened\nqueue: Couldn\'t create audio thread' ] || { echo "Changed: queued audio opens, or says something else." >&2; exit 1; }
echo "As described: without a callback the device cannot be opened beside 100,000 thread-local bytes."
