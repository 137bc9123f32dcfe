// `isect query` as a pipe: answers in order, a clear error for every bad line, and never a crash.

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <vector>

#include "bench/random.h"
#include "lessons/lessons.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "tests/settings.h"
#include "viz/walk/closing.h"

namespace query_test {
using isect::test::Contains;
using isect::test::Ran;
using isect::test::Shell;
using Json = nlohmann::json;

namespace {

const std::string orient = R"({"kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, 1]})";

struct Replies {
  int status;
  std::string err;
  std::vector<Json> lines;
};

Replies ask(const std::string& text) {
  const Shell shell;
  isect::test::write(shell.work() / "cases", text);
  const Ran ran = shell("isect query <cases");
  Replies replies = {ran.status, ran.err, {}};
  std::istringstream out(ran.out);
  for (std::string line; std::getline(out, line);) replies.lines.push_back(Json::parse(line));
  return replies;
}

/// The error of a case that must have one.
std::string error(const std::string& line) {
  const Replies r = ask(line + "\n");
  REQUIRE(r.lines.size() == 1);
  CHECK(r.status == 1);
  INFO(r.lines[0].dump());
  REQUIRE(r.lines[0].contains("error"));
  CHECK_FALSE(r.lines[0].contains("result"));
  const std::string what = r.lines[0]["error"], place = "line 1: ";  // by which an error without an id is known
  CHECK(what.starts_with(place) == r.lines[0]["id"].is_null());
  return what.starts_with(place) ? what.substr(place.size()) : what;
}

}  // namespace

TEST_CASE("cases are answered in order, whatever their id", "[query]") {
  const Replies r = ask(R"({"id": "first", "kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, 1]})"
                        "\n"
                        R"({"id": {"n": [1, null]}, "kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, -1]})"
                        "\r\n" +
                        orient);  // neither an id nor an end of line
  CHECK(r.status == 0);
  CHECK(r.err.empty());
  REQUIRE(r.lines.size() == 3);
  CHECK(r.lines[0] == Json::parse(R"({"id": "first", "result": {"sign": 1}})"));
  CHECK(r.lines[1] == Json::parse(R"({"id": {"n": [1, null]}, "result": {"sign": -1}})"));
  CHECK(r.lines[2] == Json::parse(R"({"id": null, "result": {"sign": 1}})"));
}

TEST_CASE("no case, no answer", "[query]") {
  const Replies r = ask("");
  CHECK(r.status == 0);
  CHECK(r.lines.empty());
}

TEST_CASE("a bad line is an error by itself, and the next line goes on", "[query]") {
  const Replies r =
      ask(std::string("rubbish\n").append(orient).append("\n{\"id\": 3}\n\n").append(orient).append("\n"));
  CHECK(r.status == 1);
  REQUIRE(r.lines.size() == 4);
  CHECK(r.lines[0]["id"].is_null());
  CHECK(r.lines[0]["error"] == "line 1: no JSON: character 1 is out of place");
  CHECK(r.lines[1]["result"]["sign"] == 1);
  CHECK(r.lines[2]["id"] == 3);
  CHECK(r.lines[2]["error"] == "field \"kind\" is missing");
  CHECK(r.lines[3]["result"]["sign"] == 1);
}

TEST_CASE("lines of blanks get no answer and are no error", "[query]") {
  const Replies r = ask("\n \t\r\n" + orient + "\r\n\r\n" + orient + "\n\n");
  CHECK(r.status == 0);
  CHECK(r.lines.size() == 2);
  CHECK_THAT(Shell()("isect query --help").out, Contains("Lines of blanks get no answer"));
}

