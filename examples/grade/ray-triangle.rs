// Where does a ray first meet a triangle? What it reads and answers: isect grade ray-triangle
// rustc -O ray-triangle.rs && isect grade ray-triangle --plain ./ray-triangle
#![allow(unused)]
use std::io::{self, BufRead, Write};

fn read(x: &mut impl Iterator<Item = f64>, count: usize) -> Vec<f64> {
    x.take(count).collect()
}

fn main() {
    for line in io::stdin().lock().lines() {
        let line = line.unwrap();
        let mut x = line.split_whitespace().map(|word| word.parse::<f64>().unwrap());
        let origin = read(&mut x, 3);
        let dir = read(&mut x, 3);
        let tri: Vec<Vec<f64>> = (0..3).map(|_| read(&mut x, 3)).collect();
        // Write the test here.
        println!("miss");
        io::stdout().flush().unwrap();
    }
}
