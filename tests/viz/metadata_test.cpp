// What a picture file says about itself, read again after other programs have saved the file, or have damaged it.

#include <zlib.h>

#include "tests/catch.h"
#include "viz/formats/files.h"

namespace metadata_test {
using namespace isect::viz;
using Catch::Matchers::StartsWith;
using isect::test::Contains;

namespace {

const Picture dot = {1, 1, {1, 2, 3, 255}};

std::string big_endian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
          static_cast<char>(value)};
}

/// A PNG with one more chunk, before its last one.
std::string with_chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto* bytes = reinterpret_cast<const Bytef*>(body.data());
  std::string file = png(dot);
  const std::size_t end_chunk = 12;
  return file.insert(file.size() - end_chunk,
                     big_endian(static_cast<std::uint32_t>(data.size())) + body +
                         big_endian(static_cast<std::uint32_t>(::crc32_z(0, bytes, body.size()))));
}

std::string packed(const std::string& text) {
  uLongf size = ::compressBound(text.size());
  std::string out(size, '\0');
  ::compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(text.data()), text.size());
  out.resize(size);
  return out;
}

}  // namespace

TEST_CASE("metadata is found in whichever text chunk a program saved it again", "[metadata]") {
  const std::string key = std::string("isect:lesson") + '\0', text = "ray-sphere";
  const std::string none("\0\0", 2), language = std::string("en") + '\0' + "Lektion" + '\0';
  const Metadata metadata = {{"lesson", text}};
  CHECK(png_metadata(with_chunk("tEXt", key + text)) == metadata);
  CHECK(png_metadata(with_chunk("zTXt", key + '\0' + packed(text))) == metadata);
  CHECK(png_metadata(with_chunk("iTXt", key + none + none + text)) == metadata);
  CHECK(png_metadata(with_chunk("iTXt", key + '\1' + '\0' + language + packed(text))) == metadata);
  CHECK(png_metadata(with_chunk("tEXt", key + "caf\xE9")) == Metadata{{"lesson", "café"}});  // Latin-1
  CHECK(png_metadata(with_chunk("tEXt", key + "café")) == Metadata{{"lesson", "café"}});
}

TEST_CASE("broken and hostile text chunks are refused in words", "[metadata]") {
  const std::string key = std::string("isect:lesson") + '\0';
  CHECK_THROWS_WITH(png_metadata(with_chunk("zTXt", key + '\0' + "no zlib")), Contains("cannot be unpacked"));
  CHECK_THROWS_WITH(png_metadata(with_chunk("zTXt", key + '\0' + packed(std::string(9 << 20, ' ')))),
                    Contains("too long"));
  CHECK_THROWS_WITH(png_metadata(with_chunk("zTXt", key + '\7' + packed("x"))), Contains("unknown way"));
  CHECK_THROWS_WITH(png_metadata(with_chunk("iTXt", key)), Contains("ends within"));
  CHECK_THROWS_WITH(png_metadata(with_chunk("tEXt", "isect:lesson")), Contains("keyword"));
  std::string damaged = with_chunk("tEXt", key + "x");
  damaged[damaged.find("isect:") + 7] ^= 1;
  CHECK_THROWS_WITH(png_metadata(damaged), Contains("damaged"));
  const std::string whole = png(dot, {{"lesson", "x"}});
  for (std::size_t n = 8; n < whole.size(); ++n) REQUIRE_THROWS_AS(png_metadata(whole.substr(0, n)), FileError);
}

TEST_CASE("foreign and broken metadata is told apart", "[metadata]") {
  CHECK(svg_metadata("<svg></svg>").empty());
  CHECK(svg_metadata("<svg><metadata>mine</metadata></svg>").empty());
  CHECK(svg_metadata("<svg><metadata id='other'>{\"a\": \"b\"}</metadata></svg>").empty());
  CHECK_THROWS_AS(svg_metadata("<svg data-isect='{'/>"), FileError);
  CHECK_THROWS_AS(svg_metadata("<svg data-isect='{\"a\": 1}'/>"), FileError);
  CHECK_THROWS_AS(svg_metadata("<svg><metadata id=\"isect\">{\"a\":</metadata></svg>"), FileError);
  CHECK_THROWS_AS(svg_metadata("<svg><metadata id=\"isect\">{\"a\": 1}</metadata></svg>"), FileError);
}

TEST_CASE("what is no SVG is refused in words", "[metadata]") {
  for (const std::string text : {"", "no drawing", "<html><svg/></html>", "\x89PNG", "<?xml version='1.0'?>"})
    CHECK_THROWS_WITH(svg_metadata(text), "not an SVG file");
  CHECK_THROWS_WITH(svg_metadata("<svg>\n<metadata id='isect'>{}"), StartsWith("broken SVG: line 2: "));
  CHECK_THROWS_WITH(svg_metadata("<svg>\n\n</sgv>"), StartsWith("broken SVG: line 3: "));
  const std::string whole = svg({200, 100, {1, 1, 1, 1}, {}}, {{"lesson", "x"}});
  for (std::size_t n = 0; n + 8 < whole.size(); n += 7) {
    INFO(n << " of " << whole.size() << " bytes");
    REQUIRE_THROWS_AS(svg_metadata(whole.substr(0, n)), FileError);
  }
}

