#include "app/figures/question_figure.h"

#include "app/figures/ownership.h"
#include "viz/lang/language.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"
#include "viz/walk/question_scene.h"
#include "viz/walk/step_text.h"

namespace isect::program {

bool has_picture(const viz::Walk& walk, int step) {
  const viz::Scene scene = viz::question_scene(walk, step);
  return !scene.chart && !scene.items.empty();
}

std::string file_of_question(const Excerpt& e, int step) { return file_of(e, step) + "-question"; }

FigureInfo info_of_question(const Excerpt& e, int step) {
  const viz::Speaking speaking(e.lesson->language);
  const viz::QuestionText question = *viz::question_text(e.walk, step);
  const std::string number = std::to_string(question.number);
  FigureInfo info = info_of(e, step);
  info.stem = info.metadata["file"] = file_of_question(e, step);
  info.title = viz::tr("Question {n}", {{"n", number}});
  info.caption = question.whole_prompt;
  info.imprint = viz::tr("{lesson}: question {n}", {{"lesson", viz::plain(e.lesson->title)}, {"n", number}});
  info.alt = viz::drawn_text(e.walk, viz::question_scene(e.walk, step), false);
  return info;
}

viz::Drawing draw_question(FigureMaker& maker, const Excerpt& e, int step) {
  Excerpt asked = e;  // with one more step at the end of its walk
  asked.steps = {static_cast<int>(e.walk.steps.size())};
  asked.walk.steps.push_back(viz::asking_step(e.walk, step));
  return maker.draw(asked, asked.steps.front());
}

}  // namespace isect::program
