# The version of isect, for whichever project builds it.
set(ISECT_VERSION 0.1.0)
