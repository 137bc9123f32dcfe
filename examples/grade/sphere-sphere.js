// Do two balls share a point? What it reads and answers: isect grade sphere-sphere
// isect grade sphere-sphere --plain node sphere-sphere.js
const lines = require('readline').createInterface({input: process.stdin});

lines.on('line', (line) => {
  const x = line.trim().split(/\s+/).map(Number);
  const read = (count) => x.splice(0, count);
  const rows = (count, width) => Array.from({length: count}, () => read(width));
  const c1 = read(3);
  const r1 = x.shift();
  const c2 = read(3);
  const r2 = x.shift();
  // Write the test here.
  console.log('0');
});
