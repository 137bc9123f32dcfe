#pragma once
// Catalogues of translations as gettext writes them: .po files, in UTF-8. What translators' programs write is read, as
// msgfmt reads it; what is broken is refused with its line.

#include <cstddef>
#include <string>
#include <vector>

namespace isect::viz {

struct PoEntry {
  std::string context, english, other;  ///< `other`: of a text that counts; else empty
  std::vector<std::string> texts;       ///< one, or one for each plural form; empty ones are not translated yet
  bool fuzzy = false;                   ///< of a similar text: it counts as not translated
  int line = 0;                         ///< where it begins, from 1

  bool is_translated() const;
};

/// How a language counts.
enum class Plural { one_form, one_is_singular, below_two_is_singular };
/// Returns which of the forms a number takes, from 0.
std::size_t plural_form(Plural, std::size_t n);
std::size_t plural_forms(Plural);

struct PoFile {
  std::string language;  ///< of its head: "de"; a template has none
  Plural plural = Plural::one_is_singular;
  std::vector<PoEntry> entries;  ///< without the head
};

/// Reads a catalogue. Throws BadInput, which names the line, for what is no entry, for a key that stands there twice,
/// for a wrong number of plural forms, and for a rule of plurals that is not known here.
PoFile read_po(const std::string& text);

/// Returns the file as read_po reads it.
std::string po_text(const PoFile&);

}  // namespace isect::viz
