// The metadata in our SVG files. It is read as XML, because an editor that saved the file may have used its own line
// breaks, quotes and prefixes.

#include <expat.h>
#include <fmt/format.h>

#include <memory>

#include "viz/formats/files.h"
#include "viz/formats/metadata_limit.h"
#include "viz/formats/metadata_text.h"

namespace isect::viz {
namespace {

/// Returns the name without its namespace, which Expat puts before it.
std::string_view local_name(std::string_view name) { return name.substr(name.rfind(' ') + 1); }

/// One pass over a file. No handler throws: Expat is C.
class MetadataReader {
 public:
  MetadataReader() : parser_(XML_ParserCreateNS(nullptr, ' ')) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(),
        [](void* self, const char* name, const char** attributes) {
          static_cast<MetadataReader*>(self)->open(local_name(name), attributes);
        },
        [](void* self, const char*) { static_cast<MetadataReader*>(self)->close(); });
    XML_SetCharacterDataHandler(parser_.get(), [](void* self, const char* text, int length) {
      static_cast<MetadataReader*>(self)->hear({text, static_cast<std::size_t>(length)});
    });
  }

  /// Returns the metadata as JSON; empty if there is none.
  std::string read(const std::string& bytes) {
    constexpr std::size_t block = 1 << 16;  // Expat counts in int
    XML_Status status = XML_STATUS_OK;
    for (std::size_t at = 0; at <= bytes.size() && status == XML_STATUS_OK; at += block) {
      const std::size_t length = std::min(block, bytes.size() - at);
      status = XML_Parse(parser_.get(), bytes.data() + at, static_cast<int>(length), at + block > bytes.size());
    }
    if (!svg_) throw FileError("not an SVG file");
    if (status == XML_STATUS_ERROR)
      throw FileError(fmt::format("broken SVG: line {}: {}", XML_GetCurrentLineNumber(parser_.get()),
                                  trouble_ ? trouble_ : XML_ErrorString(XML_GetErrorCode(parser_.get()))));
    return attribute_.empty() ? element_ : attribute_;
  }

 private:
  struct Free {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };

  void open(std::string_view name, const char** attributes) {
    const bool root = ++depth_ == 1;
    if (root && name != "svg") return stop("the first element is no svg");
    svg_ = true;
    for (; *attributes; attributes += 2) {
      const std::string_view key = attributes[0], value = attributes[1];
      if (root && key == "data-isect") keep(attribute_, value);
      if (name == "metadata" && key == "id" && value == "isect" && ours_ == 0) ours_ = depth_;
    }
  }
  void close() {
    if (depth_-- == ours_) ours_ = 0;
  }
  void hear(std::string_view text) {
    if (ours_ != 0) keep(element_, text);
  }
  void keep(std::string& to, std::string_view text) {
    if (to.size() + text.size() > metadata_limit) return stop("its metadata is too long");
    to += text;
  }
  void stop(const char* why) {
    trouble_ = why;
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  std::unique_ptr<XML_ParserStruct, Free> parser_;
  std::string attribute_, element_;
  const char* trouble_ = nullptr;
  bool svg_ = false;
  int depth_ = 0;
  int ours_ = 0;  ///< depth of the <metadata> that is being read; 0: none
};

}  // namespace

Metadata svg_metadata(const std::string& bytes) {
  const std::string json = MetadataReader().read(bytes);
  return json.empty() ? Metadata{} : metadata_of_text(json, "SVG");
}

}  // namespace isect::viz
