# Turns the comment at the head of a header into Doxygen's comment of that file: the first paragraph as prose, the rest
# as it is written.
NR == 1 { print "/** @file"; head = 1; next }
head && sub(/^\/\/ ?/, "") { print !verbatim && $0 == "" ? "@verbatim" : $0; verbatim = verbatim || $0 == ""; next }
head { print verbatim ? "@endverbatim */" : "*/"; head = 0; next }
{ print }
