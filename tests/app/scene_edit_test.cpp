// Edits of a scene's text: what was written stays, and what the reader would refuse is refused in its words.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "app/scene/edit.h"
#include "app/scene/editor.h"
#include "app/scene/known.h"
#include "app/scene/lesson.h"
#include "app/scene/questions.h"
#include "app/scene/types.h"
#include "bench/random.h"
#include "lessons/lessons.h"
#include "tests/app/many_balls.h"
#include "tests/catch.h"
#include "viz/player/reader_state.h"

namespace scene_edit_test {
namespace scene = isect::program::scene;
namespace viz = isect::viz;
using isect::test::Contains;
using scene::Json;
using viz::Vec3;

namespace {

const std::string two = R"({"title": "Two", // mine
  "objects": [
    {"circle": "A", "center": [0, 0.10], "radius": 1},  /* first */
    {"circle": "B", "center": [3, 0], "radius": 1} // the other
  ],
  "ask": [["A", "B"]]
}
)";

/// The text with one part replaced.
std::string with(std::string text, const std::string& old, const std::string& now) {
  REQUIRE(text.find(old) != text.npos);
  return text.replace(text.find(old), old.size(), now);
}

std::vector<std::string> names(const scene::File& file) {
  std::vector<std::string> all;
  for (const scene::Object& o : file.objects) all.push_back(o.name);
  return all;
}
using Names = std::vector<std::string>;

scene::File read(const std::string& text) { return scene::read_scene(text, ""); }

}  // namespace

TEST_CASE("an object is added on a line of its own, and all else stays as it was written", "[scene]") {
  const std::string now = scene::with_object(two, scene::Type::sphere, "C", {Vec3(1, 2, 0), 1, true});
  CHECK(now == with(two, "1} // the other\n",
                    "1}, // the other\n    {\"circle\": \"C\", \"center\": [1, 2], \"radius\": 1}\n"));
  CHECK(names(read(now)) == Names{"A", "B", "C"});
  const std::string line = R"({"objects": [{"point": "P", "at": [0, 0]}]})";
  CHECK(scene::with_object(line, scene::Type::point, "Q", {Vec3(1, 0, 0), 1, true}) ==
        R"({"objects": [{"point": "P", "at": [0, 0]}, {"point": "Q", "at": [1, 0]}]})");
  const std::string hanging =
      "{\"objects\": [{\"point\": \"P\", \"at\": [0, 0]},\n"
      "             {\"point\": \"Q\", \"at\": [2, 0]}]}";
  CHECK(scene::with_object(hanging, scene::Type::point, "R", {Vec3(1, 0, 0), 1, true}) ==
        with(hanging, "[2, 0]}]", "[2, 0]},\n             {\"point\": \"R\", \"at\": [1, 0]}]"));
}

TEST_CASE("a removed object takes its questions along, and no comment", "[scene]") {
  const std::string first = scene::without_object(two, "A"), last = scene::without_object(two, "B");
  CHECK(names(read(first)) == Names{"B"});
  CHECK(names(read(last)) == Names{"A"});
  for (const std::string& now : {first, last}) {
    CHECK(read(now).asked.empty());
    for (const char* comment : {"// mine", "/* first */", "// the other"}) CHECK_THAT(now, Contains(comment));
  }
  CHECK_THAT(first, Contains("    {\"circle\": \"B\", \"center\": [3, 0], \"radius\": 1} // the other\n"));
  CHECK_THAT(last, Contains("    {\"circle\": \"A\", \"center\": [0, 0.10], \"radius\": 1}  /* first */\n"));
  CHECK_THROWS_WITH(read(scene::without_object(first, "B")), Contains("line 2: objects: a list of 1 to 1000"));
  CHECK_THROWS_WITH(scene::without_object(two, "C"), Contains("no object is called \"C\""));

  const std::string many = R"({"objects": [{"box": "A", "lo": [0, 0], "hi": [1, 1]},
    {"box": "B", "lo": [2, 0], "hi": [3, 1]}, {"box": "C", "lo": [4, 0], "hi": [5, 1]},
    {"ray": "r", "origin": [-1, 0], "dir": [1, 0]}],
  "ask": [["r", "B"], {"hierarchy": ["A", "B", "C"]}, {"first hit": "r"}, {"clip": "r", "to": "B"}, ["r", "A"],
          {"walk": ["A", "B", "C"], "lesson": "collision"}, {"walk": ["A", "C"], "lesson": "aabb-aabb"}]})";
  const std::string without = scene::without_object(many, "B");
  CHECK(Json::parse(without)["ask"] == Json::parse(R"([{"hierarchy": ["A", "C"]}, {"first hit": "r"}, ["r", "A"],
    {"walk": ["A", "C"], "lesson": "collision"}, {"walk": ["A", "C"], "lesson": "aabb-aabb"}])"));
}

