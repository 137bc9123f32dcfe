# The version of isect, for whichever project builds it.
set(ISECT_VERSION 1.0.0)
