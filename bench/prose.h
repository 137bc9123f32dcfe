#pragma once
// Numbers as words of a sentence.

#include <string>
#include <vector>

namespace isect::bench {

/// Three significant digits, thousands with commas: "0.497", "42.7", "1,280", "4.13e+05".
std::string number(double);
/// "none", "15 in a million", "0.27 %", "24 %".
std::string share(double wrong, double of);
/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>&);
/// The first letter in upper case.
std::string sentence(std::string);
/// All digits, thousands with commas: "65,536".
std::string count(long);
/// Two significant digits: "2.9", "0.34", "630".
std::string ratio_text(double);
/// "2.06 [2.05, 2.08]"; the number alone where its digits say as much.
std::string with_interval(double x, double lo, double hi);

}  // namespace isect::bench
