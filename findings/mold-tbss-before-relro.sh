#!/usr/bin/env bash
# mold 1.10.1 (Debian mold 1.10.1+dfsg-1): a program's PT_GNU_RELRO begins at .tbss, although
# .tbss has no memory of its own there: its address lies behind the code, in the gap before
# the next segment. When the first real section after it (.dynamic) is aligned over a page
# boundary, RELRO begins in a page that nothing maps, and the dynamic loader ends the program
# before main with "cannot apply additional memory protection after relocation: Cannot
# allocate memory". It depends on the size of the code alone: a zero-initialised
# thread-local byte, and code that ends a few bytes before a page, are enough.
# Surprised: whoever adds `static __thread char flag;` to a library, and later one of many
# programs that link it does not start, in one folder and not in the other.
# Expected: RELRO begins at the first section that is mapped (GNU ld: .tdata or .init_array).
# Compiled with the gcc of the machine (seen with 12.2.0). Source: ELF gABI, Thread-Local Storage: SHF_TLS sections of type SHT_NOBITS take no space
# in the image; elf(5) PT_GNU_RELRO: the region to be made read-only after relocation.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

packages=(mold=1.10.1+dfsg-1)
apt=(apt-get -qq -o APT::Sandbox::User=root)
if ! "${apt[@]}" download "${packages[@]}" >/dev/null 2>&1; then
  mkdir -p lists/partial cache/archives/partial
  apt+=(-o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache")
  "${apt[@]}" update
  "${apt[@]}" download "${packages[@]}" >/dev/null
fi
for deb in *.deb; do dpkg -x "$deb" root; done
version=$(dpkg-deb -f mold_*.deb Version)
[ "$version" = 1.10.1+dfsg-1 ] || { echo "This is mold $version, another one." >&2; exit 1; }
mkdir linker
ln -s "$work/root/usr/bin/mold" linker/ld

cat > main.c <<'C'
static __thread char flag;
int main(int count, char **words) { (void)words; flag = (char)count; return flag - count; }
__asm__(".text\n.zero SIZE\n");
C

ended() { # LINKER-OPTION SIZE: compiles, links and runs; prints ok or what the loader says
  sed "s/SIZE/$2/" main.c > sized.c
  gcc -fPIE -pie $1 -o sized sized.c
  ./sized 2> said && echo ok || cat said
}

# Where .tbss comes to lie behind the code of the least size; then a size that puts it five bytes before a page.
[ "$(ended "-B$work/linker" 1)" = ok ] || { echo "The least program does not start." >&2; exit 1; }
at=$((16#$(readelf -SW sized | sed -n 's/.* \.tbss  *NOBITS  *\([0-9a-f]*\) .*/\1/p')))
size=$((1 + (16#ffb - at % 4096 + 4096) % 4096))
said=$(ended "-B$work/linker" "$size")
readelf -lW sized | grep -E 'GNU_RELRO|LOAD.* RW ' | head -2
readelf -SW sized | grep -E '\.tbss|\.dynamic '
echo "mold $version, $size bytes of code more: $said"
case $said in
*"cannot apply additional memory protection after relocation"*) ;;
*) echo "It starts: the behaviour has changed." >&2; exit 1 ;;
esac
[ "$(ended "" "$size")" = ok ] || { echo "GNU ld's does not start either." >&2; exit 1; }
echo "The same code linked by GNU ld starts."
