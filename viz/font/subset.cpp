#include "viz/font/subset.h"

#include <glib.h>
#include <hb-ot.h>
#include <hb-subset.h>

#include <memory>

#include "viz/font/file.h"
#include "viz/text/text.h"

namespace isect::viz {
namespace {

/// The name that the font's licence reserves, and our own, of the same length.
constexpr std::string_view reserved = "STIXGeneral", own_name = "IsectLetter";

template <auto destroy>
struct Destroy {
  void operator()(auto* object) const { destroy(object); }
};
template <class T, auto destroy>
using Owned = std::unique_ptr<T, Destroy<destroy>>;
using Blob = Owned<hb_blob_t, hb_blob_destroy>;
using FontFace = Owned<hb_face_t, hb_face_destroy>;

/// Returns the face's pattern for fontconfig.
std::string pattern_of(Face face) {
  const std::string style = face == Face::italic ? ":italic" : face == Face::bold ? ":bold" : "";
  return std::string(reserved) + style;
}

std::string name_in(hb_face_t* face, hb_ot_name_id_t id) {
  unsigned length = hb_ot_name_get_utf8(face, id, HB_LANGUAGE_INVALID, nullptr, nullptr);
  std::string text(length + 1, '\0');
  ++length;
  hb_ot_name_get_utf8(face, id, HB_LANGUAGE_INVALID, &length, text.data());
  text.resize(length);
  return text;
}

void add_letters(hb_set_t* to, const std::string& utf8) {
  for (const char* at = utf8.c_str(); *at; at = g_utf8_next_char(at)) hb_set_add(to, g_utf8_get_char(at));
}

}  // namespace

std::optional<FontSubset> font_subset(Face face, const std::string& letters) {
  if (fonts().figure != reserved || !g_utf8_validate(letters.data(), static_cast<gssize>(letters.size()), nullptr))
    return {};
  const Blob file(hb_blob_create_from_file_or_fail(font_file(pattern_of(face)).c_str()));
  if (!file) return {};
  const FontFace whole(hb_face_create(file.get(), 0));
  const Owned<hb_subset_input_t, hb_subset_input_destroy> input(hb_subset_input_create_or_fail());
  if (!input) return {};
  add_letters(hb_subset_input_unicode_set(input.get()), letters);
  hb_set_t* const names = hb_subset_input_set(input.get(), HB_SUBSET_SETS_NAME_ID);
  hb_set_clear(names);
  FontSubset subset;
  for (const hb_ot_name_id_t id :
       {HB_OT_NAME_ID_COPYRIGHT, HB_OT_NAME_ID_TRADEMARK, HB_OT_NAME_ID_LICENSE, HB_OT_NAME_ID_LICENSE_URL}) {
    hb_set_add(names, id);
    subset.notice += name_in(whole.get(), id) + "\n";
  }
  const FontFace part(hb_subset_or_fail(whole.get(), input.get()));
  if (!part) return {};
  const Blob bytes(hb_face_reference_blob(part.get()));
  unsigned size = 0;
  const char* const data = hb_blob_get_data(bytes.get(), &size);
  std::string font(data, size);
  for (std::size_t at = font.find(reserved); at != font.npos; at = font.find(reserved, at))
    font.replace(at, own_name.size(), own_name);
  subset.bytes = std::move(font);
  return subset;
}

}  // namespace isect::viz