/// The SVGs are as Inkscape 1.2, SVGO 2 to 4 and scour 0.38 saved one of isect's figures, removing what they can.
TEST_CASE("metadata is found again in an SVG that another program has saved", "[metadata]") {
  const Metadata metadata = {{"lesson", "ray-sphere"}, {"parameters", R"({"origin":[-4,0.5,0]})"}};
  const std::string json = R"({"lesson":"ray-sphere","parameters":"{\"origin\":[-4,0.5,0]}"})";
  const std::string quoted =
      R"({&quot;lesson&quot;:&quot;ray-sphere&quot;,&quot;parameters&quot;:&quot;{\&quot;origin\&quot;:[-4,0.5,0]}&quot;})";

  const std::string inkscape = R"(<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<!-- Created with Inkscape (http://www.inkscape.org/) -->

<svg
   version="1.1"
   width="960pt"
   viewBox="0 0 7680 4800"
   data-isect=")" + quoted + R"("
   id="svg9"
   sodipodi:docname="a.svg"
   xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
   xmlns="http://www.w3.org/2000/svg"
   xmlns:svg="http://www.w3.org/2000/svg">
  <defs
     id="defs13" />
  <sodipodi:namedview
     id="namedview11" />
</svg>
)";
  const std::string svgo = R"(<svg xmlns="http://www.w3.org/2000/svg" width="1280" data-isect=")" + quoted +
                           R"(" viewBox="0 0 7680 4800"><path d="m1 1 49 49"/></svg>)";
  const std::string scour = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg width=\"960pt\" data-isect='" + json +
                            "' version=\"1.1\" xmlns=\"http://www.w3.org/2000/svg\">\n</svg>\n";
  for (const std::string& text : {inkscape, svgo, scour}) CHECK(svg_metadata(text) == metadata);

  const std::string prefixed = "<svg:svg xmlns:svg='http://www.w3.org/2000/svg' data-isect='" + json + "'/>";
  const std::string doctype = "<!DOCTYPE svg [<!ENTITY id 'ray-sphere'>]><svg data-isect='{\"lesson\":\"&id;\"}'/>";
  CHECK(svg_metadata(prefixed) == metadata);
  CHECK(svg_metadata(doctype) == Metadata{{"lesson", "ray-sphere"}});
}

TEST_CASE("metadata as an element, as it was written before, is found in any layout", "[metadata]") {
  const Metadata metadata = {{"a", "<&>"}};
  for (const std::string text : {R"(<svg><metadata id="isect">{"a":"&lt;&amp;&gt;"}</metadata></svg>)",
                                 "<svg><metadata\n   id='isect'\n   "
                                 "class='x'>{&quot;a&quot;:&quot;&lt;&#38;&gt;&quot;}</metadata></svg>",
                                 R"(<svg><g><metadata id="isect"><![CDATA[{"a":"<&>"}]]></metadata></g></svg>)",
                                 R"(<s:svg xmlns:s="http://www.w3.org/2000/svg"><s:metadata id="isect">
             {"a": "&lt;&amp;&gt;"}
           </s:metadata></s:svg>)"})
    CHECK(svg_metadata(text) == metadata);
}

TEST_CASE("a hostile SVG is refused at once", "[metadata]") {
  std::string laughs = "<!DOCTYPE svg [<!ENTITY l0 'hahahahahahahahaha'>";
  for (int i = 1; i < 12; ++i) {
    laughs += "<!ENTITY l" + std::to_string(i) + " '";
    for (int j = 0; j < 10; ++j) laughs += "&l" + std::to_string(i - 1) + ";";
    laughs += "'>";
  }
  CHECK_THROWS_AS(svg_metadata(laughs + "]><svg>&l11;</svg>"), FileError);
  CHECK_THROWS_AS(svg_metadata(laughs + "]><svg data-isect='&l11;'/>"), FileError);
  CHECK(svg_metadata("<!DOCTYPE svg [<!ENTITY x SYSTEM 'file:///etc/passwd'>]><svg data-isect='{}'>&x;</svg>").empty());

  CHECK_THROWS_WITH(svg_metadata("<svg data-isect='" + std::string(3 << 20, ' ') + "'/>"),
                    Contains("metadata is too long"));
  std::string deep = "<svg>";
  for (int i = 0; i < 1000000; ++i) deep += "<g>";
  CHECK_THROWS_AS(svg_metadata(deep), FileError);
}

}  // namespace metadata_test