TEST_CASE("an object is renamed wherever its name stands", "[scene]") {
  CHECK(scene::with_name(two, "A", "ball") ==
        with(with(two, "\"circle\": \"A\"", "\"circle\": \"ball\""), "[[\"A\"", "[[\"ball\""));
  CHECK_THROWS_WITH(read(scene::with_name(two, "A", "B")),
                    Contains("line 4: objects[1]") && Contains("\"B\" is the name of another object"));
  CHECK_THROWS_WITH(read(scene::with_name(two, "A", "a b")), Contains("a name of 1 to 16 letters and digits"));
  const std::string all = R"({"objects": [{"box": "all", "lo": [0, 0], "hi": [1, 1]},
    {"box": "B", "lo": [2, 0], "hi": [3, 1]}], "ask": [{"hierarchy": "all"}, ["all", "B"]]})";
  CHECK_THAT(scene::with_name(all, "all", "A"), Contains(R"({"hierarchy": "all"}, ["A", "B"])"));
}

TEST_CASE("an object is hidden and shown again, and the text is as before", "[scene]") {
  const std::string hidden = scene::with_hidden(two, "A", true);
  CHECK(hidden == with(two, "\"A\",", "\"A\", \"hidden\": true,"));
  CHECK(scene::with_hidden(hidden, "A", false) == two);
  CHECK(read(hidden).objects[0].hidden);
  CHECK(scene::answers(read(hidden)) == scene::answers(read(two)));
  const viz::Lesson before = scene::lesson_of(two, ""), lesson = scene::lesson_of(hidden, "");
  const viz::Parameters& now = lesson.presets[0].parameters;
  for (const std::size_t step : {0, 1}) {
    const viz::Scene with_a = before.steps(now).steps[step].scene, without = lesson.steps(now).steps[step].scene;
    CHECK(without.items.size() < with_a.items.size());
    for (const viz::Handle& h : without.handles) CHECK(h.parameter.starts_with("B."));
  }
  CHECK_THROWS_WITH(read(with(two, "\"A\",", "\"A\", \"hidden\": 1,")),
                    Contains("line 3: objects[0].hidden: true or false is expected"));
}

TEST_CASE("a question is added to the list of questions, which begins below the objects", "[scene]") {
  const Json walk = {{"walk", Json{"A", "B"}}};
  CHECK(scene::with_question(two, walk) ==
        with(two, "[[\"A\", \"B\"]]", "[[\"A\", \"B\"], {\"walk\": [\"A\", \"B\"]}]"));
  const std::string none = with(two, "  ],\n  \"ask\": [[\"A\", \"B\"]]\n", "  ] // all\n");
  CHECK(scene::with_question(none, Json{"A", "B"}) ==
        with(none, "] // all\n", "], // all\n  \"ask\": [[\"A\", \"B\"]]\n"));
  CHECK_THROWS_WITH(scene::with_question(two, Json{"A", "B"}), Contains("line 6: ask[0]: this is asked already"));
  const std::string every = with(two, "[[\"A\", \"B\"]]", "\"all pairs\"");
  CHECK_THROWS_WITH(scene::with_question(every, Json{"A", "B"}), Contains("all pairs are asked already"));
}