TEST_CASE("a line that nests too deep is one error that names the field, and the next lines go on", "[query]") {
  const auto nested = [](int levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  const auto with = [&](const std::string& key, int levels) {
    return orient.substr(0, orient.size() - 1) + ", \"" + key + "\": " + nested(levels) + "}\n";
  };
  const Replies r = ask(with("id", 75'000) + with("expected", 150'000) + with("id", 64) + with("id", 63) +
                        with("note", 63) + nested(75'000) + "\n" + orient);
  CHECK(r.status == 1);
  REQUIRE(r.lines.size() == 7);
  for (const int i : {0, 2}) {
    CHECK(r.lines[i]["id"].is_null());
    CHECK_THAT(r.lines[i]["error"].get<std::string>(), Contains("field \"id\"") && Contains("64 levels"));
  }
  CHECK_THAT(r.lines[1]["error"].get<std::string>(), Contains("field \"expected\"") && Contains("64 levels"));
  CHECK(r.lines[3]["id"] == Json::parse(nested(63)));
  CHECK(r.lines[4]["result"]["sign"] == 1);
  CHECK_THAT(r.lines[5]["error"].get<std::string>(), Contains("64 levels"));
  CHECK(r.lines[6]["result"]["sign"] == 1);
}

TEST_CASE("a wide line that is wrong over and over is told the first of it, and soon", "[query]") {
  const auto often = [](const std::string& part) {
    std::string all;
    for (int i = 0; i < 150'000; ++i) all += (i > 0 ? "," : "") + part;
    return all;
  };
  std::string keys;
  for (int i = 0; i < 150'000; ++i) keys += "\"k" + std::to_string(i) + "\":0,";
  const Replies r = ask("{" + keys + "\"deep\":" + std::string(63, '[') + often("[]") + std::string(63, ']') + "}\n" +
                        "[" + often(R"({"y":1,"y":2})") + "]\n");
  REQUIRE(r.lines.size() == 2);
  CHECK_THAT(r.lines[0]["error"].get<std::string>(), Contains("field \"deep\"") && Contains("64 levels"));
  CHECK(r.lines[1]["error"] == "line 2: field \"[0].y\": it is given twice");
}

TEST_CASE("an id comes back as it was sent, to the letter", "[query]") {
  for (const std::string id : {"123456789012345678901234567890", "-0", "0.1000000000000000055511151231257827", "1e-400",
                               "1E+5", R"("\u0041\n\"\\")", R"({"b" : [1,-0, "x"], "a":null})", "true", "\"\u00e9\""}) {
    const Shell shell;
    isect::test::write(shell.work() / "cases", "{\"id\" : " + id + " ," + orient.substr(1) + "\n{\"id\":" + id + "}\n");
    const std::string out = shell("isect query <cases").out;
    CHECK(out == "{\"id\":" + id + ",\"result\":{\"sign\":1}}\n{\"id\":" + id +
                     ",\"error\":\"field \\\"kind\\\" is missing\"}\n");
  }
}

TEST_CASE("unknown fields, fields given twice and bytes behind the end are errors", "[query]") {
  const std::string open = orient.substr(0, orient.size() - 1);
  CHECK_THAT(error(open + ", \"scaler\": \"f32\"}"),
             Contains("field \"scaler\": it is not known; did you mean \"scalar\"?"));
  CHECK_THAT(
      error(R"({"kind": "ray_sphere", "origin": [0, 0], "dir": [1, 0], "center": [2, 0], "radius": 1, "tMax": 1})"),
      Contains("field \"tMax\"") && Contains("did you mean \"tmax\"?"));
  CHECK_THAT(error(R"({"Kind": "orient2d"})"), Contains("field \"Kind\"") && Contains("did you mean \"kind\"?"));
  CHECK_THAT(error(R"({"kind": "ray_spere"})"), Contains("did you mean \"ray_sphere\"?"));
  CHECK_THAT(
      error(R"({"kind": "kdop_kdop", "normals": [[1, 0]], "a": {"lo": [0], "hi": [1]}, "b": {"low": [0], "hi": [1]}})"),
      Contains("field \"b.low\"") && Contains("\"lo\""));
  CHECK_THAT(error(R"({"kind": "obb_obb", "a": {"x": 1}, "b": {}})"), Contains("field \"a.x\""));
  CHECK(error(open + ", \"a\": [5, 5]}") == "field \"a\": it is given twice");
  CHECK(error(open + ", \"note\": {\"x\": [{\"y\": 1, \"y\": 2}]}}") == "field \"note.x[0].y\": it is given twice");
  CHECK(error(orient + "x") == "no JSON: character " + std::to_string(orient.size() + 1) + " is out of place");
  CHECK(error(orient + std::string(1, '\0') + "{}") ==
        "no JSON: character " + std::to_string(orient.size() + 1) + " is a NUL byte");
  CHECK_THAT(error(R"({"kind": "bounding_volume_fit", "points": [[0, 0]], "volume": "aabb", "normals": [[1, 0]]})"),
             Contains("field \"normals\""));
  CHECK(error("{\"\": 1}").substr(0, 8) == "field \"\"");
  const std::string noted = R"(, "name": 1, "note": 1, "comment": 1, "source": 1, "license": 1, "conventions": 1, )"
                            R"("tags": [1], "expected": {"sign": 1}, "peer": {}, "peer_differs": true})";
  CHECK(ask(open + noted).lines.at(0)["result"]["sign"] == 1);
}

TEST_CASE("a decimal is rounded once, to the scalar asked for", "[query]") {
  // just above the middle of two floats, and nearest to the middle as a double
  const std::string pair = R"("a": [1.00000005960464477539062500001, 0], "b": [1.00000011920928955078125, 0]})";
  const Replies r =
      ask("{\"kind\": \"point_point\", \"scalar\": \"f32\", " + pair + "\n{\"kind\": \"point_point\", " + pair +
          R"(
{"kind": "point_point", "a": [9007199254740993, 0], "b": [9007199254740992, 0]}
{"kind": "point_point", "scalar": "f32", "a": [1e-60, -1e-46], "b": [0, 0]})");
  CHECK(r.status == 0);
  REQUIRE(r.lines.size() == 4);
  CHECK(r.lines[0]["result"]["equal"] == true);
  CHECK(r.lines[1]["result"]["equal"] == false);
  CHECK(r.lines[2]["result"]["equal"] == true);
  CHECK(r.lines[3]["result"]["equal"] == true);
}

TEST_CASE("the limits of slabs and of k-DOPs answer by name, and what is just within them is done", "[query]") {
  // from a comb between two heights each tooth stands in every slab
  const auto comb = [](int teeth) {
    Json ring = {{2 * teeth, -1}, {-1, -1}};
    for (int i = 0; i < teeth; ++i) ring.push_back({2 * i, i}), ring.push_back({2 * i + 1, teeth + i});
    return Json{{"kind", "pip"}, {"variant", "slabs"}, {"rings", {ring}}, {"point", {0.5, 0.5}}};
  };
  CHECK(ask(comb(5'000).dump()).lines.at(0).contains("result"));
  CHECK_THAT(error(comb(9'000).dump()), Contains("field \"rings\": the slabs would take") && Contains("268435456"));

  const auto fit = [](int normals) {
    Json points = Json::array(), directions = Json::array();
    for (int i = 0; i < 8192; ++i) points.push_back({i, i % 7});
    for (int i = 0; i < normals; ++i) directions.push_back({1, i});
    return Json{{"kind", "bounding_volume_fit"}, {"volume", "kdop"}, {"points", points}, {"normals", directions}};
  };
  CHECK(ask(fit(8192).dump()).lines.at(0)["result"]["lo"].size() == 8192);
  CHECK_THAT(error(fit(8193).dump()), Contains("field \"normals\"") && Contains("67108864"));
}

#ifndef __SANITIZE_ADDRESS__  // its allocator ends the program
TEST_CASE("where memory runs out that line is an error, and the next lines go on", "[query]") {
  std::string wide = R"({"kind": "convex_hull2d", "points": [[0,0])";
  while (wide.size() < 30'000'000) wide += ",[0.5,0.25]";
  wide += "]}\n";
  const Shell shell;
  isect::test::write(shell.work() / "cases", orient + "\n" + wide + orient + "\n" + wide + orient + "\n");
  const Ran r = shell(R"sh(
    mkfifo in; isect query <in >out & exec 3>in
    head -n 1 cases >&3; for i in $(seq 1000); do [ -s out ] && break; sleep 0.01; done  # until it waits again
    kilobytes=$(awk '/^VmSize/ { print $2 }' /proc/$!/status); exec 3>&-; wait
    ulimit -v $((kilobytes + 150000)); isect query <cases; echo $?)sh");
  std::istringstream out(r.out);
  std::vector<std::string> lines;
  for (std::string line; std::getline(out, line);) lines.push_back(line);
  REQUIRE(lines.size() == 6);
  for (const int i : {0, 2, 4}) CHECK(lines[i] == R"({"id":null,"result":{"sign":1}})");
  for (const int i : {1, 3})
    CHECK(lines[i] ==
          R"({"id":null,"error":"line )" + std::to_string(i + 1) + R"(: there is not enough memory to answer it"})");
  CHECK(lines[5] == "1");
}
#endif

TEST_CASE("an error names the field, what is allowed and what was found", "[query]") {
  CHECK(error("{\"kind\": \"orient2d\", \"a\": [0, 0") == "no JSON: the line ends too early");
  CHECK_THAT(error("{\"kind\": orient2d}"), Contains("no JSON: character 10"));
  const auto with = [](const std::string& word) {
    return R"({"kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, )" + word + "]}";
  };
  for (const std::string word : {"NaN", "nan"})
    CHECK(error(with(word)) == "no JSON: " + word + " at character 57 is no number; a number is expected");
  for (const std::string word : {"Infinity", "-Infinity", "inf"})
    CHECK_THAT(error(with(word)), Contains("nfinity at character 5") || Contains("inf at character 57"));
  CHECK_THAT(error(with("Infinity")), Contains("write \"inf\" or \"-inf\" in quotes"));
  for (const std::string word : {"NaNs", "no", "\"NaN"}) CHECK_THAT(error(with(word)), !Contains("is no number;"));
  CHECK_THAT(error("[1, 2]"), Contains("an object is expected, not a list of 2"));
  CHECK_THAT(error("7"), Contains("an object is expected, not the number 7"));
  CHECK_THAT(error(R"({"kind": "orient4d"})"), Contains("\"kind\"") && Contains("orient4d") && Contains("ray_sphere"));
  CHECK_THAT(error(R"({"kind": 1})"), Contains("field \"kind\": a text is expected, not the number 1"));
  CHECK(error(R"({"kind": "orient2d", "a": [0, 0], "b": [1, 0]})") == "field \"c\" is missing");
  CHECK_THAT(error(R"({"kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, 1, 2]})"),
             Contains("field \"c\": a list of 2 is expected, not a list of 3"));
  CHECK_THAT(error(R"({"kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, "1"]})"),
             Contains("field \"c[1]\": a finite number is expected, not the text \"1\""));
  CHECK_THAT(error(R"({"kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, "nan"]})"), Contains("field \"c[1]\""));
  CHECK_THAT(error(R"({"kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, 1e999]})"), Contains("too large"));
  CHECK_THAT(error(R"({"kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, 1e99], "scalar": "f32"})"),
             Contains("field \"c[1]\": a number within f32"));
  CHECK_THAT(error(R"({"kind": "orient2d", "scalar": "f16"})"), Contains("allowed: f64 or f32"));
  CHECK_THAT(error(R"({"kind": "ray_sphere", "variant": "newton"})"),
             Contains("field \"variant\": \"newton\"") && Contains("half_b or haines"));
  CHECK_THAT(error(R"({"kind": "orient2d", "trace": 1})"), Contains("field \"trace\": true or false"));
  CHECK_THAT(error(R"({"kind": "ray_sphere", "origin": [0], "dir": [1], "center": [2], "radius": 1})"),
             Contains("field \"origin\": a list of 2 or 3 numbers is expected, not a list of 1"));
  CHECK_THAT(error(R"({"kind": "ray_sphere", "origin": [0, 0], "dir": [1, 0], "center": [2, 0, 0], "radius": 1})"),
             Contains("field \"center\": a list of 2 is expected"));
}

