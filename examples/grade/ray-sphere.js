// Where does a ray first meet a sphere's surface? What it reads and answers: isect grade ray-sphere
// isect grade ray-sphere --plain node ray-sphere.js
const lines = require('readline').createInterface({input: process.stdin});

lines.on('line', (line) => {
  const x = line.trim().split(/\s+/).map(Number);
  const read = (count) => x.splice(0, count);
  const rows = (count, width) => Array.from({length: count}, () => read(width));
  const origin = read(3);
  const dir = read(3);
  const center = read(3);
  const radius = x.shift();
  // Write the test here.
  console.log('miss');
});
