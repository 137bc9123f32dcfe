#pragma once
// Entries put into a JSON text and taken out of it, so that all else stays: layout, order, comments.

#include <optional>
#include <string>

namespace isect::program::scene {

/// Returns where the line of a place begins.
std::size_t line_begin(const std::string& text, std::size_t at);
/// Puts something behind the value that ends at `at`: on a line of its own with this indent, below what else stands on
/// the value's line; or on the same line. A comma that follows stays behind it.
void put_behind(std::string& text, std::size_t at, const std::optional<std::string>& indent, const std::string& what);
/// Adds an entry behind the others of the list at this path: "/objects".
void add_entry(std::string& text, const std::string& list, std::size_t count, const std::string& entry);
/// Adds an entry behind entry `i` of the list at this path.
void add_entry_behind(std::string& text, const std::string& list, std::size_t i, const std::string& entry);
/// Removes entry `i` of the list at this path, with its comma.
void remove_entry(std::string& text, const std::string& list, std::size_t i);

}  // namespace isect::program::scene