TEST_CASE("infinite ends are those of ranges and of empty boxes, and elsewhere the one that is infinite is named",
          "[query]") {
  const auto answered = [](const std::string& line) { return ask(line + "\n").lines.at(0).contains("result"); };
  CHECK(answered(R"({"kind": "interval_interval", "a": ["-inf", 1], "b": [0, "inf"]})"));
  CHECK(answered(R"({"kind": "ray_sphere", "origin": [0,0], "dir": [1,0], "tmin": "-inf", "tmax": "inf",)"
                 R"( "center": [2,0], "radius": 1})"));
  CHECK(answered(R"({"kind": "point_box", "point": [0,0], "lo": ["inf",0], "hi": ["-inf",1]})"));
  const std::string expected = ": a finite number is expected of a box that is not empty, not the text ";
  CHECK(error(R"({"kind": "box_box", "alo": [0,"-inf"], "ahi": [1,1], "blo": [0,0], "bhi": [1,1]})") ==
        "field \"alo[1]\"" + expected + "\"-inf\"");
  CHECK(error(R"({"kind": "ray_box", "origin": [0,0], "dir": [1,0], "lo": [0,0], "hi": ["inf",1]})") ==
        "field \"hi[0]\"" + expected + "\"inf\"");
  for (const std::string rest : {R"("point_box", "point": [0,0])", R"("sphere_box", "center": [0,0], "radius": 1)",
                                 R"("plane_box", "normal": [0,1], "d": 0)"})
    CHECK(error("{\"kind\": " + rest + R"(, "lo": [0,0], "hi": [1,"inf"]})") ==
          "field \"hi[1]\"" + expected + "\"inf\"");
  const std::string kdops = R"({"kind": "kdop_kdop", "normals": [[1,0],[0,1]], "a": {"lo": [0,0], "hi": [1,"inf"]}, )"
                            R"("b": {"lo": [0,0], "hi": [1,1]}})";
  CHECK(error(kdops) == "field \"a.hi[1]\": a finite number is expected, not the text \"inf\"");
  const std::string help = Shell()("isect query --help").out;
  CHECK_THAT(help, Contains("Only tmin, tmax and the ends of intervals and of empty\nboxes may be \"inf\""));
}