TEST_CASE("a question is removed alone, whichever it is, and no comment goes with it", "[scene]") {
  const std::string capsules = R"({"objects": [{"capsule": "A", "p": [0, 0], "q": [2, 0], "r": 1}, // mine
    {"capsule": "B", "p": [0, 1], "q": [2, 2], "r": 1}], "ask": [["A", "B"]]})";
  const std::string asks =
      with(capsules, "[[\"A\", \"B\"]]",
           "[ // of both\n    [\"A\", \"B\"], /* first */\n    {\"hierarchy\": [\"A\", \"B\"]} // then\n"
           "    , {\"walk\": [\"A\", \"B\"]}\n  ]");
  REQUIRE(read(asks).asked.size() == 3);
  const Json entries = Json::parse(asks, nullptr, true, true)["ask"];
  REQUIRE(entries.size() == 3);
  for (const Json& entry : entries) {
    INFO(entry.dump());
    const std::string now = scene::without_question(asks, entry);
    const Json left = Json::parse(now, nullptr, true, true);
    CHECK(left["ask"].size() == 2);
    CHECK(std::ranges::find(left["ask"], entry) == left["ask"].end());
    CHECK(left["objects"] == Json::parse(asks, nullptr, true, true)["objects"]);
    CHECK(names(read(now)) == Names{"A", "B"});
    for (const char* comment : {"// of both", "/* first */", "// then", "// mine"}) CHECK_THAT(now, Contains(comment));
    CHECK_THROWS_WITH(scene::without_question(now, entry), Contains("ask: this is not asked"));
  }
  CHECK(scene::without_question(two, Json{"A", "B"}) == with(two, "[[\"A\", \"B\"]]", "[]"));
  CHECK_THROWS_WITH(scene::without_question(two, Json{"B", "A"}), Contains("this is not asked"));
  const std::string every = with(two, "[[\"A\", \"B\"]]", "\"all pairs\"");
  CHECK(scene::without_question(every, "all pairs") == with(two, "[[\"A\", \"B\"]]", "[]"));
  CHECK(read(scene::without_question(every, "all pairs")).asked.empty());
  const std::string none = with(two, ",\n  \"ask\": [[\"A\", \"B\"]]", "");
  CHECK_THROWS_WITH(scene::without_question(none, Json{"A", "B"}), Contains("this is not asked"));
}

