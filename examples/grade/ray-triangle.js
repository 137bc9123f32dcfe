// Where does a ray first meet a triangle? What it reads and answers: isect grade ray-triangle
// isect grade ray-triangle --plain node ray-triangle.js
const lines = require('readline').createInterface({input: process.stdin});

lines.on('line', (line) => {
  const x = line.trim().split(/\s+/).map(Number);
  const read = (count) => x.splice(0, count);
  const rows = (count, width) => Array.from({length: count}, () => read(width));
  const origin = read(3);
  const dir = read(3);
  const tri = rows(3, 3);
  // Write the test here.
  console.log('miss');
});
