// The one function that a page's script calls, from text to text.

#include <emscripten.h>

#include "lessons/lessons.h"
#include "web/browser_session.h"

/// The answer is good until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* isect_answer(const char* request) {
  static isect::web::BrowserSession session(isect::lessons::all_lessons());
  static std::string answer;
  return (answer = session.answer(request)).c_str();
}
