#include "app/book/pictures.h"

#include <fmt/format.h>

#include "app/book/picture_size.h"
#include "app/figures/figure_maker.h"
#include "app/figures/ownership.h"
#include "viz/compose/paper.h"
#include "viz/walk/alt_text.h"
#include "viz/walk/question_scene.h"

namespace isect::program::book {

Pictures::Pictures(const Excerpt& e, viz::PagePictures& page) : e_(e), page_(page), bare_(e.walk) {
  for (viz::Step& step : bare_.steps) step.formula.clear(), step.verdict = {};
}

std::string Pictures::of(int step) {
  return figure(step, viz::drawn_text(e_.walk, e_.walk.steps[step].scene, true), false);
}

std::string Pictures::asked(int step) {
  viz::Scene scene = viz::question_scene(e_.walk, step);
  std::swap(bare_.steps[step].scene, scene);
  const std::string made = figure(step, viz::drawn_text(e_.walk, bare_.steps[step].scene, false), true);
  std::swap(bare_.steps[step].scene, scene);
  return made;
}

std::string Pictures::figure(int step, const std::string& alt, bool asked) {
  const viz::Step& shown = bare_.steps[step];
  const auto camera = [&](double aspect) { return camera_for(e_, shown, aspect); };
  const auto light =
      viz::readable_figure(bare_, step, viz::ThemeName::screen, picture_size(shown.scene), false, camera);
  if (!light)
    throw viz::BadInput(fmt::format("book: the labels of {}, {} can't be set apart", folder_of(e_), shown.slug));
  const viz::PageLayout layout = viz::paper_layout(bare_, step, viz::ThemeName::dark, light->size, false);
  const viz::Figure dark = viz::figure(shown, camera(layout.width / layout.picture_height()), layout);
  const std::string svg = page_.svg(light->figure.drawing, dark.drawing, alt);

  const std::string kind = !asked ? "" : page_.repeated() ? " class=\"asked again\"" : " class=\"asked\"";
  const viz::Drawing& drawn = light->figure.drawing;
  return fmt::format("<figure{}{}>{}</figure>\n", kind, attributes_of_picture(drawn.width), svg);
}

}  // namespace isect::program::book