TEST_CASE("long lines are answered, rubbish refused, whatever the size", "[query]") {
  std::string ring = R"({"kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, 1], "note": [)";
  while (ring.size() < 1'000'000) ring += "[0.12345678901234567, -7e-3], ";
  CHECK(ask(ring + "0]}").lines.at(0)["result"]["sign"] == 1);

  CHECK(error(std::string(1'000'000, '[')) == "no JSON: the line ends too early");
  CHECK_THAT(error(Json(std::string(1'000'000, 'x')).dump()), Contains("a text of 1000000 bytes"));
  CHECK_THAT(error(Json{{"kind", std::string(1'000'000, 'x')}}.dump()), Contains("a text of 1000000 bytes"));
  CHECK_THAT(error(R"({"id": "\ud800", "kind": "orient2d"})"), Contains("no JSON"));
}

TEST_CASE("binary rubbish and damaged cases give errors, never a crash", "[query]") {
  isect::bench::Random random(isect::tests::seed());
  INFO("seed " << isect::tests::seed());
  std::string text;
  int count = 0;
  for (int i = 0; i < 300; ++i) {
    std::string line = i % 3 == 0 ? std::string() : orient;
    for (int k = 1 + random.below(i % 3 == 0 ? 200 : 3); k > 0; --k) {
      const char byte = static_cast<char>(random.below(256));
      if (i % 3 == 0 || random.one_in(3))
        line.insert(line.begin() + random.below(static_cast<int>(line.size()) + 1), byte);
      else if (random.one_in(2))
        line[random.below(static_cast<int>(line.size()))] = byte;
      else
        line.resize(static_cast<std::size_t>(random.below(static_cast<int>(line.size()) + 1)));
      if (line.empty()) line.push_back('!');
    }
    std::erase(line, '\n');
    text += line + "\n";
    ++count;
  }
  const Replies r = ask(text);
  CHECK(r.status == 1);
  CHECK(r.lines.size() == static_cast<std::size_t>(count));
}

