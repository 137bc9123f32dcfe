# Where does a ray first meet a sphere's surface? What it reads and answers: isect grade ray-sphere
# isect grade ray-sphere --plain python3 ray-sphere.py
import sys

for line in sys.stdin:
    x = iter(map(float, line.split()))
    origin = [next(x) for _ in range(3)]
    dir = [next(x) for _ in range(3)]
    center = [next(x) for _ in range(3)]
    radius = next(x)
    # Write the test here.
    print("miss", flush=True)
