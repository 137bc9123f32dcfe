#include "app/book/scene_page.h"

#include <fmt/format.h>

#include "app/book/lesson_page.h"
#include "app/pages/html.h"
#include "app/scene/lesson.h"
#include "app/scene/written.h"
#include "viz/chart/case_map.h"
#include "viz/formats/svg_path.h"

namespace isect::program::book {

Page scene_page(viz::PageColours& colours) {
  viz::PagePictures pictures(colours);
  std::string walks, links;
  for (const ExampleScene& example : example_scenes()) {
    Excerpt e;
    e.lesson = &scene::kept_lesson_of(example.text, "");
    e.folder = example.name;
    e.parameters = e.lesson->presets.front().parameters;
    e.walk = viz::walk_with_map(*e.lesson, e.parameters);
    const viz::Preset as = {example.name, e.lesson->title, "", e.parameters};
    const std::string text = viz::xml_escaped(example.text);
    walks += walk_section(e, as, walks.empty(), pictures,
                          fmt::format("<details class=\"written\"><summary>The scene as text</summary>\n"
                                      "<pre>{}</pre></details>\n",
                                      text));
    links += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", as.id, html_text(as.title));
  }
  Page page = {
      scene_file, "A scene of your own", "Objects with your own numbers, and exact answers about them.", {}, {}, false,
      "scene",    live_scenes_file};
  page.body = fmt::format(
      "<div class=\"opening\">\n<h1>A scene of your own</h1>\n<p class=\"summary\">Objects with your own numbers, and "
      "exact answers about them. <span class=\"scene-state\" role=\"status\"></span></p>\n<div class=\"about\">\n"
      "<p>Begin with an example. A mesh (.stl, .obj, .ply, .off), points (.csv, .xyz) or polygons (.geojson, .wkt) of "
      "your own are dropped on the page, or opened below the picture; they stay on your machine.</p>\n"
      "<details><summary>How a scene is written</summary>\n<pre>{}</pre></details>\n</div>\n</div>\n{}"
      "<nav class=\"settings\" aria-label=\"Examples\">\n<ul>\n{}</ul>\n</nav>\n<div id=\"walks\" "
      "data-opens-at=\"1\">\n{}</div>\n",
      viz::xml_escaped(scene::how_written()), pictures.shared(), links, walks);
  return page;
}

}  // namespace isect::program::book
