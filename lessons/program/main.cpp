// isect, or the program of one lesson where ISECT_LESSON names it.

#include "lessons/lessons.h"
#include "lessons/program/program.h"
#include "lessons/program/terminal.h"
#include "viz/place.h"

int main(int argc, char** argv) {
  using namespace isect;
  program::guard_streams();
  program::Program program{"isect", lessons::all_lessons()};
#ifdef ISECT_LESSON
  program.name = ISECT_LESSON;
  program.only = &viz::lesson_named(program.lessons, ISECT_LESSON);
#endif
  return program::run(program, {argv + 1, argv + argc});
}
