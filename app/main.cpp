// isect, or the program of one lesson.

#include <new>

#include "app/program.h"
#include "app/shell/terminal.h"
#include "lessons/lessons.h"
#include "viz/gl/resources.h"

namespace isect::program {
extern const char* const only_lesson;  ///< the lesson's id, or null: all lessons. CMake writes it for each program.
}

int main(int argc, char** argv) try {
  using namespace isect;
  program::guard_streams();
  viz::share_scarce_heap();
  return program::run(lessons::all_lessons(), program::only_lesson, {argv + 1, argv + argc});
} catch (const std::bad_alloc&) {  // before a command was chosen
  isect::program::say("isect: out of memory");
  return isect::program::file_trouble;
}
