#include <exception>
#include <string>

#include "film_parts.h"
#include "loudness.h"
#include "why_not.h"

extern "C" {

__attribute__((visibility("default"))) EwFilmOpen ewFilmOpen;
__attribute__((visibility("default"))) EwFilmNext ewFilmNext;
__attribute__((visibility("default"))) EwFilmFaults ewFilmFaults;
__attribute__((visibility("default"))) EwFilmClose ewFilmClose;

EwFilm* ewFilmOpen(const char* file, int kind, const char* container, const char* codecs, EwFilmFacts* facts, char* why, std::size_t room) {
  try {
    silence();
    std::string reason;
    auto opened = kind == ewFilmOfPages ? openPages(file, reason) : openVideo(file, container, codecs, *facts, reason);
    if (!opened) {
      if (!reason.empty()) tell(reason.c_str(), why, room);
      return nullptr;
    }
    *facts = opened->facts;
    return opened.release();
  } catch (const std::exception& problem) {
    tell(problem.what(), why, room);
    return nullptr;
  }
}

int ewFilmNext(EwFilm* film, unsigned char* rgb, double* time_s, char* why, std::size_t room) {
  try {
    return film->next(rgb, *time_s);
  } catch (const std::exception& problem) {
    tell(problem.what(), why, room);
    return -1;
  }
}

int ewFilmFaults(const EwFilm* film) { return film->faults(); }

void ewFilmClose(EwFilm* film) { delete film; }

}  // extern "C"
