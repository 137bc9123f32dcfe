# Do two balls share a point? What it reads and answers: isect grade sphere-sphere
# isect grade sphere-sphere --plain python3 sphere-sphere.py
import sys

for line in sys.stdin:
    x = iter(map(float, line.split()))
    c1 = [next(x) for _ in range(3)]
    r1 = next(x)
    c2 = [next(x) for _ in range(3)]
    r2 = next(x)
    # Write the test here.
    print("0", flush=True)