TEST_CASE("an answer comes as soon as its case, before the input ends", "[query]") {
  const Shell shell;
  isect::test::write(shell.work() / "case", orient + "\n");
  // the second case is written only after the first answer has been read
  const Ran r = shell(
      "mkfifo in out; isect query <in >out & exec 3>in 4<out; cat case >&3; read -r first <&4; cat case >&3; "
      "read -r second <&4; exec 3>&-; wait $!; echo \"$? $first $second\"");
  CHECK(r.out == "0 {\"id\":null,\"result\":{\"sign\":1}} {\"id\":null,\"result\":{\"sign\":1}}\n");
}

#ifndef __SANITIZE_ADDRESS__  // it keeps what was freed, to notice who still reads it
TEST_CASE("memory does not grow with the number of cases", "[query]") {
  const Shell shell;
  isect::test::write(shell.work() / "case", orient + "\n");
  const Ran r = shell(R"sh(
    mkfifo in; isect query <in >out & exec 3>in
    resident() {
      until [ "$(wc -l <out)" = "$1" ]; do sleep 0.01; done
      awk '/^VmRSS/ { print $2 }' /proc/$!/status
    }
    yes "$(cat case)" | head -n 1000 >&3; resident 1000
    yes "$(cat case)" | head -n 99000 >&3; resident 100000
    exec 3>&-; wait $!)sh");
  std::istringstream kilobytes(r.out);
  int early = 0, late = 0;
  kilobytes >> early >> late;
  CHECK(early > 1000);
  CHECK(late < early + 500);  // 99,000 cases more: 5 bytes for each would show
}
#endif

