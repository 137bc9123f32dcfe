#include "viz/window/saving.h"

#include <utility>

#include "viz/formats/files.h"
#include "viz/window/progress.h"
#include "viz/window/save_figure.h"
#include "viz/window/save_place.h"

namespace isect::viz {
namespace {

/// Calls write(folder, name), by what the save sheet says, and tells what it returns. Where it fails, the sheet opens
/// again and says why. Returns whether it was written.
template <class Write>
bool save_by_sheet(WindowSession& s, const Write& write) {
  SaveSheet& sheet = s.save_sheet;
  const std::string folder = whole_folder(sheet, s.settings, s.figures);
  sheet.failed.clear(), sheet.progress = false;
  try {
    s.toast.say("Saved " + write(folder, given_name(sheet, s.settings)));
    s.settings.save_folder = folder == whole_path(s.figures) ? std::string() : folder;
  } catch (const BadInput& wrong) {
    s.toast.complain(wrong.what());
  } catch (const FileError& failed) {
    sheet.failed = failed.what(), sheet.folder = folder;
    s.requests.sheet = Sheet::save;
    return false;
  }
  return true;
}

std::string save_as_preset(WindowSession& s, const std::string& folder, const std::string& name) {
  const std::string path = save_preset(s.player, folder, name);
  std::vector<std::string>& saved = s.settings.saved;
  std::erase(saved, path);  // a file of this name may have been there before
  saved.insert(saved.begin(), path);
  if (saved.size() > saved_kept) saved.pop_back();
  return path;
}

}  // namespace

void save_what_is_wanted(WindowSession& s, Renderer& renderer) {
  using Words = const std::string&;
  if (std::exchange(s.requests.save_figure, false))
    save_by_sheet(s, [&](Words folder, Words name) {
      return save_figure(s.player, s.settings, renderer, folder, name) + ", with its alt text";
    });
  if (std::exchange(s.requests.save_preset, false))
    save_by_sheet(s, [&](Words folder, Words name) { return save_as_preset(s, folder, name); });
  if (std::exchange(s.requests.save_progress, false))
    s.save_sheet.progress = !save_by_sheet(
        s, [&](Words folder, Words name) { return save_progress(s.player.lessons(), s.settings, folder, name); });
}

}  // namespace isect::viz
