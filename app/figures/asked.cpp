#include "app/figures/asked.h"

#include <fmt/format.h>

#include "app/figures/ownership.h"
#include "app/pages/blocks.h"
#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"
#include "viz/walk/asking.h"

namespace isect::program {

bool has_picture(const viz::Walk& walk, int step) {
  const viz::Scene scene = viz::question_scene(walk, step);
  return !scene.chart && !scene.items.empty();
}

std::string file_of_question(const Excerpt& e, int step) { return file_of(e, step) + "-question"; }

Excerpt asking(const Excerpt& e, int step) {
  Excerpt asked = e;
  asked.steps = {static_cast<int>(e.walk.steps.size())};
  asked.walk.steps.push_back(viz::asking_step(e.walk, step));
  return asked;
}

Piece piece_of_question(const Excerpt& e, int step) {
  const int number = number_of_question(e.walk, step);
  Piece piece = piece_of(e, step);
  piece.stem = piece.metadata["file"] = file_of_question(e, step);
  piece.title = fmt::format("Question {}", number);
  piece.caption = prompt(e.walk, step);
  piece.imprint = fmt::format("{}: question {}", viz::plain(e.lesson->title), number);
  piece.alt = viz::drawn_text(e.walk, viz::question_scene(e.walk, step), false);
  return piece;
}

}  // namespace isect::program