TEST_CASE("a trace is told on request, and the note's naive methods are variants", "[query]") {
  const Replies r = ask(
      R"({"kind": "ray_sphere", "origin": [0, 0, -5], "dir": [0, 0, 1], "center": [1, 0, 0], "radius": 1, "trace": true})"
      "\n"
      R"({"kind": "ray_sphere", "origin": [0, 0, 0], "dir": [0, 0, 1], "center": [1.5, 0, 5000], "radius": 1, "scalar": "f32"})"
      "\n"
      R"({"kind": "ray_sphere", "origin": [0, 0, 0], "dir": [0, 0, 1], "center": [1.5, 0, 5000], "radius": 1, "scalar": "f32", "variant": "quadratic"})"
      "\n");
  CHECK(r.status == 0);
  REQUIRE(r.lines.size() == 3);
  CHECK(r.lines[0]["trace"][0]["event"] == "Fallback");  // tangent: doubles can't tell
  CHECK(r.lines[0]["trace"][1]["discriminant"] == 0);
  CHECK_FALSE(r.lines[1].contains("trace"));
  CHECK(r.lines[1]["result"]["ray_hit"] == false);  // the true answer
  CHECK(r.lines[2]["result"]["ray_hit"] == true);   // what float makes of it
}

TEST_CASE("query's files and usage", "[query]") {
  const Shell shell;
  const Ran missing = shell("isect query nothing.jsonl");
  CHECK(missing.status == 4);
  CHECK_THAT(missing.err, Contains("nothing.jsonl") && Contains("No such file"));
  CHECK(shell("isect query a b").status == 2);
  CHECK(shell("isect query --fast").status == 2);
  isect::test::write(shell.work() / "cases", orient + "\n");
  CHECK(shell("isect query cases").out == "{\"id\":null,\"result\":{\"sign\":1}}\n");
  CHECK(shell("isect query - <cases").out == "{\"id\":null,\"result\":{\"sign\":1}}\n");
  CHECK(shell("isect query . ").status == 4);
  CHECK(shell("isect query cases >/dev/full").status == 4);
  CHECK_THAT(shell("isect query --help").out, Contains("ray_sphere") && Contains("haines") && Contains("Example"));
}

TEST_CASE("query tells by one rule how thin shapes lie", "[query]") {
  const auto relation = [](const std::string& request) { return ask(request).lines.at(0)["result"]; };
  const auto boxes = [&](const std::string& alo, const std::string& ahi) {
    return relation(R"({"kind": "box_box", "blo": [-1,-1,-1], "bhi": [1,1,1], "alo": )" + alo + ", \"ahi\": " + ahi +
                    "}");
  };
  const auto expect = [](const Json& result, const char* told, bool interiors) {
    CHECK(result["relation"] == told);
    CHECK(result["interiors_intersect"] == interiors);
    CHECK_FALSE(result.contains("empty"));
  };
  expect(boxes("[-2,0,-2]", "[2,0,2]"), "overlap", true);  // a plate pierces
  expect(boxes("[-2,1,-2]", "[2,1,2]"), "touch", false);   // on a face
  expect(boxes("[1,0,0]", "[2,0,0]"), "touch", false);     // a rod
  expect(boxes("[0,0,0]", "[2,0,0]"), "overlap", true);    //
  expect(boxes("[0,0,0]", "[0,0,0]"), "b_contains_a", true);
  expect(boxes("[1,1,1]", "[1,1,1]"), "b_contains_a", false);
  const auto triangle = [&](const std::string& points) {
    return relation(R"({"kind": "triangle_box", "lo": [-2,-2,-2], "hi": [2,2,2], "tri": )" + points + "}")["relation"];
  };
  CHECK(triangle("[[0,0,0],[1,0,0],[0,1,0]]") == "b_contains_a");
  CHECK(triangle("[[0,0,2],[1,0,2],[0,1,2]]") == "b_contains_a");
  CHECK(triangle("[[0,0,0],[5,0,0],[0,1,0]]") == "overlap");
  CHECK(triangle("[[0,0,2],[5,0,2],[0,1,2]]") == "touch");
  CHECK(triangle("[[3,0,2],[5,0,2],[4,1,2]]") == "disjoint");
  CHECK(relation(R"({"kind": "triangle_box", "lo": [0,0], "hi": [1,1], "tri": [[-9,-9],[9,-9],[0,99]]})")["relation"] ==
        "a_contains_b");
}

