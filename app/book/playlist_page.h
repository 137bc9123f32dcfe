#pragma once
// A playlist in the book: a page with its stops, whose links open the lessons' pages at the steps in question, and a
// script by which these pages lead from each step to the next (playlist_page.js). Stops that no lesson's page shows,
// which are scenes and settings made by hand, have pages of their own.

#include <string>
#include <vector>

#include "app/book/page_shell.h"
#include "app/shell/options.h"
#include "viz/formats/page_svg.h"
#include "viz/player/playlist.h"

namespace isect::program::book {

class PlaylistPages {
 public:
  /// Reads the file. Throws viz::BadInput and viz::FileError as read_playlist does.
  PlaylistPages(const Program&, const std::string& path);

  /// Returns what tells it from other playlists in addresses and in the names of its files: "ray-and-ball".
  const std::string& name() const { return name_; }
  /// Return its page, "hour-ray-and-ball.html", its script, and all files.
  std::string file() const { return "hour-" + name_ + ".html"; }
  std::string script_file() const { return "hour-" + name_ + ".js"; }
  std::vector<std::string> files() const;
  /// Returns a link to it, as an item of a list.
  std::string link() const;

  Page page() const;
  /// Returns the script: the title, and of each stop its name, its note and its places in order. A place is an address,
  /// such as "ray-sphere.html#miss/3/question" or "moving-bodies.html#fast/2?time=0.5".
  std::string script() const;
  /// Returns the pages of its own. Throws viz::BadInput if labels can't be kept apart.
  std::vector<Page> own_pages(viz::PageColours&) const;

 private:
  /// A stop, as its excerpt is shown.
  struct Shown {
    std::string page, setting;  ///< the file, and the id of the walk there
    std::string name, steps;    ///< as HTML: "Ray and sphere", "steps 3–6"
    std::string note = {};      ///< markup
    std::vector<std::string> places = {};
  };
  Shown shown(std::size_t i) const;
  Page own_page(std::size_t i, viz::PageColours&) const;

  std::string name_;
  viz::Playlist list_;
  std::vector<Excerpt> excerpts_;
  std::vector<Shown> stops_;
};

}  // namespace isect::program::book
