#pragma once
// Where two texts of pseudocode differ by names alone.

#include <map>
#include <string>
#include <vector>

namespace isect::viz {

/// How two texts compare, line by line from the first on.
struct ComparedTexts {
  std::vector<int> renamed = {};  ///< the lines before `parted` that differ by names alone, from 0
  int parted = -1;                ///< the first line that differs in more than names, or that one text lacks; -1: none
  std::map<std::string, std::string> names = {};  ///< of the lines before `parted`, by name of a: the name in b
};

/// A name may be another one if both texts give it: by an assignment, as a loop's variable, as a function's name or
/// parameter. What is given from outside means something in the picture, so it keeps its name. Each name has one other
/// name from the first line on; what does not keep to that differs.
ComparedTexts compared_texts(const std::vector<std::string>& a, const std::vector<std::string>& b);

/// Whether one name in plain text, of a text's value, is the other one: "d²" and "m²" where d was renamed to m.
bool is_renamed(const ComparedTexts&, const std::string& a, const std::string& b);

}  // namespace isect::viz
