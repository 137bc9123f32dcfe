// Like page.cpp, but readers can also open scenes of their own.

#include <emscripten.h>

#include "lessons/lessons.h"
#include "web/scenes.h"

/// The answer is good until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* isect_answer(const char* request) {
  static isect::web::BrowserSession session(isect::lessons::all_lessons(), isect::web::read_scene,
                                            isect::web::take_file);
  static std::string answer;
  return (answer = session.answer(request)).c_str();
}