TEST_CASE("a polygon gets a corner behind another one and loses one, in the text as it is laid out", "[scene]") {
  const std::string field =
      "{\"objects\": [\n  {\"polygon\": \"P\", \"points\": [[0, 0], [4, 0], [4, 4.50]]}, // mine\n"
      "  {\"polygon\": \"H\", \"at\": [10, 1], \"rings\": [\n    [[0, 0], [9, 0], [9, 9], [0, 9]],\n    [\n"
      "      [1, 1], // a hole\n      [2, 1],\n      [1, 2]\n    ]\n  ]},\n"
      "  {\"triangle\": \"T\", \"points\": [[0, 0], [1, 0], [0, 1]]}]}";
  const std::string more = scene::with_corner(field, "P", 1, {2, -1, 0});
  CHECK(more == with(field, "[[0, 0], [4, 0]", "[[0, 0], [2, -1], [4, 0]"));
  CHECK(scene::without_corner(more, "P", 2) == field);
  CHECK(scene::with_corner(field, "P", 3, {0.25, 3, 0}) == with(field, "4.50]]", "4.50], [0.25, 3]]"));
  CHECK(scene::with_corner(field, "H", 5, {12, 2, 0}) ==
        with(field, "[1, 1], // a hole\n", "[1, 1], // a hole\n      [2, 1],\n"));  // where "at" has not moved it
  CHECK(scene::without_corner(field, "H", 2) == with(field, "[9, 0], ", ""));
  for (const auto& [name, corner] : {std::pair("P", 1), {"P", 2}, {"P", 3}, {"H", 6}})
    CHECK_THROWS_WITH(read(scene::without_corner(field, name, corner)), Contains("a list of 3 to 10000 points"));
  CHECK(read(scene::without_corner(scene::with_corner(field, "H", 7, {13, 3, 0}), "H", 5)).objects[1].rings ==
        std::vector{4, 3});

  CHECK_THROWS_WITH(scene::with_corner(field, "P", 4, Vec3::Zero()), Contains("objects[0]: P has no corner 4"));
  CHECK_THROWS_WITH(scene::without_corner(field, "H", 0), Contains("H has no corner 0"));
  CHECK_THROWS_WITH(scene::with_corner(field, "T", 1, Vec3::Zero()), Contains("T is no polygon"));
  CHECK_THROWS_WITH(scene::with_corner(field, "Q", 1, Vec3::Zero()), Contains("no object is called \"Q\""));
  const std::string file = R"({"objects": [{"polygon": "P", "file": "field.wkt"}]})";
  CHECK_THROWS_WITH(scene::with_corner(file, "P", 1, Vec3::Zero()), Contains("stand in a file of their own"));
  std::string round = field;
  for (int i = 3; i < 40; ++i) round = scene::with_corner(round, "P", 1, {2 + 0.01 * i, -1, 0});
  CHECK(read(round).objects[0].fields.size() == 40);
  CHECK_THROWS_WITH(scene::with_corner(round, "P", 1, {2, -1, 0}), Contains("P has 40 corners, the most"));

  const std::string high = R"({"objects": [{"polygon": "P", "points": [[0, 0, 1], [4, 0, 1], [4, 4, 1]]}]})";
  CHECK(scene::with_corner(high, "P", 2, {4, 2, 1}) == with(high, "[4, 0, 1]", "[4, 0, 1], [4, 2, 1]"));
}

TEST_CASE("a new object of each type is read, drawn and answered, wherever it begins", "[scene]") {
  int decided = 0;
  for (const bool flat : {true, false})
    for (const scene::TypeSpec& type : scene::types()) {
      if (flat && type.in_plane.empty()) continue;
      for (const auto& [middle, size] :
           {std::pair{Vec3(0, 0, 0), 1.0}, {Vec3(0.3, 123.456, -7e5), 0.013}, {Vec3(-4, 2.5, 1), 900.0}}) {
        INFO(type.name << (flat ? " in the plane" : " in space") << ", size " << size);
        const std::string ball = flat ? R"({"circle": "A", "center": [0, 0], "radius": 2})"
                                      : R"({"sphere": "A", "center": [0, 0, 0], "radius": 2})";
        const std::string base = "{\"objects\": [\n  " + ball + " // mine\n]}";
        const std::string name = scene::free_name(base);
        CHECK(name == "B");
        std::string text = scene::with_object(base, type.type, name, {middle, size, flat});
        text = scene::with_question(text, Json{"A", name});
        CHECK_THAT(text, Contains("// mine"));
        const scene::File file = read(text);
        CHECK((file.flat == flat && file.objects[1].type == type.type));
        const Json answer = scene::answers(file)[0];
        if (!answer["result"].contains("not decided")) ++decided;
        CHECK(scene::is_decided(scene::Type::sphere, type.type, flat) == !answer["result"].contains("not decided"));
        const viz::Lesson lesson = scene::lesson_of(text, "");
        CHECK_NOTHROW(viz::validate(lesson, lesson.presets[0].parameters));
        for (const Vec3& p : scene::NamedValues{file.parameters, flat}.extent(file.objects[1]))
          CHECK((p - (flat ? Vec3(middle.x(), middle.y(), 0) : middle)).norm() <= 6 * size);
      }
    }
  CHECK(decided > 60);
}