TEST_CASE("query says which box is empty", "[query]") {
  const auto empty = [](const std::string& request) { return ask(request).lines.at(0)["result"].value("empty", ""); };
  const std::string good = R"([0,0], "bhi": [1,1]})", bad = R"([1,0], "bhi": [0,1]})";
  CHECK(empty(R"({"kind": "box_box", "alo": [0,0], "ahi": [1,1], "blo": )" + good) == "");
  CHECK(empty(R"({"kind": "box_box", "alo": [0,0], "ahi": [1,1], "blo": )" + bad) == "b");
  CHECK(empty(R"({"kind": "box_box", "alo": [2,0], "ahi": [1,1], "blo": )" + good) == "a");
  CHECK(empty(R"({"kind": "box_box", "alo": [2,0], "ahi": [1,1], "blo": )" + bad) == "a and b");
  CHECK(empty(R"({"kind": "sphere_box", "center": [0,0], "radius": 1, "lo": [1,1], "hi": [2,0]})") == "box");
  CHECK(empty(R"({"kind": "triangle_box", "tri": [[0,0],[1,0],[0,1]], "lo": [1,1], "hi": [2,0]})") == "box");
  const std::string flat = R"({"c": [0,0,0], "u": [[1,0,0],[1,0,0],[0,0,1]], "e": [1,1,1]})";  // no such box
  const std::string cube = R"({"c": [1,0,0], "u": [[1,0,0],[0,1,0],[0,0,1]], "e": [1,1,1]})";
  CHECK(empty(R"({"kind": "obb_obb", "a": )" + flat + R"(, "b": )" + cube + "}") == "a");
  CHECK(empty(R"({"kind": "obb_obb", "a": )" + cube + R"(, "b": )" + flat + "}") == "b");
  CHECK(empty(R"({"kind": "obb_obb", "a": )" + cube + R"(, "b": )" + cube + "}") == "");
  CHECK(empty(R"({"kind": "point_obb", "point": [1.5,0,0], )" + flat.substr(1)) == "box");
  CHECK(empty(R"({"kind": "ray_obb", "origin": [1.5,-5,0], "dir": [0,1,0], )" + flat.substr(1)) == "box");
  CHECK(empty(R"({"kind": "ray_obb", "origin": [1.5,-5,0], "dir": [0,1,0], )" + cube.substr(1)) == "");
}

TEST_CASE("query fits the smallest ball where it is asked for", "[query]") {
  const auto fit = [](const std::string& volume) {
    return ask(R"({"kind": "bounding_volume_fit", "points": [[0,0],[0.5,0.01],[1,0]], "volume": ")" + volume + "\"}")
        .lines.at(0)["result"];
  };
  CHECK(fit("smallest_sphere")["radius"] == 0.5);
  CHECK(fit("smallest_sphere")["center"] == Json::parse("[0.5, 0.0]"));
  CHECK(fit("sphere")["radius"].get<double>() > 0.5);
  CHECK_THAT(Shell()("isect query --help").out, Contains("smallest_sphere") && Contains("another name of exact"));
}

