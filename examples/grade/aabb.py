# Do two axis-aligned boxes share a point? What it reads and answers: isect grade aabb
# isect grade aabb --plain python3 aabb.py
import sys

for line in sys.stdin:
    x = iter(map(float, line.split()))
    alo = [next(x) for _ in range(3)]
    ahi = [next(x) for _ in range(3)]
    blo = [next(x) for _ in range(3)]
    bhi = [next(x) for _ in range(3)]
    # Write the test here.
    print("0", flush=True)