TEST_CASE("whatever edits follow each other, the scene can be read, and no comment is lost", "[scene]") {
  const std::string base =
      "// one\n{ /* two */ \"title\": \"t\", // three\n  \"objects\": [ // four\n"
      "    {\"circle\": \"A\", \"center\": [0, 0], \"radius\": 1}, // five\n"
      "    /* six */ {\"box\": \"B\", \"lo\": [0, 0], \"hi\": [1, 1]} // seven\n"
      "    // eight\n  ], // nine\n  \"ask\": [[\"A\", \"B\"] /* ten */] } // eleven\n";
  isect::bench::Random random(49);
  std::string text = base;
  int done = 0;
  for (int i = 0; i < 600; ++i) {
    const scene::File before = read(text);
    const auto any = [&] {
      return before.objects[static_cast<std::size_t>(random.below(static_cast<int>(before.objects.size())))].name;
    };
    const std::string was = text, a = any(), b = any(), fresh = scene::free_name(text);
    const auto type = static_cast<scene::Type>(random.below(static_cast<int>(scene::types().size())));
    try {
      const int kind = random.below(7);
      if (kind == 0 && !scene::spec(type).in_plane.empty() && before.objects.size() < 12)
        text = scene::with_object(text, type, fresh, {Vec3(i, -i, 0), 1.0 + i % 7, true});
      if (kind == 1) text = scene::without_object(text, a);
      if (kind == 2) text = scene::with_name(text, a, fresh);
      if (kind == 3) text = scene::with_hidden(text, a, i % 2 == 0);
      if (kind == 4) text = scene::with_question(text, Json{a, b});
      if (kind == 5 && !before.asked.empty()) {
        const Json ask = Json::parse(text, nullptr, true, true)["ask"];
        text = scene::without_question(text, ask[static_cast<std::size_t>(random.below(static_cast<int>(ask.size())))]);
      }
      if (kind == 6) {
        const int corner = 1 + random.below(5);
        text = i % 3 == 0 ? scene::without_corner(text, a, corner)
                          : scene::with_corner(text, a, corner, Vec3(0.5 * i, i, 0));
      }
      static_cast<void>(read(text));
      ++done;
    } catch (const viz::BadInput&) {
      text = was;  // the last object, a question that is asked already, an object asked about itself
    }
    INFO(text);
    CHECK_NOTHROW(read(text));
    for (const char* comment : {"// one\n", "/* two */", "// three\n", "// four\n", "// five\n", "/* six */",
                                "// seven\n", "// eight\n", "// nine\n", "/* ten */", "// eleven\n"})
      CHECK(text.find(comment) != text.npos);
  }
  CHECK(done > 300);
}