TEST_CASE("the variant robust of a ray and a ball is the exact call by another name", "[query]") {
  const std::string request = R"({"kind": "ray_sphere", "origin": [-100000000.0000001,0.1,0], "dir": [1,0.3,0], )"
                              R"("center": [0,0,0], "radius": 1e8, "variant": )";
  const Replies r = ask(request + "\"robust\"}\n" + request + "\"exact\"}");
  REQUIRE(r.lines.size() == 2);
  CHECK(r.lines[0]["result"] == r.lines[1]["result"]);
}

TEST_CASE("a trace tells a choice by its name", "[query]") {
  const Replies r = ask(
      R"({"kind": "sphere_capsule", "center": [1, 4.5], "radius": 2, "p": [-3, 0], "q": [3, 0], "r": 2, "trace": true})"
      "\n"
      R"({"kind": "triangle_box", "tri": [[2, 0], [3, 0], [2, 1]], "lo": [0, 0], "hi": [1, 1], "trace": true})");
  REQUIRE(r.lines.size() == 2);
  CHECK(r.lines[0]["trace"][0] == Json::parse(R"({"event": "Reach", "nearest": "between", "sign": 1})"));
  CHECK(r.lines[1]["trace"][0]["axis"]["kind"] == "box_normal");
}

TEST_CASE("every kind has an example that every variant answers, in either scalar, with a trace", "[query]") {
  std::map<std::string, Json> examples;
  std::istringstream lines(isect::test::contents(ISECT_EXAMPLES));
  for (std::string line; std::getline(lines, line);) {
    const Json example = Json::parse(line);
    examples[example["kind"]] = example;
  }

  std::istringstream help(Shell()("isect query --help").out);
  int kinds = 0;
  for (std::string line; std::getline(help, line);) {
    std::istringstream words(line);
    std::string kind, variant, input;
    words >> kind >> variant;
    if (!line.starts_with("  ") || variant != "exact") continue;
    REQUIRE(std::getline(help, line));
    std::istringstream inputs(line);
    for (inputs >> input; inputs >> input;) {
      if (input[0] == '[') continue;
      Json without = examples[kind];
      without.erase(input);
      CHECK(error(without.dump()) == "field \"" + input + "\" is missing");
    }
    ++kinds;
    std::string text;
    for (; words; words >> variant)
      for (const char* scalar : {"f64", "f32"}) {
        Json request = examples[kind];
        request["variant"] = variant, request["scalar"] = scalar, request["trace"] = true;
        if (variant == "convex") request["rings"] = {request["rings"][0]};
        text += request.dump() + "\n";
      }
    for (const Json& reply : ask(text).lines) {
      INFO(kind << ": " << reply.dump());
      CHECK(reply.contains("result"));
      CHECK(reply["id"] == kind);
      CHECK(reply.contains("trace"));
    }
  }
  CHECK(kinds == 51);
  CHECK(examples.size() == 51);
}

TEST_CASE("every lesson names a case that isect query answers as it is pasted, wherever the lesson is told",
          "[query]") {
  const Shell shell;
  std::set<std::string> cases;
  for (const isect::viz::Lesson* lesson : isect::lessons::all_lessons()) {
    INFO(lesson->id);
    const auto own = isect::viz::judge(*lesson);
    REQUIRE(own);
    std::string command;
    for (const std::string& line : own->command) command += line + "\n";
    CHECK(cases.insert(lesson->query).second);
    const Ran ran = shell(command);
    INFO(command << ran.out << ran.err);
    CHECK(ran.status == 0);
    CHECK(Json::parse(ran.out).contains("result"));
    CHECK(Json::parse(ran.out)["result"].size() > 0);
    const Ran told = shell("isect explain " + lesson->id + " --exercises");
    for (const std::string& line : own->command) CHECK_THAT(told.out, Contains("  " + line + "\n"));
  }
  const std::string last = isect::viz::judge(*isect::lessons::all_lessons().front())->command.back();
  CHECK_THAT(shell("isect explain relations").out, Contains("  " + last + "\n"));
  REQUIRE(shell("isect handout relations").status == 0);
  const auto files = isect::test::files_in(shell.work() / "handouts");
  const auto page = std::find_if(files.begin(), files.end(), [](const auto& f) { return f.ends_with(".html"); });
  REQUIRE(page != files.end());
  CHECK_THAT(isect::test::contents(shell.work() / "handouts" / *page), Contains("| isect query"));
}

}  // namespace query_test
