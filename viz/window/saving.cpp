#include "viz/window/saving.h"

#include <utility>

#include "viz/formats/files.h"
#include "viz/window/progress.h"
#include "viz/window/save_figure.h"
#include "viz/window/save_place.h"

namespace isect::viz {
namespace {

/// Calls write(folder, name), by what the save sheet says, and tells what it returns. Where it fails, the sheet opens
/// again for `what`, and says why.
template <class Write>
void save_by_sheet(WindowSession& s, SaveSheet::What what, const Write& write) {
  SaveSheet& sheet = s.save_sheet;
  const std::string folder = whole_folder(sheet, s.settings, s.figures);
  sheet.failed.clear(), sheet.what = SaveSheet::What::figure;
  try {
    s.toast.say("Saved " + write(folder, given_name(sheet, s.settings)));
    s.settings.save_folder = folder == whole_path(s.figures) ? std::string() : folder;
  } catch (const BadInput& wrong) {
    s.toast.complain(wrong.what());
  } catch (const FileError& failed) {
    sheet.failed = failed.what(), sheet.folder = folder, sheet.what = what;
    s.requests.sheet = Sheet::save;
  }
}

std::string save_as_preset(WindowSession& s, const std::string& folder, const std::string& name) {
  const std::string path = save_preset(s.player, folder, name);
  std::vector<std::string>& saved = s.settings.saved;
  std::erase(saved, path);  // a file of this name may have been there before
  saved.insert(saved.begin(), path);
  if (saved.size() > saved_kept) saved.pop_back();
  return path;
}

/// Writes a scene that has no file into a new one, which is the scene's from then on.
std::string save_as_scene(WindowSession& s, const std::string& folder, const std::string& name) {
  const Lesson& lesson = s.player.lesson();
  const std::string text = s.scene_file.fresh.text(lesson, s.player.parameters(), folder);
  const std::string path = free_path(folder + "/" + (name.empty() ? usual_scene_name : name), "json", text);
  write_file(path, text);
  s.scene_file.fresh.take(lesson, s.player.parameters(), path);
  s.scene_file.fresh = {}, s.scene_file.written = &lesson;
  s.player.reread();
  return path;
}

}  // namespace

void save_what_is_wanted(WindowSession& s, Renderer& renderer) {
  using Words = const std::string&;
  using What = SaveSheet::What;
  if (std::exchange(s.requests.save_figure, false))
    save_by_sheet(s, What::figure, [&](Words folder, Words name) {
      return save_figure(s.player, s.settings, renderer, folder, name) + ", with its alt text";
    });
  if (std::exchange(s.requests.save_preset, false))
    save_by_sheet(s, What::figure, [&](Words folder, Words name) { return save_as_preset(s, folder, name); });
  if (std::exchange(s.requests.save_progress, false))
    save_by_sheet(s, What::progress, [&](Words folder, Words name) {
      return save_progress(s.player.lessons(), s.settings, folder, name);
    });
  if (std::exchange(s.requests.save_scene, false))
    save_by_sheet(s, What::scene, [&](Words folder, Words name) { return save_as_scene(s, folder, name); });
}

}  // namespace isect::viz
