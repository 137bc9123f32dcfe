#include "app/checks/report_pictures.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/figures/digest.h"
#include "viz/formats/files.h"
#include "viz/formats/svg_path.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

/// Whether a file beside a page is a picture of a report: its name is the digest of its bytes.
bool is_report_picture(const fs::path& file) try {
  const fs::path ending = file.extension();
  return (ending == ".png" || ending == ".svg") && fs::is_regular_file(fs::symlink_status(file)) &&
         digest(viz::read_regular_file(file)) == file.stem();
} catch (const viz::FileError&) {
  return false;
}

fs::path folder_beside(const fs::path& page) { return page.parent_path() / (page.stem().string() + "-pictures"); }

/// Removes what an earlier report left there, and the folder if nothing else is in it.
void remove_others(const fs::path& folder, const HtmlReport& report) {
  std::error_code absent;
  std::vector<fs::path> old;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, absent))
    if (!report.pictures.contains(entry.path().filename()) && is_report_picture(entry.path()))
      old.push_back(entry.path());
  for (const fs::path& file : old) fs::remove(file, absent);
  if (!old.empty() && fs::is_empty(folder, absent)) fs::remove(folder, absent);
}

}  // namespace

ReportPictures::ReportPictures(const Report& r, const std::string& file, std::size_t most_inside) {
  std::size_t all = 0;
  for (const Failure& f : r.failures) all += f.accepted_file.size() + f.fresh_file.size() + f.difference_file.size();
  if (all > most_inside) beside_.folder = folder_beside(file).filename();
}

std::string ReportPictures::source_of(const std::string& baseline, const std::string& bytes) {
  if (bytes.empty()) return {};
  const bool svg = baseline.ends_with(".svg");
  if (beside_.folder.empty()) return svg ? viz::svg_address(bytes) : "data:image/png;base64," + viz::base64(bytes);
  const std::string name = digest(bytes) + (svg ? ".svg" : ".png");
  beside_.pictures.emplace(name, bytes);
  return beside_.folder + "/" + name;
}

HtmlReport ReportPictures::take() { return std::move(beside_); }

std::string size_attributes(const std::string& bytes) {
  if (!bytes.starts_with("\x89PNG\r\n\x1a\n") || bytes.size() < 24) return {};
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
  };
  return fmt::format(" width=\"{}\" height=\"{}\"", number(16), number(20));  // of the header, which comes first
}

void write_html(const HtmlReport& report, const std::string& file) {
  const fs::path folder = folder_beside(file);
  for (const auto& [name, bytes] : report.pictures) {
    const fs::path place = folder / name;
    if (!viz::is_there(place))
      viz::write_file(place, bytes);
    else if (!is_report_picture(place))
      throw viz::FileError(
          fmt::format("cannot write '{}': the file there is no picture of a report; move it away, or "
                      "give the report another name",
                      place.string()));
  }
  viz::write_file(file, report.page);
  remove_others(folder, report);
}

}  // namespace isect::program
