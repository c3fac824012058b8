//! Benchmark scenes and criterion benches of trigon.
