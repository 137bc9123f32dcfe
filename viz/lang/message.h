#pragma once
// What the program says, in the language that is spoken now. The English text in the source is the key: a catalogue of
// a language (viz/lang/de.po) has the translation, and where it has none, English is said.
//
//   tr("{both} touch", {{"both", "A and B"}})            "A und B berühren einander"
//   tr_as("after which", "ball")                         one English word, several forms in other languages
//   tr_count(n, "{n} triangle", "{n} triangles")         {n} is filled in
//
// The texts stand as literals in these calls, or in a table as message(...): tests/lang/keys.py finds them there.

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace isect::viz {

/// What stands at each place: {"a", "**A**"} replaces "{a}". A name has small letters. "_{in}" and "^{a}" are markup,
/// and stay.
using Filling = std::initializer_list<std::pair<std::string_view, std::string>>;

/// A text that is said later. With `other` it counts: `english` is for one.
struct Message {
  std::string_view english, other = {}, context = {};
};
constexpr Message message(std::string_view english) { return {english}; }
constexpr Message message_as(std::string_view context, std::string_view english) { return {english, {}, context}; }
constexpr Message message_count(std::string_view one, std::string_view other) { return {one, other}; }

/// Returns the text of a message that does not count.
std::string tr(const Message&, Filling = {});
std::string tr(std::string_view english, Filling = {});
/// `context`: which form is needed, where English has one for all.
std::string tr_as(std::string_view context, std::string_view english, Filling = {});
/// Returns the text for a number, in one of the language's plural forms.
std::string tr_count(std::size_t n, std::string_view one, std::string_view other, Filling = {});
std::string tr_count(std::size_t n, const Message&, Filling = {});

/// Returns the text with all places filled in.
std::string filled_in(std::string_view text, Filling);

}  // namespace isect::viz
