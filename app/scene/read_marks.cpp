// The marks of a scene file.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/scene/answered.h"
#include "app/scene/colours.h"
#include "app/scene/marks.h"
#include "app/scene/markup.h"
#include "app/scene/read_objects.h"
#include "viz/text/rich_text.h"
#include "viz/text/spelling.h"

namespace isect::program::scene {

namespace {

struct MarkKind {
  const char* word;
  AuthorMark::Kind kind;
  std::size_t places;
};
constexpr MarkKind mark_kinds[] = {{"point", AuthorMark::Kind::point, 1},
                                   {"arrow", AuthorMark::Kind::arrow, 2},
                                   {"line", AuthorMark::Kind::line, 2},
                                   {"dimension", AuthorMark::Kind::dimension, 2},
                                   {"brace", AuthorMark::Kind::brace, 2},
                                   {"angle", AuthorMark::Kind::angle, 3},
                                   {"right angle", AuthorMark::Kind::right_angle, 3}};
constexpr std::size_t most_marks = 200;

class MarkReader {
 public:
  MarkReader(Source& source, File& file) : source_(source), file_(file) {}

  void read() {
    if (!source_.json().contains("marks")) return;
    const Json& all = source_.list(source_.json()["marks"], {"marks"}, 0, most_marks, "marks");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Path path = {"marks", std::to_string(i)};
      AuthorMark mark = read(all[i], path);
      require_drawable(mark, path);
      file_.marks.push_back(std::move(mark));
    }
  }

 private:
  AuthorMark read(const Json& json, const Path& path) {
    std::vector<std::string> words;
    for (const MarkKind& one : mark_kinds) words.emplace_back(one.word);
    const auto kind = std::ranges::find_if(mark_kinds, [&](const MarkKind& one) { return json.contains(one.word); });
    if (kind == std::end(mark_kinds)) {
      source_.only(json, path, words);  // names the nearest one
      source_.refuse(path, "one of these is expected: " + spelling::listed(words));
    }
    std::vector<std::string> allowed = {kind->word, "label", "color", "from step", "to step"};
    if (kind->kind == AuthorMark::Kind::point) allowed.insert(allowed.begin() + 1, {"at", "nth"});
    const bool beside = kind->kind == AuthorMark::Kind::dimension || kind->kind == AuthorMark::Kind::brace;
    if (beside) allowed.emplace_back("offset");
    source_.only(json, path, allowed);
    AuthorMark mark = {.kind = kind->kind};
    if (kind->kind == AuthorMark::Kind::point)
      point(json, path, mark);
    else
      places(json[kind->word], below(path, kind->word), kind->places, mark);
    if (json.contains("label")) mark.label = read_markup(source_, json["label"], below(path, "label"));
    if (json.contains("offset")) mark.offset = source_.number(json["offset"], below(path, "offset"));
    if (json.contains("color")) mark.role = role(json["color"], below(path, "color"));
    mark.steps = read_steps(source_, json, path);
    return mark;
  }

  void point(const Json& json, const Path& path, AuthorMark& mark) {
    const Path to = below(path, "point");
    mark.name = source_.text(json["point"], to);
    require_name(source_, mark.name, to);
    if (std::ranges::find(file_.objects, mark.name, &Object::name) != file_.objects.end() ||
        std::ranges::find(file_.marks, mark.name, &AuthorMark::name) != file_.marks.end())
      source_.refuse(to, fmt::format("\"{}\" is the name of another object or mark", mark.name));
    mark.spots.push_back(read_spot(source_, file_, source_.member(json, path, "at"), below(path, "at")));
    if (!json.contains("nth")) return;
    const Json& nth = json["nth"];
    constexpr int most = 1000;
    if (!nth.is_number_integer() || nth < 1 || nth > most)
      source_.refuse(below(path, "nth"), fmt::format("a whole number from 1 to {} is expected", most));
    if (mark.spots[0].kind != Spot::Kind::meeting)
      source_.refuse(below(path, "nth"), "it is for where two objects meet, such as \"r x S\"");
    mark.spots[0].nth = nth;
  }

  void places(const Json& json, const Path& path, std::size_t count, AuthorMark& mark) {
    source_.list(json, path, count, count, "places");
    for (std::size_t i = 0; i < count; ++i)
      mark.spots.push_back(read_spot(source_, file_, json[i], below(path, std::to_string(i))));
  }

  viz::Role role(const Json& json, const Path& path) const {
    const Chosen chosen = read_colour(source_, json, path);
    if (!chosen.role) source_.refuse(path, "a mark is drawn as first, second, text or muted");
    return *chosen.role;
  }

  /// Refuses what the core refuses, and a right angle that is none.
  void require_drawable(const AuthorMark& mark, const Path& path) const {
    const Context context = {file_, {file_.parameters, file_.flat}, {}};
    MarkPicture picture;
    try {
      picture = picture_of(context, mark, file_.camera);
    } catch (const viz::BadInput& e) {
      source_.refuse(path, e.what());
    }
    const bool there =
        std::ranges::all_of(mark.spots, [&](const Spot& s) { return find_spot(context, s).at.has_value(); });
    if (mark.kind == AuthorMark::Kind::right_angle && there && !picture.missing.empty())
      source_.refuse(path, viz::plain(picture.missing));
  }

  Source& source_;
  File& file_;
};

}  // namespace

void read_marks(Source& source, File& file) { MarkReader(source, file).read(); }

}  // namespace isect::program::scene