TEST_CASE("the editor offers what the tables know, and nothing that is asked already", "[scene]") {
  const viz::SceneEditor editor = scene::editor();
  const viz::Lesson& lesson = scene::kept_lesson_of(two, "");
  REQUIRE(editor.objects(lesson).size() == 2);
  CHECK(editor.objects(lesson)[0].type == "circle");
  CHECK(std::ranges::count(editor.types(lesson), std::string("box"), &viz::SceneType::id) == 1);
  CHECK(std::ranges::count(editor.types(lesson), std::string("cone"), &viz::SceneType::id) == 0);
  CHECK(editor.free_name(lesson) == "C");
  const auto offered = [&](const std::string& scene) {
    std::string all;
    for (const viz::SceneQuestion& q : editor.questions(scene::kept_lesson_of(scene, ""), {"A", "B"}))
      all += q.words + "\n";
    return all;
  };
  CHECK_THAT(offered(two), !Contains("How A"));
  CHECK_THAT(offered(two.substr(0, two.find(",\n  \"ask\"")) + "}"), Contains("How A and B lie"));

  const std::string text = R"({"objects": [{"ray": "r", "origin": [-1, 0, 0], "dir": [1, 0, 0]},
    {"box": "A", "lo": [0, -1, -1], "hi": [1, 1, 1]}, {"sphere": "S", "center": [4, 0, 0], "radius": 1}]})";
  const viz::Lesson& other = scene::kept_lesson_of(text, "");
  const auto words = [&](const std::vector<std::string>& about) {
    std::string all;
    for (const viz::SceneQuestion& q : editor.questions(other, about)) all += q.words + "\n";
    return all;
  };
  CHECK_THAT(words({"r", "A"}), Contains("How r and A lie") && Contains("The part of r in A"));
  CHECK_THAT(words({"r"}), Contains("What r meets first"));
  CHECK_THAT(words({"S", "r"}), Contains("Step by step"));
  for (const std::vector<std::string>& about : {Names{"r", "A"}, {"S", "r"}, {"r"}, {"A"}, {"A", "S"}})
    for (const viz::SceneQuestion& q : editor.questions(other, about)) {
      INFO(q.id);
      const viz::Lesson& asked =
          editor.edited(other, other.presets[0].parameters, {.kind = viz::SceneEdit::Kind::ask, .what = q.id});
      CHECK(asked.steps(asked.presets[0].parameters).steps.size() > 1);
    }
  const viz::Lesson own = scene::lesson_of(text, "");
  CHECK(editor.objects(own).empty());  // nobody keeps it
}

TEST_CASE("the editor tells what is asked about objects in words, and removes any of it", "[scene]") {
  const viz::SceneEditor editor = scene::editor();
  const std::string text = R"({"objects": [{"ray": "r", "origin": [-4, 0], "dir": [1, 0]},
    {"box": "A", "lo": [0, -1], "hi": [1, 1]}, {"box": "B", "lo": [3, -1], "hi": [4, 1]},
    {"polygon": "P", "points": [[0, 3], [2, 3], [1, 5]]}, {"point": "q", "at": [1, 4]}],
  "ask": [["r", "A"], {"first hit": "r"}, {"clip": "r", "to": "A"}, {"fit": "P"}, {"fit": "P", "volume": "hull"},
          {"hierarchy": ["A", "B"]}, {"hierarchy": "all"}, {"walk": ["q", "P"]},
          {"walk": ["q", "P"], "lesson": "convex-polygon"}, {"walk": "all", "lesson": "collision", "method": "sweep"}]})";
  const viz::Lesson& lesson = scene::kept_lesson_of(text, "");
  const auto told = [&](const Names& about) {
    std::string all;
    for (const viz::SceneQuestion& q : editor.asked(lesson, about)) all += q.words + "\n";
    return all;
  };
  CHECK(told({}).empty());
  CHECK(told({"r", "A"}) == "How r and A lie\nThe part of r in A\nA hierarchy of all objects\nStep by step: " +
                                viz::lesson_named(isect::lessons::all_lessons(), "collision").title + " (all)\n");
  CHECK_THAT(told({"r"}), Contains("What r meets first\n"));
  CHECK_THAT(told({"P"}), Contains("Volumes around P\n") && Contains("The hull around P\n") && Contains("(q, P)\n"));
  CHECK_THAT(told({"A", "B"}), Contains("A hierarchy of A, B\n"));
  int removed = 0;
  for (const char* name : {"r", "A", "B", "P", "q"})
    for (const viz::SceneQuestion& q : editor.asked(lesson, {name})) {
      INFO(q.id);
      const viz::Lesson& now =
          editor.edited(lesson, lesson.presets[0].parameters, {.kind = viz::SceneEdit::Kind::unask, .what = q.id});
      const Json ask = Json::parse(now.made_from)["ask"];
      CHECK((ask.size() == 9 && std::ranges::find(ask, Json::parse(q.id)) == ask.end()));
      ++removed;
    }
  CHECK(removed > 10);
  const viz::Lesson& every = scene::kept_lesson_of(with(two, "[[\"A\", \"B\"]]", "\"all pairs\""), "");
  REQUIRE(editor.asked(every, {"A"}).size() == 1);
  CHECK(editor.asked(every, {"A"})[0].words == "How all pairs lie");
}

