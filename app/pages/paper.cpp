#include "app/pages/paper.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/figures/ownership.h"
#include "app/playlist_file.h"
#include "app/preset_folder.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"
#include "viz/walk/step_text.h"

namespace isect::program {

namespace {

/// Returns what a stop is called, without its setting.
std::string name_of_stop(const viz::Lesson& lesson) {
  return lesson.made_from.empty() ? viz::short_title(lesson) : lesson.title;
}

/// Returns the stops of a playlist as parts.
Paper paper_of_playlist(const Program& program, const std::string& path) {
  const std::string name = std::filesystem::path(path).stem().string();
  require_utf8({path, name});
  const viz::Playlist list = read_playlist(program, path);
  Paper paper = {list.title.empty() ? viz::as_markup(name) : list.title, name, {}};
  int stop = 0;
  for (Excerpt& e : excerpts_of(list)) {
    const viz::Stop& said = list.stops[static_cast<std::size_t>(stop)];
    const std::string steps = viz::steps_in_words(said), called = name_of_stop(*e.lesson);
    ++stop;
    e.place = fmt::format("{}/{:02}-{}", name, stop, e.lesson->id);
    PaperPart part;
    part.e = std::move(e);
    part.stop = stop;
    part.head = viz::tr("{n} of {all}: {stop}",
                        {{"n", std::to_string(stop)}, {"all", std::to_string(list.stops.size())}, {"stop", called}});
    part.entry = steps.empty() ? called : fmt::format("{}, {}", called, steps);
    part.note = said.note;
    paper.parts.push_back(std::move(part));
  }
  return paper;
}

bool shows_card(const Excerpt& e) {
  return std::ranges::any_of(e.steps, [&](int step) { return e.walk.steps[step].slug == viz::closing_slug; });
}

/// Notes what stands in a part before.
void note_repeats(Paper& paper) {
  for (std::size_t i = 0; i < paper.parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const PaperPart& before = paper.parts[j];
      PaperPart& now = paper.parts[i];
      if (before.e.lesson != now.e.lesson) continue;
      now.new_lesson = false;
      if (shows_card(before.e)) now.new_card = false;
      if (now.code_of == 0 && !now.e.walk.pseudocode.empty() && before.e.walk.pseudocode == now.e.walk.pseudocode)
        now.code_of = before.stop;
    }
}

/// Leaves out steps without a question, and parts without any.
void keep_asking(Paper& paper) {
  for (PaperPart& part : paper.parts)
    std::erase_if(part.e.steps, [&](int step) { return !part.e.walk.steps[step].question; });
  std::erase_if(paper.parts, [](const PaperPart& part) { return part.e.steps.empty(); });
}

/// Throws viz::BadInput if nothing is left of what was asked for, which is `whose`.
void need_parts(const Paper& paper, const Program& program, const std::string& whose) {
  if (paper.parts.empty())
    throw viz::BadInput(fmt::format("step: no step of {} asks a question; `{} handout` prints the steps themselves",
                                    whose, program.name));
}

}  // namespace

Paper paper_of(const Program& program, const Selection& asked, PaperSteps which) {
  const std::string playlist = playlist_asked(asked);
  Paper paper;
  if (playlist.empty()) {
    PaperPart part;
    part.e = excerpt(program, asked);
    paper = {part.e.lesson->title, folder_of(part.e), {}};
    paper.parts.push_back(std::move(part));
  } else {
    paper = paper_of_playlist(program, playlist);
  }
  if (which == PaperSteps::asking) keep_asking(paper);
  need_parts(paper, program, playlist.empty() ? "\"" + viz::plain(paper.title) + "\"" : playlist);
  note_repeats(paper);
  return paper;
}

Paper paper_of_presets(const Program& program, Selection asked) {
  playlist_asked(asked);  // refused: its stops are settings of their own
  asked.preset.clear(), asked.presets = {"all"};
  Paper paper;
  for (Excerpt& e : excerpts(program, asked)) {
    paper.title = e.lesson->title, paper.folder = e.lesson->id;
    PaperPart part;
    part.e = std::move(e);
    paper.parts.push_back(std::move(part));
  }
  keep_asking(paper);
  need_parts(paper, program, "\"" + viz::plain(paper.title) + "\"");
  note_repeats(paper);
  return paper;
}

std::string caption_on_paper(const PaperPart& part, int step) {
  const viz::Step& s = part.e.walk.steps[static_cast<std::size_t>(step)];
  if (part.new_lesson) return s.caption;
  return s.slug == viz::opening_slug ? viz::tr("This is what is given.") : viz::own_caption(*part.e.lesson, s);
}

Stops list_of_stops(const Paper& paper) {
  Stops stops;
  for (const PaperPart& part : paper.parts) stops.all.push_back({part.stop, part.entry});
  return stops;
}

}  // namespace isect::program
