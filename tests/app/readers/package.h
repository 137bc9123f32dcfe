#pragma once
// What a test reads of a package, apart from the library that wrote it: the files of a zip archive, and a small tree of
// XML by Expat, and the text of HTML.

#include <expat.h>
#include <zlib.h>

#include <cctype>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace isect::test {

/// The files of an archive by name; it has no two of one name, each is as long as is said and has the checksum and the
/// date of it. Throws std::runtime_error.
inline std::map<std::string, std::string> unzipped(const std::string& bytes) {
  const auto number = [&](std::size_t at, int size) {
    std::uint32_t value = 0;
    for (int i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return value;
  };
  const auto need = [](bool holds, const std::string& what) {
    if (!holds) throw std::runtime_error("zip: " + what);
  };
  const std::size_t end = bytes.rfind("PK\5\6");
  need(end != bytes.npos && end + 22 + number(end + 20, 2) == bytes.size(), "it has no end, or something behind it");
  std::map<std::string, std::string> files;
  std::size_t entry = number(end + 16, 4);
  for (std::uint32_t i = 0; i < number(end + 10, 2); ++i) {
    need(bytes.compare(entry, 4, "PK\1\2") == 0, "an entry is none");
    need(number(entry + 12, 2) == 0 && number(entry + 14, 2) == 33, "the date is not 1980-01-01");
    const std::string name = bytes.substr(entry + 46, number(entry + 28, 2));
    const std::size_t local = number(entry + 42, 4), packed = number(entry + 20, 4), size = number(entry + 24, 4);
    need(bytes.compare(local, 4, "PK\3\4") == 0 && bytes.compare(local + 30, name.size(), name) == 0,
         name + " is not where it should be");
    const std::string data = bytes.substr(local + 30 + number(local + 26, 2) + number(local + 28, 2), packed);
    std::string file(size, '\0');
    if (number(entry + 10, 2) == 0) {
      file = data;
    } else {
      z_stream stream = {};
      need(number(entry + 10, 2) == 8 && inflateInit2(&stream, -MAX_WBITS) == Z_OK, name + " is packed in another way");
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
      stream.avail_in = static_cast<uInt>(data.size());
      stream.next_out = reinterpret_cast<Bytef*>(file.data()), stream.avail_out = static_cast<uInt>(file.size());
      const int status = inflate(&stream, Z_FINISH);
      need((status == Z_STREAM_END || file.empty()) && stream.avail_out == 0, name + " can't be unpacked");
      inflateEnd(&stream);
    }
    need(file.size() == size &&
             ::crc32_z(0, reinterpret_cast<const Bytef*>(file.data()), file.size()) == number(entry + 16, 4),
         name + " has another length or checksum");
    need(files.emplace(name, file).second, name + " is there twice");
    entry += 46 + number(entry + 28, 2) + number(entry + 30, 2) + number(entry + 32, 2);
  }
  return files;
}

/// An element of XML.
struct Xml {
  std::string name;
  std::map<std::string, std::string> attributes = {};
  std::string text = {};  ///< its own, without that of its elements
  std::vector<Xml> children = {};

  std::vector<const Xml*> all(const std::string& wanted) const {
    std::vector<const Xml*> found;
    for (const Xml& child : children)
      if (child.name == wanted) found.push_back(&child);
    return found;
  }
  /// The only element of this name. Throws std::runtime_error if there is none, or another one.
  const Xml& one(const std::string& wanted) const {
    const std::vector<const Xml*> found = all(wanted);
    if (found.size() != 1)
      throw std::runtime_error(name + " has " + std::to_string(found.size()) + " elements " + wanted);
    return *found.front();
  }
  std::string at(const std::string& attribute) const {
    const auto found = attributes.find(attribute);
    return found == attributes.end() ? std::string() : found->second;
  }
  /// All text within, in its order, with a line break at the end of each p and at each br.
  std::string words() const;
  std::vector<std::pair<std::size_t, std::size_t>> places = {};  ///< where each child stands in the text, its index
};

inline std::string Xml::words() const {
  std::string out;
  std::size_t from = 0;
  for (const auto& [at, child] : places) {
    out += text.substr(from, at - from) + children[child].words();
    from = at;
  }
  out += text.substr(from);
  return name == "p" || name == "br" ? out + "\n" : out;
}

/// The root of a document. Throws std::runtime_error on what is not well-formed.
inline Xml parsed_xml(const std::string& document) {
  Xml top = {"top"};
  std::vector<Xml*> open = {&top};
  const XML_Parser parser = XML_ParserCreate("UTF-8");
  XML_SetUserData(parser, &open);
  XML_SetElementHandler(
      parser,
      [](void* self, const char* name, const char** attributes) {
        auto& path = *static_cast<std::vector<Xml*>*>(self);
        Xml& parent = *path.back();
        parent.places.emplace_back(parent.text.size(), parent.children.size());
        parent.children.push_back({name});
        for (; *attributes; attributes += 2) parent.children.back().attributes[attributes[0]] = attributes[1];
        path.push_back(&parent.children.back());
      },
      [](void* self, const char*) { static_cast<std::vector<Xml*>*>(self)->pop_back(); });
  XML_SetCharacterDataHandler(parser, [](void* self, const char* text, int length) {
    static_cast<std::vector<Xml*>*>(self)->back()->text.append(text, static_cast<std::size_t>(length));
  });
  const bool read = XML_Parse(parser, document.data(), static_cast<int>(document.size()), 1) == XML_STATUS_OK;
  const std::string why = read ? "" : XML_ErrorString(XML_GetErrorCode(parser));
  XML_ParserFree(parser);
  if (!read) throw std::runtime_error("xml: " + why);
  return top.children.front();
}

/// A part of a web page that is also XML.
inline Xml parsed_html(const std::string& html) { return parsed_xml("<div>" + html + "</div>"); }
/// The text of it, with a line break at the end of each paragraph and line.
inline std::string words_of_html(const std::string& html) { return parsed_html(html).words(); }

/// The bytes of base64.
inline std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t value = digits.find(c);
    if (value == digits.npos) continue;
    bits = bits << 6 | static_cast<std::uint32_t>(value), count += 6;
    if (count >= 8) count -= 8, bytes += static_cast<char>(bits >> count & 255);
  }
  return bytes;
}

}  // namespace isect::test