TEST_CASE("the sides of a polygon are those of the setting, and a corner more is drawn and answered", "[scene]") {
  const viz::SceneEditor editor = scene::editor();
  const viz::Lesson& lesson = scene::kept_lesson_of(
      R"({"objects": [{"polygon": "P", "at": [1, 0], "rings": [[[0, 0], [4, 0], [4, 4]], [[3, 1], [3.5, 1], [3.5, 2]]]},
                      {"polygon": "H", "hidden": true, "points": [[0, 0], [1, 0], [0, 1]]},
                      {"point": "q", "at": [2, -0.5]}], "ask": [["q", "P"]]})",
      "");
  viz::Parameters now = lesson.presets[0].parameters;
  now["P.2"] = Vec3(5, 0, 0);
  const std::vector<viz::SceneSide> sides = editor.sides(lesson, now);
  REQUIRE(sides.size() == 6);
  CHECK((sides[0].parameter() == "P.1" && sides[0].from == Vec3(1, 0, 0) && sides[0].to == Vec3(6, 0, 0)));
  CHECK((sides[2].from == Vec3(5, 4, 0) && sides[2].to == Vec3(1, 0, 0)));
  CHECK((sides[5].corner == 6 && sides[5].to == Vec3(4, 1, 0)));
  const viz::SceneEdit more = {
      .kind = viz::SceneEdit::Kind::add_corner, .what = "P", .middle = Vec3(2, -1, 0), .corner = 1};
  const viz::Lesson& edited = editor.edited(lesson, now, more);
  const viz::Parameters& then = edited.presets[0].parameters;
  CHECK((std::get<Vec3>(then.at("P.2")) == Vec3(1, -1, 0) && std::get<Vec3>(then.at("P.3")) == Vec3(5, 0, 0)));
  CHECK(lesson.steps(now).steps[1].verdict.kind == viz::Verdict::Kind::no);
  CHECK(edited.steps(then).steps[1].verdict.kind == viz::Verdict::Kind::yes);
  CHECK(edited.steps(then).steps[0].scene.handles.size() == lesson.steps(now).steps[0].scene.handles.size() + 1);
  const viz::SceneEdit fewer = {.kind = viz::SceneEdit::Kind::remove_corner, .what = "P", .corner = 2};
  const viz::Lesson& back = editor.edited(edited, then, fewer);
  CHECK(back.presets[0].parameters == now);
  CHECK(back.steps(now).steps[1].verdict.kind == viz::Verdict::Kind::no);
  CHECK_THROWS_WITH(editor.edited(back, now, fewer), Contains("a list of 3 to 10000 points"));
}

TEST_CASE("of 1,000 objects the one that moves is drawn anew, and no other", "[scene]") {
  const auto known = std::make_shared<scene::KnownScene>();
  const viz::Lesson lesson = scene::lesson_of(isect::test::many_balls(1000, R"([["b0", "b1"]])"), "", known);
  const auto made = [&] { return known->known.pictures.made(); };
  CHECK(made() == 1000 + 2);  // the two asked about have their own colours in their step
  CHECK_THAT(lesson.steps(lesson.presets[0].parameters).steps[0].caption, Contains("1000 objects: 1000 spheres"));
  viz::Parameters now = lesson.presets[0].parameters;
  for (int move = 1; move <= 5; ++move) {
    const int before = made();
    std::get<Vec3>(now.at("b555.center")).x() += 0.01;
    const viz::Walk walk = lesson.steps(now);
    CHECK(made() == before + 1);
    CHECK(std::ranges::any_of(walk.steps[0].scene.handles, [&](const viz::Handle& h) {
      return h.parameter == "b555.center" && h.at == std::get<Vec3>(now.at("b555.center"));
    }));
  }
}

}  // namespace scene_edit_test
