// Do two axis-aligned boxes share a point? What it reads and answers: isect grade aabb
// cc -O2 aabb.c -o aabb -lm && isect grade aabb --plain ./aabb
#include <stdio.h>
#include <stdlib.h>

static double number(void) {
  double x;
  if (scanf("%lf", &x) != 1) exit(0);
  return x;
}
static void read(double *to, int count) {
  for (int i = 0; i < count; ++i) to[i] = number();
}

int main(void) {
  for (;;) {
    double alo[3]; read(alo, 3);
    double ahi[3]; read(ahi, 3);
    double blo[3]; read(blo, 3);
    double bhi[3]; read(bhi, 3);
    // Write the test here.
    puts("0");
    fflush(stdout);
  }
}
