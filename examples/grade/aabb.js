// Do two axis-aligned boxes share a point? What it reads and answers: isect grade aabb
// isect grade aabb --plain node aabb.js
const lines = require('readline').createInterface({input: process.stdin});

lines.on('line', (line) => {
  const x = line.trim().split(/\s+/).map(Number);
  const read = (count) => x.splice(0, count);
  const rows = (count, width) => Array.from({length: count}, () => read(width));
  const alo = read(3);
  const ahi = read(3);
  const blo = read(3);
  const bhi = read(3);
  // Write the test here.
  console.log('0');
});
